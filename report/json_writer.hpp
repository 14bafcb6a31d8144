// A run's result as JSON, by the schema in report/result.schema.json (docs/result-json.md).
#pragma once

#include <string>

#include <report/run_result.hpp>

namespace finback::report {

// Raised when a key changes its meaning or goes; new keys do not raise it.
inline constexpr int kResultSchemaVersion = 1;

// The whole document, indented, ending in a newline. Keys stand in a fixed order; integers are
// exact, reals have the shortest form that reads back equal.
[[nodiscard]] std::string to_json(const RunResult& result);

}  // namespace finback::report
