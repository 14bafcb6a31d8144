// One cause of broken limits, and its telling.
#pragma once

#include <compare>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <budget/changes.hpp>
#include <budget/explain.hpp>

namespace finback::budget {

enum class Topic : std::uint8_t { cycles, bytes, region, code, stack, power, accuracy };

// What makes two explanations the same one.
struct StoryKey {
  Topic topic = Topic::cycles;
  std::string owner;   // of cycles, code, stack a core; of a region its owner
  std::string family;  // of cycles, "": all; of bytes the level; of a region its name
  bool growth = true;
  bool against = true;  // the baseline; else what the costs are now

  auto operator<=>(const StoryKey&) const = default;
  [[nodiscard]] std::int64_t sign() const { return growth ? 1 : -1; }
};

// How much a function grew by a family's causes; "": by all but idle.
[[nodiscard]] std::int64_t change_of(const FunctionChange& function, std::string_view family);

// How many more bytes an object moved at a level.
[[nodiscard]] std::int64_t bytes_change(const ObjectChange& object, std::string_view level);

// What stories are made of.
struct Material {
  const report::RunResult& now;
  const report::RunResult* baseline;  // nullptr: none
  Changes since;                      // the baseline
  Changes costs;                      // now, as changes from nothing

  Material(const report::RunResult& result, const report::RunResult* compared);
  [[nodiscard]] const Changes& of(const StoryKey& key) const { return key.against ? since : costs; }
};

// Fills headline, details and worst. `subjects` are functions that the story must name.
[[nodiscard]] Explanation tell(const StoryKey& key, const Material& material,
                               const std::set<std::string>& subjects);

}  // namespace finback::budget
