// Figures held to their page, docs/fidelity.md.
#pragma once

#include <gtest/gtest.h>
#include <string>
#include <tests/fidelity/published_figure.hpp>
#include <vector>

#include <common/file.hpp>

namespace finback {

inline void expect_on_page(const std::vector<PublishedFigure>& figures) {
  const std::string page = read_text_file(FINBACK_FIDELITY_PAGE);
  for (const PublishedFigure& figure : figures) {
    const std::string row = figure.row();
    EXPECT_NE(page.find("\n" + row + "\n"), std::string::npos) << "not on the page: " << row;
  }
}

// Names of those that are not within.
[[nodiscard]] inline std::vector<std::string> not_met(const std::vector<PublishedFigure>& figures) {
  std::vector<std::string> missed;
  for (const PublishedFigure& figure : figures) {
    if (figure.row().find("**not**") != std::string::npos) {
      missed.push_back(figure.what);
    }
  }
  return missed;
}

}  // namespace finback
