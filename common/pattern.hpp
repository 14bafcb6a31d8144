// Names by pattern, as placement files, budgets and options use them.
#pragma once

#include <string_view>

namespace finback {

// Whether `pattern` (`*` any characters, also none, dots too; `?` one) matches all of `name`.
[[nodiscard]] bool matches_pattern(std::string_view pattern, std::string_view name);

}  // namespace finback
