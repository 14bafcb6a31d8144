// What differs between two results: functions by cause and line, objects by place and traffic.
//
// Time asleep (idle) is kept apart: it is a consequence of what the other core does. Lines of
// source are matched by their order and their work, not by their number, so that a line that was
// inserted above does not make all those below it look changed.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <report/run_result.hpp>

namespace finback::budget {

// By cause; only those that are not 0.
using CauseChanges = std::map<std::string, std::int64_t>;

struct LineChange {
  std::string file;
  int line = 0;  // as it is numbered now
  std::int64_t cycles = 0;
  CauseChanges causes;
};

struct FunctionChange {
  std::string core;
  std::string name;
  bool is_new = false;
  bool is_gone = false;
  Cycles before = 0;  // exclusive, without idle
  Cycles after = 0;
  std::int64_t idle = 0;  // change
  CauseChanges causes;    // without idle; they sum to cycles()
  std::uint64_t calls_before = 0;
  std::uint64_t calls_after = 0;
  Bytes code_before = 0;
  Bytes code_after = 0;
  std::vector<LineChange> lines;  // those that changed, without idle

  [[nodiscard]] std::int64_t cycles() const {
    return static_cast<std::int64_t>(after) - static_cast<std::int64_t>(before);
  }
};

struct ObjectChange {
  std::string owner;
  std::string name;
  std::string region_before;  // "": it is new
  std::string region_after;   // "": it is gone
  std::string level_before;
  std::string level_after;
  Bytes size_before = 0;
  Bytes size_after = 0;
  Bytes bytes_before = 0;  // moved to and from it, by all
  Bytes bytes_after = 0;
  std::map<std::string, std::int64_t> stalls;  // change, by initiator; only those that are not 0

  [[nodiscard]] bool moved() const { return region_before != region_after; }
};

// Both hold everything that either result has, in the order of `after`, then what is gone.
struct Changes {
  std::vector<FunctionChange> functions;
  std::vector<ObjectChange> objects;
};

// An empty `before` makes everything new: what the costs are now.
[[nodiscard]] Changes compare(const report::RunResult& before, const report::RunResult& after);

}  // namespace finback::budget
