// IMDMA: between L1 and L2, at the core clock, on slow parts only.
#include "dma_fixture.hpp"

namespace finback::dma {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::uint32_t kDestination = 0x00, kSource = 0x40;

class ImdmaTest : public DmaTest {
 protected:
  void SetUp() override { at_clock(500, 100); }

  void at_clock(double cclk_mhz, double sclk_mhz) {
    clock_.cclk_mhz.set(cclk_mhz);
    clock_.sclk_mhz.set(sclk_mhz);
    build();
    imdma_ = std::make_unique<DmaController>(Controller::imdma, parameters_, clock_, *memory_,
                                             DmaController::Sources{.stream_0 = 57, .error = 3},
                                             [this](int source, bool level, Cycles at) {
                                               lines_.push_back({source, level, at});
                                             });
  }
  // Returns the cycles from CONFIG to the last word.
  Cycles move(Address from, Address to, std::uint32_t words) {
    program(*imdma_, kSource, from, words, 4);
    program(*imdma_, kDestination, to, words, 4);
    imdma_->write(kSource + kConfig, 2, kBits32 | kEnable, 0);
    imdma_->write(kDestination + kConfig, 2, kBits32 | kEnable | kWriteMemory | kInterruptEnable,
                  0);
    return finish(*imdma_);
  }
  std::unique_ptr<DmaController> imdma_;
};

// Start-up 20; then every burst 6 + 16 * 3 at either end, the reads hidden behind the writes.
constexpr Cycles by_formula(Cycles bursts) { return 20 + 54 * (bursts + 1); }

TEST_F(ImdmaTest, MovesAWordInThreeCyclesAndInterrupts) {
  for (const auto& [from, to] :
       {std::pair{kL2, kL1A}, std::pair{kL1A, kL2}, std::pair{kL1A, kL1B}}) {
    for (const Cycles bursts : {1U, 2U, 50U}) {
      at_clock(500, 100);
      const auto bytes = pattern(64 * bursts);
      memory_->store_bytes(from, bytes);
      EXPECT_EQ(move(from, to, static_cast<std::uint32_t>(16 * bursts)), by_formula(bursts));
      EXPECT_EQ(bytes_at(to, static_cast<std::uint32_t>(64 * bursts)), bytes);
      EXPECT_EQ(lines_, (std::vector<LineChange>{{57, true, by_formula(bursts)}}));
    }
  }
}

TEST_F(ImdmaTest, AtEqualClocksItIsNoneOfTheSystemClocksBusiness) {
  at_clock(500, 50);
  EXPECT_EQ(move(kL2, kL1A, 160), by_formula(10));
}

TEST_F(ImdmaTest, ParametersAreFeltToTheCycle) {
  const Cycles before = move(kL2, kL1A, 160);
  const auto with = [&](IntegerParameter& parameter, int more) {
    parameter.set(static_cast<double>(parameter + more));
    at_clock(500, 100);
    const Cycles after = move(kL2, kL1A, 160);
    parameter.set(static_cast<double>(parameter - more));
    return after - before;
  };
  EXPECT_EQ(with(parameters_.imdma_startup_cycles, 1), 1U);
  EXPECT_EQ(with(memory_parameters_.imdma_word_cycles, 1), 11 * 16U);
  EXPECT_EQ(with(memory_parameters_.imdma_overhead_cycles, 1), 11U);
}

TEST_F(ImdmaTest, HoldsTheCoresPortOfL2ForItsBurst) {
  program(*imdma_, kSource, kL2, 160, 4);
  program(*imdma_, kDestination, kL1A, 160, 4);
  imdma_->write(kSource + kConfig, 2, kBits32 | kEnable, 0);
  imdma_->write(kDestination + kConfig, 2, kBits32 | kEnable | kWriteMemory, 0);
  imdma_->advance(20);
  memory::Span* span = memory_->find_span(0, kL2);
  // The burst ends at 74; then the other one's turn costs 2, and the read 9.
  EXPECT_EQ(memory_->core_read(0, span, kL2, 4, 30), 74 + 2 + 9 - 30 - 1);
}

TEST_F(ImdmaTest, KeepsToL1AndL2AndToSlowClocks) {
  EXPECT_THAT([&] { move(kL3, kL1A, 16); },
              ThrowsMessage<GuestFault>(HasSubstr(
                  "IMDMA_S0_CURR_ADDR = 0x00010000: IMDMA reaches L1 and L2 only; use MDMA1")));
  at_clock(600, 120);
  imdma_->write(kSource + kXCount, 2, 77, 0);
  EXPECT_EQ(imdma_->read(kSource + kXCount, 2, 0), 77U);
  EXPECT_THAT([&] { imdma_->write(kSource + kConfig, 2, kEnable, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("anomaly 05000182")));
  EXPECT_EQ(imdma_->find_register(kPeripheralMap), nullptr);
  EXPECT_EQ(imdma_->register_name(kSource + kConfig), "IMDMA_S0_CONFIG");
}

}  // namespace
}  // namespace finback::dma
