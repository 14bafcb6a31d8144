// A figure that was published, beside what is simulated: a row of docs/fidelity.md.
#pragma once

#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <string>

namespace finback {

struct PublishedFigure {
  std::string what;
  double published = 0;
  const char* unit = "CCLK";
  const char* source = "";  // mark and section of hardware.md
  std::function<double()> simulated;
  bool least = false;  // published as what it is at least

  // As the page has it: within 5 %, or no less; or not.
  [[nodiscard]] std::string row() const {
    const double here = simulated();
    const bool met = least ? here >= published * (1 - kRounding)
                           : std::abs(here - published) <= 0.05 * published;
    return fmt::format("| {} | {}{:.4g} | {:.4g} | {} | {} | {} |", what, least ? ">= " : "",
                       published, here, unit, source,
                       !met    ? "**not**"
                       : least ? "no less"
                               : "within 5 %");
  }

 private:
  static constexpr double kRounding = 1e-9;
};

}  // namespace finback
