// Where one core's cycles went: by cause, by function and by packet. Sums are exact: the cycles
// over all causes, over all functions and over all packets each equal the core's total, the bytes
// over all functions and over all packets each the core's traffic at that level.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <common/units.hpp>
#include <memory_model/memory_map.hpp>

namespace finback::core {

// What a cycle was spent on. `issue` is work; the rest is waiting, named by its cause.
enum class Cause : std::uint8_t {
  issue,         // one for each packet
  multi_cycle,   // the further cycles of instructions that hold the pipeline
  branch_taken,  // refill after a predicted or unconditional change of flow
  branch_mispredict,
  hazard_address,  // load or move into a pointer, then its use as an address
  hazard_ex1,      // ALU result, then an operand needed in EX1
  fetch,           // instructions in L2 or L3, uncached; two fetches behind a change of flow
  sub_bank,        // two accesses of a packet, or one and DMA's, in one L1 sub-bank
  store_buffer,    // a load of what was just stored to L1
  l2_read,
  l2_write,
  l3_read,
  l3_write,
  data_cache,  // a line of the data cache that was not there, or not yet
  code_cache,  // a line of the instruction cache that was not there, or not yet
  device,      // memory-mapped registers
  interrupt_entry,
  idle,  // IDLE: asleep
};
inline constexpr int kCauseCount = 18;
inline constexpr std::array<std::string_view, kCauseCount> kCauseNames = {
    "issue",      "multi_cycle",     "branch_taken", "branch_mispredict", "hazard_address",
    "hazard_ex1", "fetch",           "sub_bank",     "store_buffer",      "l2_read",
    "l2_write",   "l3_read",         "l3_write",     "data_cache",        "code_cache",
    "device",     "interrupt_entry", "idle"};

// No register is waited for.
inline constexpr int kNoRegister = -1;

using CauseCycles = std::array<Cycles, kCauseCount>;

// Bytes that loads and stores moved, by memory::Level. Device registers are no level.
using LevelBytes = std::array<Bytes, memory::kLevelCount>;

struct PacketProfile {
  std::size_t packet = 0;  // index into ir::CoreImage::packets
  std::uint64_t executions = 0;
  CauseCycles cycles{};
  LevelBytes bytes{};
};

struct FunctionProfile {
  std::string name;
  std::uint64_t calls = 0;
  std::uint64_t instructions = 0;  // slots, NOP and MNOP of packets not counted
  CauseCycles exclusive{};
  Cycles inclusive = 0;  // with callees; a recursive function counts its outermost call; without
                         // interrupt handlers
  LevelBytes bytes{};
};

struct CoreProfile {
  bool started = false;
  Cycles cycles = 0;  // from start to the end of the run, idle included
  std::uint64_t instructions = 0;
  std::uint64_t packets = 0;
  // Counts of executed operations by isa::Energy class, for the power model.
  std::array<std::uint64_t, 6> by_energy_class{};
  CauseCycles causes{};
  std::vector<FunctionProfile> functions;      // in order of address
  std::vector<PacketProfile> packet_profiles;  // those that cost anything, in order of address
};

// The part of it that the power model wants.
struct CoreWork {
  Cycles busy = 0;  // not asleep
  std::array<std::uint64_t, 6> by_energy_class{};
};

}  // namespace finback::core
