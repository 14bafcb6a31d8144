// Everything that a run found out, in one structure that every writer works from.
//
// Models nothing: whoever runs a machine fills it (runner/run_firmware.hpp), the writers below turn
// it into text and JSON. It holds no path, date or fact of the host, so that the same inputs give
// the same bytes.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <clock_model/clock_history.hpp>
#include <common/units.hpp>
#include <power_model/power_model.hpp>

namespace finback::report {

// Cycles by cause, in the order of core::kCauseNames; every cause is there, 0 or not.
using CyclesByCause = std::vector<std::pair<std::string, Cycles>>;

// Bytes by level of memory, in the order of memory::kLevelNames; every level is there.
using BytesByLevel = std::vector<std::pair<std::string, Bytes>>;

// One input of a run: its name and the FNV-1a hash of its bytes (report::content_hash).
struct Ingredient {
  std::string name;
  std::string hash;
};

struct Provenance {
  std::string tool_version;
  Ingredient firmware;
  Ingredient placement;
  Ingredient machine;
  Ingredient power;
  Ingredient scene;
};

struct Frame {
  std::uint32_t number = 0;
  Cycles grabbed = 0;    // the host port gave the pair to the firmware
  Cycles published = 0;  // the firmware handed over the finished map
};

struct Core {
  std::string name;  // "core_a"
  bool started = false;
  Cycles cycles = 0;  // from its start to the end of the run, asleep or not
  std::uint64_t instructions = 0;
  std::uint64_t packets = 0;
  CyclesByCause causes;                                           // sums to `cycles`
  std::vector<std::pair<std::string, std::uint64_t>> operations;  // executed, by energy class
  Bytes code_bytes = 0;                                           // of its functions
  Bytes stack_bytes = 0;                                          // as placed
  Bytes stack_used_bytes = 0;                                     // the deepest that was written
};

struct Function {
  std::string core;
  std::string name;
  std::uint64_t calls = 0;
  std::uint64_t instructions = 0;
  Cycles inclusive = 0;
  Cycles exclusive = 0;
  CyclesByCause causes;  // of the exclusive cycles
  Bytes code_bytes = 0;
  BytesByLevel bytes;  // that its own loads and stores moved
};

// What one line of source cost within one function: a line that is inlined into several has several
// rows.
struct Line {
  std::string core;
  std::string function;  // that its code is part of
  std::string file;      // as the program names it; "" with line 0: code without a line
  int line = 0;
  std::uint64_t executions = 0;  // of its most executed packet
  std::uint64_t packets = 0;     // issued, all together
  Cycles cycles = 0;
  CyclesByCause causes;  // only those that are not 0; sum to `cycles`
  BytesByLevel bytes;    // only those that are not 0
};

// A stage of the firmware's pipeline: one function with everything that it calls.
struct Stage {
  std::string name;
  std::string core;
  std::string function;
  Cycles cycles = 0;  // over the whole run
  double cycles_per_frame = 0;
};

// Bytes that one initiator moved at one level of memory.
struct Traffic {
  std::string level;      // "l1", "l2", "l3"
  std::string initiator;  // "core_a", "mdma1_0", ...
  Bytes read = 0;
  Bytes written = 0;
};

struct ObjectAccess {
  std::string initiator;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
  Bytes read_bytes = 0;
  Bytes written_bytes = 0;
  Cycles stall_cycles = 0;  // of the initiator, 0 for DMA
};

struct Object {
  std::string name;
  std::string owner;  // "core_a", "core_b", "shared"
  std::string region;
  std::string level;
  Bytes size = 0;
  std::vector<ObjectAccess> accesses;  // of those who touched it
};

struct RegionUse {
  std::string core;  // "" for a shared one
  std::string name;
  std::string level;
  Bytes used = 0;
  Bytes size = 0;
};

struct Target {
  std::string name;        // "frames_per_second"
  std::string comparison;  // ">=" or "<="
  double limit = 0;
  double value = 0;
  std::string unit;
  [[nodiscard]] bool passed() const { return comparison == ">=" ? value >= limit : value <= limit; }
};

// A disparity map against the scene's ground truth, in percent.
struct Accuracy {
  std::uint32_t frame = 0;
  double delta = 1.0;  // pixels; further from the truth is wrong
  int border = 0;      // pixels left out on every side
  int compared = 0;    // pixels with known truth inside the border
  double density = 0;  // share of these that are valid in the map
  double bad = 0;      // share of these that are invalid or wrong
  double wrong = 0;    // share of the valid ones that are wrong
};

// What was spent at an operating point of the chip: full_on at 600 MHz, sleep, ...
struct PointUse {
  clock::OperatingPoint point;
  Cycles cycles = 0;
  double seconds = 0;
  double watts = 0;  // of the whole board, on average
  [[nodiscard]] double joules() const { return watts * seconds; }
};

struct RunResult {
  Provenance provenance;
  std::string stopped = "exited";  // why the run ended: "exited", "deadlock", ...
  double core_hertz = 0;           // at the start
  double system_hertz = 0;
  clock::ClockHistory clocks;  // empty: they did not change
  std::vector<PointUse> points;
  Cycles cycles = 0;  // of simulated time
  std::vector<Frame> frames;
  std::vector<Core> cores;
  std::vector<Stage> stages;
  std::vector<Function> functions;
  std::vector<Line> lines;  // by core, function, file and line
  std::vector<Traffic> traffic;
  std::vector<Object> objects;
  std::vector<RegionUse> regions;
  power::PowerEstimate power;
  std::vector<Target> targets;
  std::optional<Accuracy> accuracy;  // when the scene's truth is known
  std::map<std::string, std::uint64_t> counters;

  // Between two times in cycles: by how many of them a second has on average, and how many
  // seconds they are.
  [[nodiscard]] double hertz(Cycles from, Cycles to) const;
  [[nodiscard]] double seconds(Cycles from, Cycles to) const;
  // Of the whole run.
  [[nodiscard]] double seconds() const { return seconds(0, cycles); }
};

// Frames a second in the steady state: (n - 1) / (time from first to last publication); with one
// frame 1 / (time from grabbing to publishing); 0 without frames.
[[nodiscard]] double frames_per_second(const RunResult& result);
// The same at one clock, and the time that it looks at.
[[nodiscard]] double frames_per_second(const std::vector<Frame>& frames, double core_hertz);
struct Stretch {
  Cycles from = 0;
  Cycles to = 0;
};
[[nodiscard]] Stretch steady_state(const std::vector<Frame>& frames);

// "pass" when every target is met, else "fail: NAME VALUE UNIT, wanted >= LIMIT, ...".
[[nodiscard]] std::string verdict(const RunResult& result);

// FNV-1a, 64 bits, as "fnv1a:0123456789abcdef": tells inputs apart; not a cryptographic hash.
[[nodiscard]] std::string content_hash(std::string_view content);

}  // namespace finback::report
