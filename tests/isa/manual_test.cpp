// The manual's page of instructions is the one that the table makes.
#include <gtest/gtest.h>

#include <common/file.hpp>
#include <isa_sim/isa/manual.hpp>

namespace finback::isa {
namespace {

TEST(Manual, InstructionsPageIsTheGeneratedOne) {
  const std::string page = read_text_file(FINBACK_SOURCE_DIR "/docs/instructions.md");
  EXPECT_TRUE(page == instructions_as_markdown())
      << "write it anew: finback isa > docs/instructions.md";
}

TEST(Manual, ShowsPatternsAsPeopleWriteThem) {
  const std::string page = instructions_as_markdown();
  EXPECT_NE(page.find("| `D = [P++]` | 2 | access | 1 | load |"), std::string::npos);
  EXPECT_NE(page.find("| `D = (D + D) << 1` |"), std::string::npos);
  EXPECT_NE(page.find("| `D = D <lanes> D <sco>` |"), std::string::npos);
}

}  // namespace
}  // namespace finback::isa
