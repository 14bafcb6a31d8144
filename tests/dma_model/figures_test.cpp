// docs/fidelity.md holds what was published of DMA (hardware.md 2.3, 3, marks V and D) against what
// is simulated.
#include <tests/fidelity/figures_on_page.hpp>

#include "dma_fixture.hpp"

namespace finback::dma {
namespace {

// A machine of its own for one figure.
class DmaBench final : public DmaTest {
 public:
  DmaBench() { build(); }
  void TestBody() override {}

  static constexpr std::uint32_t kCount = 8192;

  // SCLK for an element of a long transfer.
  double element(Address from, Address to, std::uint32_t width) {
    return static_cast<double>(copy(*dma1_, 0, from, to, kCount, width, 0)) / kSclk / kCount;
  }
  // Both streams from L1 to L2, or the first alone: SCLK for a word of either.
  double in_turns(std::uint32_t period, bool both) {
    constexpr std::uint32_t kRoundRobin = 11;
    dma1_->write(DmaController::kTrafficPeriods, 2, period << kRoundRobin, 0);
    for (const std::uint32_t stream : {0U, 1U}) {
      program(*dma1_, 0x80 * stream + kS0, stream == 0 ? kL1A : kL1B, kCount, 4);
      program(*dma1_, 0x80 * stream + kD0, kL2 + 0x10000 * stream, kCount, 4);
      if (stream == 0 || both) {
        enable(*dma1_, stream, kBits32, 0);
      }
    }
    return static_cast<double>(finish(*dma1_)) / kSclk / kCount / (both ? 2 : 1);
  }
  // Percent that turns of `period` words take from a stream that runs alone.
  static double lost_alone(std::uint32_t period) {
    return 100 * (1 - DmaBench().in_turns(0, false) / DmaBench().in_turns(period, false));
  }
  // MB/s into SDRAM of two cameras of 160 x 120 pixels of two bytes, 20 frames a second.
  double cameras() {
    constexpr std::uint32_t kFrameBytes = 160 * 120 * 2;
    constexpr Cycles kFrame = 600'000'000 / 20;
    const std::vector<std::uint8_t> line(32);
    constexpr Cycles kChunks = kFrameBytes / 32;
    for (const std::uint32_t channel : {kPpi0, kPpi1}) {
      program(*dma1_, channel, channel == kPpi0 ? kL3 : kL3 + 0x100000, kFrameBytes / 4, 4);
      dma1_->write(channel + kConfig, 2, kEnable | kWriteMemory | kBits32 | kAutobuffer, 0);
    }
    for (Cycles chunk = 1; chunk <= kChunks; ++chunk) {
      const Cycles now = chunk * kFrame / kChunks;
      dma1_->advance(now);
      dma1_->port(0).push(line, now);
      dma1_->port(1).push(line, now);
    }
    dma1_->advance(kFrame + 1000);
    Bytes moved = 0;
    for (const memory::Initiator camera : {memory::Initiator::ppi0, memory::Initiator::ppi1}) {
      moved += memory_->level_traffic(memory::Level::l3, camera, memory::Direction::write).bytes;
    }
    return static_cast<double>(moved) * 20 / 1e6;
  }
  // The highest CCLK, in steps of 25 MHz, at which a stream of IMDMA starts.
  double fastest_imdma() {
    double fastest = 0;
    for (double mhz = 400; mhz <= 600; mhz += 25) {
      clock_.cclk_mhz.set(mhz);
      clock_.sclk_mhz.set(mhz / 5);
      build();
      DmaController imdma(Controller::imdma, parameters_, clock_, *memory_,
                          {.stream_0 = 57, .error = 3}, [](int, bool, Cycles) {});
      try {
        imdma.write(0x40 + kConfig, 2, kEnable | kBits32, 0);
        fastest = mhz;
      } catch (const GuestFault&) {
        break;
      }
    }
    return fastest;
  }
};

std::vector<PublishedFigure> dma_figures() {
  constexpr double kMegabytesPerSecond = 4 * 120;  // a word of 32 bits a SCLK
  return {
      {"memory DMA, SDRAM to L1, each 32-bit word", 1, "SCLK", "V 3.2",
       [] { return DmaBench().element(kL3, kL1A, kBits32); }},
      {"memory DMA, L1 to SDRAM, each 32-bit word", 1, "SCLK", "V 3.2",
       [] { return DmaBench().element(kL1A, kL3, kBits32); }},
      {"memory DMA, SDRAM to L1, each 16-bit word", 1, "SCLK", "V 3.2",
       [] { return DmaBench().element(kL3, kL1A, kBits16); }},
      {"memory DMA, SDRAM to L1, each byte", 1, "SCLK", "D 3.2",
       [] { return DmaBench().element(kL3, kL1A, kBits8); }},
      {"memory DMA, SDRAM to L1, 32-bit words", 480, "MB/s", "D 3.2",
       [=] { return kMegabytesPerSecond / DmaBench().element(kL3, kL1A, kBits32); }},
      {"memory DMA, L2 to L1, each word: L2's DMA port has 32 bits at SCLK", 1, "SCLK", "V 2.3",
       [] { return DmaBench().element(kL2, kL1A, kBits32); }},
      {"memory DMA within a core's L1, each word", 2, "SCLK", "D 3.2",
       [] { return DmaBench().element(kL1A, kL1A2, kBits32); }, true},
      {"memory DMA within SDRAM, each word", 2, "SCLK", "D 3.2",
       [] { return DmaBench().element(kL3, kL3 + 0x1000000, kBits32); }, true},
      {"both streams of memory DMA in turns of 16 words, each word", 1, "SCLK", "V 3.2",
       [] { return DmaBench().in_turns(16, true); }},
      {"turns of 16 words, lost by a stream that runs alone", 100.0 / 17, "%", "V 3.2",
       [] { return DmaBench::lost_alone(16); }},
      {"turns of 8 words, lost by a stream that runs alone", 100.0 / 9, "%", "V 3.2",
       [] { return DmaBench::lost_alone(8); }},
      {"highest core clock of IMDMA", 500, "MHz", "V 3.2",
       [] { return DmaBench().fastest_imdma(); }},
      {"two cameras of 160 x 120 pixels, 20 frames a second", 1.5, "MB/s", "D 3.3",
       [] { return DmaBench().cameras(); }},
  };
}

TEST(PublishedDma, StandsOnThePageAsItIsSimulated) { expect_on_page(dma_figures()); }

TEST(PublishedDma, IsMetThroughout) { EXPECT_THAT(not_met(dma_figures()), testing::IsEmpty()); }

}  // namespace
}  // namespace finback::dma
