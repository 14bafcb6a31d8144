// What `cmake --install` puts under a prefix works from any folder.
#include "program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

class Install : public ProgramTest {};

TEST_F(Install, GivesProgramsThatRunAnywhere) {
  const std::string prefix = (folder() / "prefix").string();
  const Finished installed =
      run_program({FINBACK_CMAKE, "--install", FINBACK_BUILD_DIR, "--prefix", prefix}, folder());
  ASSERT_EQ(installed.exit_code, 0) << installed.err;

  const std::filesystem::path elsewhere = folder() / "elsewhere";
  std::filesystem::create_directory(elsewhere);
  const Finished run = run_program(
      {prefix + "/bin/finback", "run", "--scene", "aloe", "--frames", "1", "--out", "out"},
      elsewhere);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(elsewhere / "out" / "result.json"));
  EXPECT_TRUE(std::filesystem::exists(elsewhere / "out" / "disparity_0000.png"));
  EXPECT_TRUE(std::filesystem::exists(prefix + "/share/finback/result.schema.json"));

  if (FINBACK_HAS_COMPILER) {
    write("elsewhere/main.c", "int main(void) { return 0; }\n");
    const Finished compiled =
        run_program({prefix + "/bin/finback-cc", "-O2", "main.c", "-o", "main.bir"}, elsewhere);
    ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
    const Finished ran = run_program(
        {prefix + "/bin/finback", "run", "--firmware", "main.bir", "--out", "main"}, elsewhere);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
  }
}

}  // namespace
}  // namespace finback::cli
