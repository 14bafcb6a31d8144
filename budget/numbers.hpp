// How numbers stand in what people read.
#pragma once

#include <cstdint>
#include <string>

namespace finback::budget {

// "17,885,760", "62.014", "0.0321": whole numbers in groups of three, others to five digits.
[[nodiscard]] std::string number_text(double value);
// Every digit that tells it from its neighbours, for two that would look the same.
[[nodiscard]] std::string exact_text(double value);

// "+12,345", "-12,345", "+0".
[[nodiscard]] std::string signed_text(std::int64_t value);

// "+69.0 %", "-0.004 %"; "0 %" for equal numbers, "from 0" for a growth from 0.
[[nodiscard]] std::string percent_text(double before, double after);

}  // namespace finback::budget
