// docs/bir.md holds what it promises: its example loads, and it names every operand kind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tests/ir/support.hpp>

#include <common/file.hpp>
#include <isa_sim/ir/linker.hpp>

namespace finback::ir {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string manual() { return read_text_file(FINBACK_BIR_MANUAL); }

TEST(Manual, ItsExampleIsAProgram) {
  const std::string text = manual();
  const std::string fence = "```bir\n";
  const std::size_t begin = text.find(fence);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t end = text.find("```", begin + fence.size());
  ASSERT_NE(end, std::string::npos);
  const Program example =
      parse(text.substr(begin + fence.size(), end - begin - fence.size()), "bir.md");
  EXPECT_THAT(problems(example, isa::instruction_syntax()), IsEmpty());
  FirmwareUnits firmware = core_a({std::make_shared<const Program>(example)});
  firmware.cores[0].entry = "_shd_count";
  const Image image = link(firmware, default_placement(), memory::bf561_map());
  EXPECT_EQ(image.cores[0].functions.size(), 1u);
}

TEST(Manual, NamesEveryOperandKind) {
  const std::string text = manual();
  for (int i = 0; i <= static_cast<int>(isa::OperandKind::loop_bottom); ++i) {
    const std::string kind =
        "`{" + std::string(isa::kind_name(static_cast<isa::OperandKind>(i))) + "}`";
    EXPECT_THAT(text, HasSubstr(kind));
  }
}

}  // namespace
}  // namespace finback::ir
