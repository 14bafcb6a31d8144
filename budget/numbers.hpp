// How numbers stand in what people read.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace finback::budget {

// "17,885,760", "62.014", "0.0321": whole numbers in groups of three, others to five digits.
[[nodiscard]] std::string number_text(double value);
// Two numbers, with as many digits as tell them apart.
[[nodiscard]] std::pair<std::string, std::string> distinct_texts(double left, double right);

// "+12,345", "-12,345", "+0".
[[nodiscard]] std::string signed_text(std::int64_t value);

// "+69.0 %", "-0.004 %", "<0.001 %"; "x 1,540" for large growth; "0 %" for equal numbers, "from 0"
// when there was nothing.
[[nodiscard]] std::string percent_text(double before, double after);

}  // namespace finback::budget
