// Causes of cycles that one change of a program or placement moves together.
#pragma once

#include <string>
#include <string_view>

namespace finback::budget {

// "issue", "l3", ...; a cause that is not known is a family of its own.
[[nodiscard]] std::string family_of(std::string_view cause);

// What it is in words: "more work (issue)" when `growth`, else "less work (issue)".
[[nodiscard]] std::string family_text(std::string_view family, bool growth);

}  // namespace finback::budget
