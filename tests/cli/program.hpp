// Runs programs as a shell would, and gives each test a folder of its own.
#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace finback::cli {

struct Finished {
  int exit_code = -1;  // 128 + number when a signal ended it
  std::string out;
  std::string err;
};

// Runs a program to its end in folder `where`; when `interrupt_after_ms` is not negative, sends it
// SIGINT so many milliseconds after its start.
[[nodiscard]] Finished run_program(const std::vector<std::string>& command,
                                   const std::filesystem::path& where, int interrupt_after_ms = -1);

class ProgramTest : public ::testing::Test {
 public:
  ~ProgramTest() override;

 protected:
  ProgramTest();

  // Runs `finback` with these arguments in the test's folder.
  [[nodiscard]] Finished finback(std::vector<std::string> arguments,
                                 int interrupt_after_ms = -1) const;
  // Writes a file into the test's folder and returns its name.
  std::string write(const std::string& name, std::string_view text) const;
  // What the test's folder holds, hidden files too, in order.
  [[nodiscard]] std::vector<std::string> files() const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

// A firmware of core A whose main has this body, and then these objects.
[[nodiscard]] std::string program_text(std::string_view body, std::string_view objects = "");

// Bodies: main returns 0; main never returns.
inline constexpr std::string_view kReturnsZero = "  R0 = 0 (X);\n  RTS;\n";
inline constexpr std::string_view kNeverEnds = ".Lagain:\n  JUMP .Lagain;\n";

}  // namespace finback::cli
