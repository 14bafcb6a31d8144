// What to change in one text to get another: a unified diff, as `diff -u` writes it.
#pragma once

#include <string>

namespace finback {

// A text and the name that the diff's head shows; an empty name stands for a file that is not
// there.
struct NamedText {
  std::string name;
  std::string text;
};

// With three lines of context; "" when the texts are equal. The least number of changed lines; time
// and memory grow with the product of the numbers of lines.
[[nodiscard]] std::string unified_diff(const NamedText& before, const NamedText& after);

}  // namespace finback
