// What a metric speaks of, read from its name (docs/metrics.md).
#pragma once

#include <cstdint>
#include <string>

namespace finback::budget {

enum class SubjectKind : std::uint8_t {
  camera,    // frames a second, cycles, latency: the whole
  core,      // all cycles of a core
  cause,     // a core's cycles of one cause, `name`
  function,  // its own cycles, calls, instructions
  callees,   // a function with all that it calls: inclusive cycles
  stage,     // the same for a stage, `name` as in the metric
  object,
  level,   // bytes and accesses at a level of memory, `name`
  region,  // how full it is
  code,    // size of a core's code
  stack,
  power,
  accuracy,
};

struct Subject {
  SubjectKind kind = SubjectKind::camera;
  std::string owner;  // "core_a", "core_b", "shared"; "" where it has none
  std::string name;
};

[[nodiscard]] Subject subject_of(const std::string& metric);

}  // namespace finback::budget
