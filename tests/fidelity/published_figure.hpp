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

  // As the page has it: within 5 %, or not.
  [[nodiscard]] std::string row() const {
    const double here = simulated();
    const bool within = std::abs(here - published) <= 0.05 * published;
    return fmt::format("| {} | {:g} | {:.4g} | {} | {} | {} |", what, published, here, unit, source,
                       within ? "within 5 %" : "**not**");
  }
};

}  // namespace finback
