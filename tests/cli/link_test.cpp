// `finback link`: the linker's own report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

#include "page_examples.hpp"
#include "program.hpp"

namespace finback::cli {
namespace {

class Link : public ProgramTest {
 protected:
  // Used and size of a memory of a core, by the summary.
  [[nodiscard]] static std::pair<int, int> use_of(const std::string& page,
                                                  const std::string& memory,
                                                  const std::string& core) {
    std::istringstream in(page);
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::string name;
      std::string owner;
      int used = 0;
      int size = 0;
      if (words >> name >> owner >> used >> size && name == memory && owner == core) {
        return {used, size};
      }
    }
    return {0, 0};
  }
};

// What the cores of the BF561 have: 64 KB of L1 data and 32 KB of code each.
TEST_F(Link, BothFirmwaresFitIntoL1) {
  for (const char* firmware : {"mesvs2", "mesvs1", "mesvs2_cameras", "mesvs1_cameras"}) {
    const Finished linked = finback({"link", "--firmware", firmware});
    ASSERT_EQ(linked.exit_code, 0) << linked.err;
    for (const char* core : {"core_a", "core_b"}) {
      SCOPED_TRACE(core);
      const auto [data, data_size] = use_of(linked.out, "l1.data", core);
      EXPECT_EQ(data_size, 65536);
      EXPECT_GT(data, 40000);
      EXPECT_LE(data, data_size);
      const auto [code, code_size] = use_of(linked.out, "l1.code", core);
      EXPECT_EQ(code_size, 32768);
      EXPECT_GT(code, 2000);
      EXPECT_LE(code, code_size);
    }
  }
}

TEST_F(Link, TellsWhereThingsLieAndWhatDoesNotFit) {
  const Finished moved = finback({"link", "--place", "core_b.shd_scores=l2"});
  ASSERT_EQ(moved.exit_code, 0) << moved.err;
  EXPECT_THAT(moved.out, testing::ContainsRegex("l2 +shared .*\n(  0x.*\n)*.* shd_scores\n"));
  const Finished full = finback({"link", "--place", "core_b.right_codes=l1.data.a"});
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_THAT(full.err, testing::HasSubstr("l1.data.a overflows"));
}

TEST_F(Link, PageSaysWhatIsPrinted) { check_page_examples("finback-link.md", folder().string()); }

}  // namespace
}  // namespace finback::cli
