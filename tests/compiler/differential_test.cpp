// Every program of programs/, a file or a folder of several, compiled by the host's compiler and by
// finback-cc at several levels, prints the same.
#include <algorithm>

#include "compiler_fixture.hpp"

namespace finback::compiler {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> all_programs() {
  std::vector<std::string> names;
  for (const auto& entry :
       fs::directory_iterator(fs::path(FINBACK_SOURCE_DIR) / "tests/compiler/programs"))
    if (entry.is_directory() || entry.path().extension() == ".c" ||
        entry.path().extension() == ".cpp")
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

class Differential : public CompilerTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(Differential, PrintsWhatTheHostPrints) {
  const std::string source =
      std::string(FINBACK_SOURCE_DIR) + "/tests/compiler/programs/" + GetParam();
  const char* host = GetParam().ends_with(".cpp") ? FINBACK_HOST_CXX : FINBACK_HOST_CC;
  std::vector<std::string> command = {host, "-w", "-O1", "-o", "host"};
  for (const std::string& file : sources_of(source))
    command.push_back(file);
  const Finished built = run(command);
  ASSERT_EQ(built.exit_code, 0) << built.err;
  const Finished wanted = run({"./host"});
  ASSERT_EQ(wanted.exit_code, 0);
  ASSERT_FALSE(wanted.out.empty());
  for (const char* level : {"0", "1", "2", "3", "s"}) {
    const Finished got = execute(source, level);
    EXPECT_EQ(got.exit_code, 0) << "-O" << level << ": " << got.err;
    EXPECT_EQ(got.out, wanted.out) << "-O" << level;
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, Differential, ::testing::ValuesIn(all_programs()),
                         [](const auto& program) {
                           return program.param.substr(0, program.param.find('.'));
                         });

class DifferentialPrograms : public CompilerTest {};

TEST_F(DifferentialPrograms, StandInTheTableOfThemes) {
  const std::string folder = std::string(FINBACK_SOURCE_DIR) + "/tests/compiler/programs";
  std::string words = read(folder + "/README.md");
  std::replace(words.begin(), words.end(), '`', ' ');
  for (const std::string& program : all_programs())
    EXPECT_NE(words.find(" " + program.substr(0, program.find('.')) + " "), std::string::npos)
        << program << " does not stand in " << folder << "/README.md";
}

TEST_F(DifferentialPrograms, AreAllThere) { EXPECT_GE(all_programs().size(), 150U); }

}  // namespace
}  // namespace finback::compiler
