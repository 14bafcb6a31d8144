// Where the cycles and the bytes went, as text and as JSON (docs/finback-profile.md).
#pragma once

#include <string>

#include <report/run_result.hpp>
#include <report/sections.hpp>

namespace finback::report {

struct ProfileView {
  std::size_t most = 20;  // rows of each table; kAll
  FunctionOrder order = FunctionOrder::exclusive;
  std::string core;  // functions and lines of this one only; "": of both
  Style style;
};

[[nodiscard]] std::string profile_text(const RunResult& result, const ProfileView& view);

// The parts of result.json that a profile is made of, whole.
[[nodiscard]] std::string profile_json(const RunResult& result);

}  // namespace finback::report
