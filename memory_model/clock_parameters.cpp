#include <cmath>
#include <fmt/format.h>

#include <common/error.hpp>
#include <memory_model/clock_parameters.hpp>

namespace finback::memory {

Cycles ClockParameters::ratio() const {
  const double quotient = cclk_mhz / sclk_mhz;
  const double whole = std::round(quotient);
  // Frequencies are given in decimal (533.3 and 133.325), so compare with a hair's breadth.
  if (std::abs(quotient - whole) > 1e-6 * quotient || whole < 1 || whole > 15) {
    throw InputError(
        fmt::format("clock.cclk_mhz = {} over clock.sclk_mhz = {} is {:.4f}: the ratio must be a "
                    "whole number from 1 to 15 (e.g. 600 and 120)",
                    double{cclk_mhz}, double{sclk_mhz}, quotient));
  }
  return static_cast<Cycles>(whole);
}

}  // namespace finback::memory
