// A space to explore: what all its points run, and the axes along which they differ.
//
// An axis is something that can be chosen: the region of some objects, a machine parameter, the
// clocks, the firmware. A point takes one choice of each. Whoever picks points (a grid, a sample,
// later a search) does so by the numbers of the choices alone; how a choice changes a run is in
// candidate.hpp. The file: docs/finback-explore.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <runner/movables.hpp>
#include <runner/run_request.hpp>

namespace finback::explorer {

struct Setting {
  std::string parameter;
  double value = 0;
};

// One value of an axis. `text` is how tables and files show it; of the rest an axis of its kind
// uses one.
struct Choice {
  std::string text;               // "l3", "9", "600/120"
  std::string region;             // placement
  std::vector<Setting> settings;  // machine, clock
  std::size_t firmware = 0;       // firmware: into Space::firmwares
  SourcePlace written;
};

enum class AxisKind : std::uint8_t { firmware, placement, machine, clock };

struct Axis {
  AxisKind kind = AxisKind::machine;
  std::string name;  // "core_b.shd_scores", "memory.l2.read_cycles", "clock", "firmware"
  std::vector<Choice> choices;
  SourcePlace written;
  // Of a placement: what moves, without its region, in each of Space::firmwares.
  std::vector<std::vector<runner::Move>> things;
};

// A random part of the grid.
struct Sample {
  std::uint64_t points = 0;
  std::uint64_t seed = 1;
};

// A bound on a metric that a point must meet to make the goal.
struct Requirement {
  std::string metric;
  bool at_least = true;
  double limit = 0;
  SourcePlace written;
  [[nodiscard]] bool met_by(double value) const {
    return at_least ? value >= limit : value <= limit;
  }
};

// Another metric that is shown.
struct Column {
  std::string metric;
  SourcePlace written;
};

struct Space {
  std::string file;                               // as it was given
  runner::RunRequest request;                     // what all points have in common, by names
  runner::RunInputs base;                         // and loaded; its firmware is the first of these
  std::vector<runner::LoadedFirmware> firmwares;  // at least one
  std::vector<std::string> firmware_names;        // as `finback run --firmware` takes them
  std::vector<Axis> axes;                         // in the order of the manual, then of the text
  std::optional<Sample> sample;                   // nothing: the whole grid
  std::vector<Requirement> goal;
  std::vector<Column> columns;
};

// More points than this are refused: a sample is wanted.
inline constexpr std::uint64_t kMostPoints = 100'000;

// Reads a space and loads what it names. Every name, region, value and clock is checked, so that
// what is left to go wrong is a point that does not fit or a program that faults. Throws InputError
// "file:line:column: what".
[[nodiscard]] Space load_space(const std::filesystem::path& path);
[[nodiscard]] Space parse_space(std::string_view text, const std::string& file);

// A number as people write it: the shortest text that reads back equal.
[[nodiscard]] std::string number_text(double value);

}  // namespace finback::explorer
