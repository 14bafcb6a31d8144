// The instruction cache as a program meets it, and fetches outside L1.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core_harness.hpp"
#include <isa_sim/ir/placement.hpp>

namespace finback::core {
namespace {

// A core whose code lies in L2 or L3.
class FarCode : public SystemPort {
 public:
  explicit FarCode(const std::string& text, const std::string& region = "l2") {
    ir::Program program = ir::parse(".bir 1\n" + text, "test.bir");
    ir::verify(program);
    ir::Firmware firmware = ir::bare_firmware(std::move(program));
    firmware.placement =
        ir::parse_placement("[core_a]\ncode = [\"" + region + "\"]\n", "test.toml");
    image_ = ir::link(firmware.units, firmware.placement, memory::bf561_map());
  }
  // Cycles without IDLE's.
  Cycles run() {
    memory_ = std::make_unique<memory::MemorySystem>(memory::bf561_map(), memory_parameters, clock_,
                                                     std::vector<memory::ObjectPlace>{});
    core_ = std::make_unique<Core>(CoreId::a, image_.cores[0], parameters_, 1, *memory_, *this);
    core_->start(0);
    while (!core_->sleeping()) {
      core_->run({});
    }
    return core_->profile().cycles;
  }
  [[nodiscard]] Cycles stalls(Cause cause) {
    return core_->profile().causes[static_cast<std::size_t>(cause)];
  }
  [[nodiscard]] std::uint64_t counter(const std::string& name) {
    CounterRegistry registry;
    memory_->register_counters(registry);
    return registry.snapshot().at(name).value;
  }
  [[nodiscard]] std::uint32_t reg(isa::Register reg) { return core_->state().reg[reg]; }

  Read device_read(int, Address, int, Cycles) override { return {}; }
  Cycles device_write(int, Address, int, std::uint32_t, Cycles) override { return 0; }
  [[nodiscard]] Cycles device_writes_drained_at(int) const override { return 0; }
  void print(int, std::string_view) override {}
  void halt(int, std::uint32_t, const std::string&, Cycles) override {}
  HostCall host_call(int, isa::ExecutionState&, Cycles) override { return HostCall::none; }

  memory::MemoryParameters memory_parameters;

 private:
  CoreParameters parameters_;
  memory::ClockParameters clock_;
  ir::Image image_;
  std::unique_ptr<memory::MemorySystem> memory_;
  std::unique_ptr<Core> core_;
};

// 64 bytes of straight code, of which the last begins in the last eight: 8 fetches, 2 lines.
std::string straight() {
  std::string body = ".text\n.global _start\n.type _start, @function\n.align 32\n_start:\n";
  for (int i = 0; i < 30; ++i) {
    body += "NOP; ";
  }
  return body + "\nIDLE;\nRTS;\n.size _start, .-_start\n";
}

// A loop of 40 NOPs, 80 bytes and a few around it.
std::string loop(const std::string& before = "") {
  std::string body = ".text\n.global _start\n.type _start, @function\n.align 32\n_start:\n" +
                     before + "P1 = 100; LSETUP (.Ltop, .Lend) LC0 = P1;\n.Ltop: NOP;\n";
  for (int i = 0; i < 38; ++i) {
    body += "NOP; ";
  }
  return body + ".Lend: NOP;\nIDLE;\nRTS;\n.size _start, .-_start\n";
}

TEST(FetchFromL2, TakesAReadAFetch) {
  FarCode code(straight());
  EXPECT_EQ(code.run(), 31U + 8 * 8);
  EXPECT_EQ(code.stalls(Cause::fetch), 8U * 8);
}

TEST(CodeCacheOnACore, FetchesALineOnce) {
  FarCode code(straight());
  code.memory_parameters.cache_code.set(1);
  code.run();
  // The first eight bytes after 9 cycles; the others of the line 2 apart, while 4 NOPs pass.
  EXPECT_EQ(code.stalls(Cause::code_cache), 2U * 8);
  EXPECT_EQ(code.stalls(Cause::fetch), 0U);
  EXPECT_EQ(code.counter("core_a.code_cache.miss.accesses"), 2U);
  EXPECT_EQ(code.counter("core_a.code_cache.hit.accesses"), 6U);
}

TEST(CodeCacheOnACore, LoopsRunFromIt) {
  FarCode uncached(loop());
  FarCode cached(loop());
  cached.memory_parameters.cache_code.set(1);
  EXPECT_GT(uncached.run(), 100U * (40 + 10 * 8));
  EXPECT_LT(cached.run(), 100U * 40 + 100);
}

// What the packets wait for is decided where they run: words of the line come 5 cycles a word.
TEST(CodeCacheOnACore, FetchesBehindAMissWaitForTheirWords) {
  FarCode code(straight(), "l3");
  code.memory_parameters.cache_code.set(1);
  code.run();
  // First 64 bits of a row to be opened: (3 + 8 + 1) SCLK - 1; then 10 cycles for four NOPs.
  const Cycles line = 18;  // three times 10 less the 4 of the NOPs
  EXPECT_EQ(code.stalls(Cause::code_cache), 59 + line + 44 + line);
}

constexpr const char* kEnable =
    "P0.L = 0x1100; P0.H = 0xFFE0; R0.L = 0; R0.H = 0xFEB0; [P0] = R0;"    // L2 ...
    "P0.L = 0x1200; P0.H = 0xFFE0; R0.L = 0x1001; R0.H = 0x2; [P0] = R0;"  // 1 MB, cacheable
    "P0.L = 0x1004; P0.H = 0xFFE0; R0 = 6 (X); [P0] = R0; SSYNC;";         // IMC, ENICPLB

TEST(CodeCacheOnACore, IsTurnedOnByRegisters) {
  FarCode code(loop(kEnable));
  EXPECT_LT(code.run(), 100U * 40 + 1000);
  EXPECT_GT(code.counter("core_a.code_cache.hit.accesses"), 900U);
}

TEST(CodeCacheOnACore, IflushForgetsALine) {
  const std::string flush =
      "P2.L = .Ltop; P2.H = .Ltop; P1 = 10; LSETUP (.Ltop, .Lend) LC0 = P1;"
      ".Ltop: NOP; NOP; NOP; .Lend: ";
  const auto misses = [&](const char* last) {
    FarCode code(".text\n.global _start\n.type _start, @function\n.align 32\n_start:\n" + flush +
                 last + " IDLE;\nRTS;\n.size _start, .-_start\n");
    code.memory_parameters.cache_code.set(1);
    code.run();
    return code.counter("core_a.code_cache.miss.accesses");
  };
  EXPECT_EQ(misses("IFLUSH [P2];"), misses("NOP;") + 10);
}

TEST(CodeCacheOnACore, CodeInTheHalfStandsInTheWay) {
  FarCode code(straight(), "l1.code.cache");
  code.memory_parameters.cache_code.set(1);
  try {
    code.run();
    FAIL() << "accepted";
  } catch (const GuestFault& fault) {
    EXPECT_THAT(fault.what(), testing::HasSubstr("but start lies there"));
  }
}

}  // namespace
}  // namespace finback::core
