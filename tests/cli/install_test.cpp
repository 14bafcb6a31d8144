// What `cmake --install` puts under a prefix works from any folder.
#include "program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

class Install : public ProgramTest {
 protected:
  // The example of a firmware, outside the source tree: by CMake and by make the same.
  void build_example(const std::string& prefix) const {
    const std::filesystem::path example = folder() / "example";
    std::filesystem::copy(prefix + "/share/finback/examples/firmware", example,
                          std::filesystem::copy_options::recursive);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{FINBACK_CMAKE, "-B", "out", "-D", "CMAKE_PREFIX_PATH=" + prefix},
          std::vector<std::string>{FINBACK_CMAKE, "--build", "out"},
          std::vector<std::string>{"make", "FINBACK=" + prefix}}) {
      const Finished built = run_program(command, example);
      ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
    }
    EXPECT_EQ(read_text_file(example / "out/edges/edges.bir"),
              read_text_file(example / "build/edges/edges.bir"));
    const Finished ran = run_program({prefix + "/bin/finback", "run", "--firmware", "out/edges",
                                      "--frames", "2", "--out", "result"},
                                     example);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(std::filesystem::exists(example / "result/disparity_0001.png"));
  }
};

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
    build_example(prefix);
  }
}

}  // namespace
}  // namespace finback::cli
