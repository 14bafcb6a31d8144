// CDPRIO on the whole machine: a core's reads of SDRAM, cached and not, beside memory DMA.
#include "guest_program.hpp"
#include <memory_model/memory_system.hpp>

namespace finback::machine {
namespace {

constexpr Address kAmgctl = 0xFFC00A00;
constexpr Address kDestination = 0xFFC01F00, kSource = 0xFFC01F40;
constexpr std::uint32_t kReads = 1000;

// Autobuffer from SDRAM to L2, then reads of another row, then the end.
std::string program(std::uint32_t global) {
  return store(kAmgctl, global, 2) + store(kSource + 4, 0x100000) +
         store(kDestination + 4, 0xFEB00000) + store(kSource + 0x10, 0x1000, 2) +
         store(kDestination + 0x10, 0x1000, 2) + store(kSource + 0x14, 4, 2) +
         store(kDestination + 0x14, 4, 2) + store(kSource + 8, 0x1009, 2) +
         store(kDestination + 8, 0x100B, 2) +
         fmt::format(
             "P2.L = 0; P2.H = 0x20; P1 = {} (X); LSETUP (.Lread, .Lread) LC0 = P1;\n"
             ".Lread: R3 = [P2++];\nHLT;",
             kReads);
}

class CdprioTest : public GuestProgramTest {
 protected:
  struct Share {
    Cycles time = 0;
    Bytes moved = 0;  // by DMA
    Cycles stalls = 0;
    [[nodiscard]] double rate() const {
      return static_cast<double>(moved) / static_cast<double>(time);
    }
  };
  Share share(std::uint32_t global) {
    load(program(global));
    const StopInfo stop = run();
    EXPECT_EQ(stop.reason, Stop::exited) << stop.message;
    const auto traffic = [&](memory::Initiator who) {
      return machine_->memory().level_traffic(memory::Level::l3, who, memory::Direction::read);
    };
    EXPECT_EQ(traffic(memory::Initiator::core_a).bytes, 4 * kReads);
    return {stop.time, traffic(memory::Initiator::mdma1_0).bytes,
            traffic(memory::Initiator::core_a).stall_cycles};
  }
};

TEST_F(CdprioTest, SetItLetsDmaGoFirst) {
  const Share cores_first = share(0x00F2);
  const Share dma_first = share(0x01F2);
  EXPECT_GT(dma_first.time, cores_first.time * 5 / 4);
  EXPECT_GT(dma_first.rate(), cores_first.rate() * 1.1);
  // What the core loses is known, to the cycle, to whom it was lost.
  EXPECT_GE(dma_first.stalls - cores_first.stalls, (dma_first.time - cores_first.time) * 95 / 100);
}

TEST_F(CdprioTest, ResultsAndBytesDoNotDependOnIt) {
  load(program(0x00F2));
  run();
  const std::uint32_t last = machine_->state(CoreId::a).reg[isa::R3];
  load(program(0x01F2));
  run();
  EXPECT_EQ(machine_->state(CoreId::a).reg[isa::R3], last);
}

TEST_F(CdprioTest, LineFillsGiveWayToo) {
  description_.memory.cache_data_banks.set(1);
  description_.memory.cache_l3_policy.set(1);
  const auto time = [&](std::uint32_t global) {
    load(program(global));
    return run().time;
  };
  EXPECT_GT(time(0x01F2), time(0x00F2) * 5 / 4);
}

}  // namespace
}  // namespace finback::machine
