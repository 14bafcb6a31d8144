// One field of a table of comma-separated values.
#pragma once

#include <string>

namespace finback {

// As it stands in a line: in quotes where it must be (RFC 4180).
[[nodiscard]] std::string csv_field(const std::string& text);

}  // namespace finback
