// The story of cycles: which functions and lines of a core, by which cause, on which objects.
#pragma once

#include <budget/story.hpp>

namespace finback::budget {

[[nodiscard]] Explanation tell_cycles(const StoryKey& key, const Material& material,
                                      const std::set<std::string>& subjects);

// "shd_scores: l1.data.a -> l3", or "shd_scores (l3)" when it did not move.
[[nodiscard]] std::string place_text(const ObjectChange& object, bool against);

// The first of a list in telling.
inline constexpr std::size_t kTold = 3;

}  // namespace finback::budget
