// Runs finback-cc and what it writes, each test in a folder of its own.
#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace finback::compiler {

struct Finished {
  int exit_code = -1;  // 128 + number when a signal ended it
  std::string out;
  std::string err;
};

/// Which unit of the runtime memcpy and the like come from.
enum class Copying { plain, fast };

class CompilerTest : public ::testing::Test {
 protected:
  CompilerTest();
  ~CompilerTest() override;

  /// Runs a program to its end in the test's folder.
  [[nodiscard]] Finished run(const std::vector<std::string>& command) const;
  /// finback-cc with these arguments.
  [[nodiscard]] Finished cc(std::vector<std::string> arguments) const;
  void write(const std::string& name, std::string_view text) const;
  /// The text of a file of the test's folder; empty when it is not there.
  [[nodiscard]] std::string read(const std::string& name) const;
  /// The BIR of a C text at -O2; the test fails when it does not compile.
  [[nodiscard]] std::string compile(std::string_view text,
                                    const std::vector<std::string>& options = {}) const;
  /// What a program, a file or a folder of files, prints on the simulated machine, linked with the
  /// firmware's runtime.
  [[nodiscard]] Finished execute(const std::string& program, const std::string& level,
                                 Copying copying = Copying::plain) const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// How many random programs to try: so many, or what FINBACK_RANDOM_C asks for if that is more.
[[nodiscard]] unsigned programs_to_try(unsigned on_every_run);
/// The files of a program: itself, or those of the folder that it is, main.c first.
[[nodiscard]] std::vector<std::string> sources_of(const std::string& program);
/// The body of one function of a BIR text, from its label to its .size.
[[nodiscard]] std::string function_of(const std::string& bir, const std::string& name);
/// How often `what` occurs in `text`.
[[nodiscard]] int count(std::string_view text, std::string_view what);

}  // namespace finback::compiler
