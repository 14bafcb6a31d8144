// docs/fidelity.md holds what was published of single instructions and accesses (hardware.md,
// sections 1, 2 and 4, marks V and D) against what is simulated, with nobody else about.
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tests/fidelity/figures_on_page.hpp>

#include "core_harness.hpp"

namespace finback::core {
namespace {

using Figure = PublishedFigure;

// ---- instructions ----

constexpr const char* kSetUp =
    "P0.L = _buffer; P0.H = _buffer; I0 = P0; P5 = P0; P3 = P0; P3 += 4; I1 = P3; R0 = 0 (X); R1 = "
    "0 (X); CC = R0 == 0;"
    "R7 = 0x80 (X); P1 = 2; NOP; NOP; NOP; NOP; NOP;\n";

double cycles(const std::string& body) {
  CoreHarness harness(".text\n.global _start\n.type _start, @function\n.align 8\n_start:\n" +
                      std::string(kSetUp) + body + "\nIDLE;\nRTS;\n.size _start, .-_start\n" +
                      kBuffer);
  return static_cast<double>(harness.run());
}
// Of `body` beside `without`.
Figure instruction(const std::string& what, double published, const char* source,
                   const std::string& body, const std::string& without = "") {
  return {what, published, "CCLK", source, [=] { return cycles(body) - cycles(without); }};
}

// From the last cycle counter that a handler reads in R6 to the first that is read behind it in R7,
// with nothing but the return between: `raise` leads to vector `event`.
Figure way_back(const std::string& what, const char* source, int event, const std::string& raise,
                const std::string& back) {
  return {what, 5, "CCLK", source, [=] {
            CoreHarness harness(program(
                fmt::format("P1.L = {:#x}; P1.H = 0xFFE0; R1.L = .Lhandler; R1.H = .Lhandler; "
                            "[P1] = R1; R1.L = 0x4000; R1.H = 0; STI R1; {} R7 = CYCLES; "
                            "JUMP.S .Lend; .Lhandler: R6 = CYCLES; {}; .Lend: NOP;",
                            0x2000 + 4 * event, raise, back)));
            harness.run();
            return static_cast<double>(harness.reg(isa::R7) - harness.reg(isa::R6) - 1);
          }};
}
// The instruction alone: less an entry of one cycle.
double exception_instruction() {
  CoreHarness harness(
      program("P1.L = 0x200C; P1.H = 0xFFE0; R1.L = .Lhandler; R1.H = .Lhandler; [P1] = R1; "
              "R7 = CYCLES; EXCPT 5; .Lhandler: R6 = CYCLES; NOP;"));
  harness.set("core.interrupt.entry_cycles", 1);
  harness.run();
  return static_cast<double>(harness.reg(isa::R6) - harness.reg(isa::R7) - 2);
}
double wake_from_idle() {
  CoreHarness harness(program("R1.L = 0x8000; R1.H = 0; STI R1; IDLE; NOP; HLT;"));
  harness.run();
  constexpr Cycles kWakeUp = 1000;
  harness.core().set_requests(0, true, kWakeUp);
  harness.core().run({});
  return static_cast<double>(harness.core().profile().cycles - kWakeUp - 2);  // NOP and HLT
}

// ---- accesses ----

class Memory {
 public:
  explicit Memory(int bus_bytes = 4) {
    parameters_.sdram_bus_bytes.set(bus_bytes);
    parameters_.sdram_page_bytes.set(512 * bus_bytes);
    build();
  }
  // Cycles of one access, its own included, when `count` of `bytes` follow each other `apart`.
  double each(bool write, int bytes, Address apart, int count = 20'000) {
    Cycles now = 0;
    for (int i = 0; i < count; ++i) {
      const Address address = static_cast<Address>(i) * apart % 0x2000000;
      memory::Span* span = system_->find_span(0, address);
      now += 1 + (write ? system_->core_write(0, span, address, bytes, now)
                        : system_->core_read(0, span, address, bytes, now));
    }
    return static_cast<double>(now) / count;
  }
  double cached(int bytes, Address apart, int count = 20'000) {
    system_->configure_data_cache(0, 1, false, {}, 0);
    Cycles now = 0;
    for (int i = 0; i < count; ++i) {
      const Address address = static_cast<Address>(i) * apart % 0x2000000;
      now += 1 + system_
                     ->cached_access(0, system_->find_span(0, address), address, bytes, false,
                                     memory::CachePolicy::write_through, 0, now)
                     .stall;
    }
    return static_cast<double>(now) / count;
  }
  // Beside a refresh: the second of two accesses.
  double second(Address first, Address address, int bytes) {
    system_->core_read(0, system_->find_span(0, first), first, bytes, 0);
    return 1.0 + static_cast<double>(
                     system_->core_read(0, system_->find_span(0, address), address, bytes, 1000));
  }
  double line() {
    system_->configure_data_cache(0, 1, false, {}, 0);
    load(0, 0);  // opens the row
    const Cycles first = 1000 + load(32, 1000) + 1;
    return static_cast<double>(first + load(60, first) + 1 - 1000);
  }
  // SCLK for a word of a long stream of DMA.
  double dma_word(std::uint32_t element_bytes, Address base) {
    constexpr int kBursts = 500;
    Cycles now = 0;
    for (Address i = 0; i < kBursts; ++i) {
      const memory::DmaRun run{.address = base + i * 16 * element_bytes,
                               .stride = static_cast<std::int32_t>(element_bytes),
                               .count = 16};
      now = system_->dma_burst(memory::Initiator::mdma1_0, memory::Direction::read, {&run, 1},
                               element_bytes, now, now, i > 0);
    }
    return static_cast<double>(now) / 5 / kBursts / 16;
  }
  // CCLK from the load that misses a line of L2 to its last 64 bits, less that to its first.
  double rest_of_an_l2_line() {
    system_->configure_data_cache(0, 1, false, {}, 0);
    const Cycles first = 1000 + load(kL2Base, 1000);
    return static_cast<double>(first + 1 + load(kL2Base + 24, first + 1) - first);
  }
  // Lines as far apart as can be that a cache keeps: `load` returns whether an address was there.
  template <class Load>
  static double ways(const Load& load) {
    constexpr Address kApart = 0x10000;
    for (Address count = 1;; ++count) {
      bool kept = true;
      for (Address i = 0; i < 2 * count; ++i) {
        const bool hit = load(count * 0x100 + i % count * kApart);
        kept = kept && (hit || i < count);
      }
      if (!kept) {
        return count - 1;
      }
    }
  }
  double data_ways() {
    system_->configure_data_cache(0, 1, false, {}, 0);
    return ways([&](Address address) { return load(address, now_ += 1000) == 0; });
  }
  double code_ways() {
    system_->configure_code_cache(0, true, 0);
    return ways([&](Address address) { return fetch(address, now_ += 1000) == 0; });
  }
  // Bytes that come with one miss.
  double data_line() {
    system_->configure_data_cache(0, 1, false, {}, 0);
    int misses = 0;
    for (Address at = 0; at < 4096; at += 4) {
      misses += load(at, now_ += 1000) == 0 ? 0 : 1;
    }
    return 4096.0 / misses;
  }
  // Rows that are still open when one was opened in each of many places.
  double open_rows() {
    constexpr Address kPlaces = 16;
    parameters_.sdram_refresh_sclk.set(0);
    build();
    std::uint64_t hits = 0;
    for (Address i = 0; i < 2 * kPlaces; ++i) {
      const std::uint64_t before = system_->sdram().counters().row_hits;
      each_at((i < kPlaces ? i : 2 * kPlaces - 1 - i) * 0x400000);
      hits += i < kPlaces ? 0 : system_->sdram().counters().row_hits - before;
    }
    return static_cast<double>(hits);
  }
  // SCLK from a write that opens a row to one that opens another there, at the earliest.
  double row_cycle() {
    const auto arrival = [&](Address address) {
      system_->core_write(0, system_->find_span(0, address), address, 4, 0);
      return system_->writes_drained_at(0);
    };
    const Cycles first = arrival(0);
    return static_cast<double>(arrival(0x4000) - first) / 5;
  }
  // Microseconds from one refresh to the next, and what of that they take, in percent.
  double between_refreshes() {
    constexpr Cycles kEnd = 60'000'000;
    each_at(0, kEnd);
    return 1e6 * kEnd / 600e6 / static_cast<double>(system_->sdram().counters().refreshes);
  }
  static double refresh_share() {
    constexpr Cycles kFirst = 4687;  // when it is due
    Memory without;
    without.parameters_.sdram_refresh_sclk.set(0);
    without.build();
    const double one = Memory().each_at(0, kFirst) - without.each_at(0, kFirst);
    return 100 * one / 600 / Memory().between_refreshes();
  }
  double flash_word() {
    system_->asynchronous().set_banks(0, 0xFFC27BB0);
    return dma_word(2, 0x20000000);
  }

 private:
  static constexpr Address kL2Base = 0xFEB00000;

  void build() {
    system_ = std::make_unique<memory::MemorySystem>(memory::bf561_map(), parameters_, clock_,
                                                     std::vector<memory::ObjectPlace>{});
  }
  // A load through the data cache, a fetch through the code cache: their stalls.
  Cycles load(Address address, Cycles now) {
    return system_
        ->cached_access(0, system_->find_span(0, address), address, 4, false,
                        memory::CachePolicy::write_back, 0, now)
        .stall;
  }
  Cycles fetch(Address address, Cycles now) {
    return system_->cached_fetch(0, memory::Level::l3, address, 8, false, now);
  }
  // An uncached read: its stall.
  double each_at(Address address, Cycles now = 0) {
    return static_cast<double>(
        system_->core_read(0, system_->find_span(0, address), address, 4, now));
  }

  Cycles now_ = 0;
  memory::MemoryParameters parameters_;
  memory::ClockParameters clock_;
  std::unique_ptr<memory::MemorySystem> system_;
};

std::vector<Figure> instructions() {
  return {
      instruction("IF CC JUMP, not taken, as predicted", 1, "V 1.4", "IF !CC JUMP .Lx; .Lx: NOP;",
                  "NOP;"),
      instruction("IF CC JUMP (BP), taken, as predicted", 5, "V 1.4",
                  "IF CC JUMP .Lx (BP); NOP; .Lx: NOP;", "NOP;"),
      instruction("IF CC JUMP, wrongly predicted", 9, "V 1.4", "IF CC JUMP .Lx; NOP; .Lx: NOP;",
                  "NOP;"),
      instruction("JUMP.S", 5, "V 1.4", "JUMP.S .Lx; .Lx: NOP;", "NOP;"),
      instruction("CALL and RTS", 10, "V 1.4", "CALL .Lx; JUMP.S .Ly; .Lx: RTS; .Ly: NOP;",
                  "JUMP.S .Ly; .Ly: NOP;"),
      instruction("IF CC JUMP (BP), not taken, wrongly predicted", 9, "V 1.4",
                  "IF !CC JUMP .Lx (BP); .Lx: NOP;", "NOP;"),
      instruction("JUMP.L", 5, "V 1.4", "JUMP.L .Lx; .Lx: NOP;", "NOP;"),
      instruction("JUMP (P2)", 5, "V 1.4",
                  "P2.L = .Lx; P2.H = .Lx; NOP; NOP; NOP; NOP; JUMP (P2); .Lx: NOP;",
                  "P2.L = .Lx; P2.H = .Lx; NOP; NOP; NOP; NOP; .Lx: NOP;"),
      instruction("CALL (P2) and RTS", 10, "V 1.4",
                  "P2.L = .Lx; P2.H = .Lx; NOP; NOP; NOP; NOP; CALL (P2); JUMP.S .Ly; .Lx: RTS; "
                  ".Ly: NOP;",
                  "P2.L = .Lx; P2.H = .Lx; NOP; NOP; NOP; NOP; JUMP.S .Ly; .Lx: .Ly: NOP;"),
      way_back("RTI", "V 1.4", 14, "RAISE 14;", "RTI"),
      way_back("RTX", "V 1.4", 3, "EXCPT 5;", "RTX"),
      instruction("IF CC R1 = R0", 1, "V 1.4", "IF CC R1 = R0;"),
      instruction("LSETUP", 1, "V 1.4", "LSETUP (.Lx, .Lx) LC0 = P1; .Lx: NOP;", "NOP; NOP;"),
      instruction("load of a P register, then its use as an address", 3, "V 1.5",
                  "P2 = [P0]; P3 = P2 + P0;", "P2 = [P0]; NOP;"),
      instruction("load, then its use by the ALU", 0, "D 1.5", "R2 = [P0]; R3 = R2 + R0;",
                  "R2 = [P0]; NOP;"),
      instruction("move to a P register, then its use as an address", 4, "V 1.5",
                  "P2 = R0; P3 = P2 + P0;", "P2 = R0; NOP;"),
      instruction("move of an I to a P register, then its use as an address", 0, "D 1.5",
                  "P2 = I0; R2 = [P2];", "P2 = I0; NOP;"),
      instruction("CC set, then IF CC JUMP (BP), beside CC set before", 0, "D 1.5",
                  "CC = R0 == 0; IF CC JUMP .Lx (BP); NOP; .Lx: NOP;",
                  "NOP; IF CC JUMP .Lx (BP); NOP; .Lx: NOP;"),
      instruction("ALU, then ALU with its result", 0, "D 1.5", "R2 = R0 + R1; R3 = R2 + R1;",
                  "R2 = R0 + R1; NOP;"),
      instruction("MAC, then MAC to the same accumulator", 0, "D 1.5",
                  "A0 += R0.L * R1.L; A0 += R0.L * R1.L;", "A0 += R0.L * R1.L; NOP;"),
      instruction("accumulator to a half, then its store", 0, "D 1.5", "R2.L = A0; W[P0] = R2;",
                  "R2.L = A0; NOP;"),
      instruction("load, then MAC with it", 0, "D 1.5", "R2 = [P0]; A0 += R2.L * R1.L;",
                  "R2 = [P0]; NOP;"),
      instruction("I stepped, then its use as an address", 0, "D 1.5", "R2 = [I0++]; R3 = [I0];",
                  "R2 = [I0++]; NOP;"),
      instruction("P stepped, then its use as an address", 0, "D 1.5", "R2 = [P0++]; R3 = [P0];",
                  "R2 = [P0++]; NOP;"),
      instruction("R1 *= R0", 3, "V 1.6", "R1 *= R0;"),
      instruction("A0 += R0.L * R1.L", 1, "V 1.6", "A0 += R0.L * R1.L;"),
      instruction("two MACs with two loads", 1, "V 1.6",
                  "A1 += R0.H * R1.H, A0 += R0.L * R1.L || R0 = [I0++] || R2 = [I1++];"),
      instruction("push of 14 registers", 14, "V 1.6", "[--SP] = (R7:0, P5:0);"),
      instruction("pop of 11 registers", 11, "V 1.6", "SP += -44; (R7:0, P5:3) = [SP++];",
                  "SP += -44;"),
      instruction("LINK and UNLINK", 5, "V 1.6", "LINK 8; UNLINK;"),
      instruction("CSYNC", 10, "V 1.6", "CSYNC;"),
      instruction("SSYNC, nothing pending", 10, "V 1.6", "SSYNC;"),
      instruction("STI", 3, "V 1.6", "STI R0;"),
      instruction("RAISE, masked", 3, "V 1.6", "CLI R2; RAISE 9;", "CLI R2;"),
      {"EXCPT, beside the entry", 3, "CCLK", "V 1.6", exception_instruction},
      instruction("CLI", 1, "V 1.6", "CLI R2;"),
      instruction("TESTSET, beside its accesses", 2, "V 1.6", "TESTSET (P0);"),
      {"wake from IDLE", 10, "CCLK", "V 1.6", wake_from_idle},
      instruction("DIVS", 1, "V 1.6", "DIVS (R0, R1);"),
      instruction("DIVQ", 1, "V 1.6", "DIVQ (R0, R1);"),
      instruction("ONES", 1, "V 1.6", "R2.L = ONES R1;", ""),
      instruction("SAA with two loads", 1, "V 1.6",
                  "SAA (R1:0, R3:2) || R0 = [I0++] || R2 = [I1++];", ""),
      instruction("BYTEOP16P with two loads", 1, "V 1.6",
                  "(R7, R6) = BYTEOP16P (R1:0, R3:2) || R0 = [I0++] || R2 = [I1++];"),
      instruction("load from L1", 1, "V 2.2", "R2 = [P0];"),
      instruction("two loads from one sub-bank, of words that differ in address bit 2", 1, "V 2.2",
                  "MNOP || R2 = [P0] || R3 = [I1];"),
  };
}

std::vector<Figure> accesses() {
  return {
      {"core's read, 32-bit bus, up to 32 bits", 8, "SCLK", "D 2.4",
       [] { return Memory().second(0, 4, 4) / 5; }},
      {"core's read, 16-bit bus, 16 bits", 8, "SCLK", "V 2.4",
       [] { return Memory(2).second(0, 4, 2) / 5; }},
      {"core's read, 16-bit bus, 32 bits", 9, "SCLK", "V 2.4",
       [] { return Memory(2).second(0, 4, 4) / 5; }},
      {"16-bit reads in a row, 16-bit bus, each", 40.4, "CCLK", "V 2.4",
       [] { return Memory(2).each(false, 2, 2); }},
      {"two 16-bit reads, a row changed for each", 141.5, "CCLK", "V 2.4",
       [] { return 2 * Memory(2).each(false, 2, 1024); }},
      {"row miss, read, beside a hit", 30, "CCLK", "D 2.4",
       [] { return Memory().second(0, 2048, 4) - Memory().second(0, 4, 4); }},
      {"line fill, 32-bit bus", 75, "CCLK", "D 2.4", [] { return Memory().line(); }},
      {"cached 16-bit reads in a row, 16-bit bus, a line", 123, "CCLK", "V 2.4",
       [] { return 16 * Memory(2).cached(2, 2); }},
      {"16-bit writes in a row, 16-bit bus, each", 5.2, "CCLK", "V 2.4",
       [] { return Memory(2).each(true, 2, 2); }},
      {"16-bit writes, a row changed every time, each", 45.7, "CCLK", "V 2.4",
       [] { return Memory(2).each(true, 2, 1024); }},
      {"DMA of 16-bit words, 16-bit bus, each", 1, "SCLK", "V 2.4",
       [] { return Memory(2).dma_word(2, 0); }},
      {"flash at 3 + 11 + 2, DMA of 16-bit words, each", 16, "SCLK", "V 2.4",
       [] { return Memory().flash_word(); }},
  };
}

// Kilobytes of the chip's own memories.
double on_chip() {
  double bytes = 0;
  for (const memory::Region& region : memory::bf561_map().regions) {
    bytes += region.level == memory::Level::l3 ? 0 : region.size;
  }
  return bytes / 1024;
}

struct PublishedRegion {
  Address base;
  int core;  // -1: shared
  const char* name;
};
constexpr PublishedRegion kRegions[] = {
    {0xFFA00000, 0, "l1.code"},   {0xFFA10000, 0, "l1.code.cache"}, {0xFF800000, 0, "l1.data.a"},
    {0xFF900000, 0, "l1.data.b"}, {0xFFB00000, 0, "l1.scratch"},    {0xFF600000, 1, "l1.code"},
    {0xFF400000, 1, "l1.data.a"}, {0xFF500000, 1, "l1.data.b"},     {0xFF700000, 1, "l1.scratch"},
    {0xFEB00000, -1, "l2"},       {0x20000000, -1, "flash"},        {0x00000000, -1, "l3"}};
double regions_in_place() {
  const memory::MemoryMap map = memory::bf561_map();
  return static_cast<double>(std::ranges::count_if(kRegions, [&](const PublishedRegion& region) {
    const memory::Region* found = map.find(region.base);
    return found != nullptr && found->base == region.base && found->core == region.core &&
           found->name == region.name;
  }));
}

std::vector<Figure> memories() {
  return {
      {"system clock at a core clock of 600 MHz, core cycles", 5, "CCLK", "D 0.1",
       [] { return static_cast<double>(memory::ClockParameters().ratio()); }},
      {"memories at their addresses", std::size(kRegions), "regions", "V 2.1", regions_in_place},
      {"memory on the chip", 328, "KB", "V 2.1", on_chip},
      {"data cache, ways", 2, "lines", "V 2.2", [] { return Memory().data_ways(); }},
      {"instruction cache, ways", 4, "lines", "V 2.2", [] { return Memory().code_ways(); }},
      {"a line of a cache", 32, "bytes", "V 2.2", [] { return Memory().data_line(); }},
      {"L2 at half the core's clock, 192 bits of a line behind the first 64", 6, "CCLK", "V 2.3",
       [] { return Memory().rest_of_an_l2_line(); }},
      {"L2 at its peak of 4.8 GB/s, 192 bits of a line behind the first 64", 3, "CCLK", "V 2.3",
       [] { return Memory().rest_of_an_l2_line(); }, true},
      {"rows of the SDRAM that are open at once", 4, "rows", "V 2.4",
       [] { return Memory().open_rows(); }},
      {"from opening a row to opening another of its bank", 9, "SCLK", "V 2.4",
       [] { return Memory().row_cycle(); }},
      {"from one refresh to the next", 7.81, "us", "V 2.4",
       [] { return Memory().between_refreshes(); }},
      {"refreshes, of the bus's time", 1.3, "%", "D 2.4", Memory::refresh_share},
      instruction("a lock in L2 that is free: CLI, TESTSET, IF !CC JUMP (BP) back, SSYNC", 40,
                  "D 4",
                  "P2.L = 0; P2.H = 0xFEB0; NOP; NOP; NOP; NOP; CLI R2; .Lx: TESTSET (P2); "
                  "IF !CC JUMP .Lx (BP); SSYNC;",
                  "P2.L = 0; P2.H = 0xFEB0; NOP; NOP; NOP; NOP;"),
  };
}

TEST(PublishedFigures, StandOnThePageAsTheyAreSimulated) {
  expect_on_page(instructions());
  expect_on_page(accesses());
  expect_on_page(memories());
}

TEST(PublishedFigures, AreMetThroughout) {
  EXPECT_THAT(not_met(instructions()), testing::IsEmpty());
  EXPECT_THAT(not_met(accesses()), testing::IsEmpty());
  EXPECT_THAT(not_met(memories()), testing::IsEmpty());
}

}  // namespace
}  // namespace finback::core
