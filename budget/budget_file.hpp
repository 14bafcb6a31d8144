// A budgets file (TOML): which firmware, which baseline, and the limits that its metrics must keep
// (docs/finback-check.md).
//
// Its [run] table is read by those who run (runner::read_run_request); here it is only allowed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <budget/demand.hpp>
#include <common/error.hpp>

namespace finback {
class TomlReader;
}

namespace finback::budget {

struct Limit {
  std::string name;  // of a metric, or a pattern of names
  Demand demand;
  SourcePlace written;

  // "frames_per_second >= 20", as messages tell it.
  [[nodiscard]] std::string text() const;
};

struct Budget {
  std::string file;                // as it was named
  std::string firmware;            // the only one that it judges; "": any
  std::filesystem::path baseline;  // "": none
  std::filesystem::path sources;   // the folder that the firmware's source names start in
  std::vector<Limit> limits;       // in the order of the text
};

// Throws InputError naming the line: unknown keys, comparisons that cannot be read, relative limits
// without a baseline.
[[nodiscard]] Budget read_budget(const TomlReader& reader);

}  // namespace finback::budget
