// Whether to print in colour.
#pragma once

#include <cstdlib>
#include <string>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <report/page.hpp>

namespace finback::cli {

inline void add_colour_option(CLI::App& command, std::string& when) {
  command
      .add_option("--color", when, "auto (on a terminal, unless NO_COLOR is set), always or never")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "always", "never"}));
}

[[nodiscard]] inline report::Style style_for(const std::string& when) {
  const char* no_colour = std::getenv("NO_COLOR");
  const bool wanted = ::isatty(STDOUT_FILENO) == 1 && (no_colour == nullptr || *no_colour == '\0');
  return {when == "always" || (when == "auto" && wanted)};
}

}  // namespace finback::cli
