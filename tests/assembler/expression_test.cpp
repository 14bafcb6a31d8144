// Expressions: operators and how they bind, symbols, what is known when.
#include <gmock/gmock.h>

#include "support.hpp"

namespace finback::assembler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::int64_t value_of(const std::string& expression) {
  std::int64_t value = 0;
  const std::vector<int> bytes = bytes_of(".quad " + expression);
  for (std::size_t i = 8; i-- > 0;) {
    value = static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << 8) | bytes[i];
  }
  return value;
}

TEST(Expression, OperatorsBindAsInTheGnuAssembler) {
  EXPECT_EQ(value_of("2 + 3 * 4"), 14);
  EXPECT_EQ(value_of("1 + 2 | 4"), 7) << "| before +";
  EXPECT_EQ(value_of("6 - 1 & 3"), 5) << "& before -";
  EXPECT_EQ(value_of("1 << 4 - 1"), 15) << "<< before -";
  EXPECT_EQ(value_of("(1 << (4 - 1))"), 8);
  EXPECT_EQ(value_of("7 / 2 * 2 + 7 % 4"), 9);
  EXPECT_EQ(value_of("1 + 1 == 2"), -1);
  EXPECT_EQ(value_of("1 == 2 || 3 > 2 && 1"), 1);
  EXPECT_EQ(value_of("10 - 2 - 3"), 5) << "from the left";
  EXPECT_EQ(value_of("-3 + ~0 + !0 + !5"), -3);
}

TEST(Expression, NumbersAreWrittenInManyWays) {
  EXPECT_EQ(value_of("0x1F + 0b11 + 017 + 'a'"), 31 + 3 + 15 + 97);
  EXPECT_EQ(value_of("h#1F + b#11 + o#17 + d#9"), 31 + 3 + 15 + 9);
  EXPECT_EQ(value_of("0.5"), 0x4000);
  EXPECT_EQ(value_of("4k"), 4096);
  EXPECT_EQ(value_of("08"), 8);
  EXPECT_EQ(value_of("'\\n'"), 10);
}

TEST(Expression, WrapsAtSixtyFourBits) {
  EXPECT_EQ(value_of("0x7fffffffffffffff + 1 < 0"), -1);
  EXPECT_EQ(value_of("1 << 64"), 0);
  EXPECT_EQ(value_of("-1 >> 60"), 15) << "without a sign";
  EXPECT_EQ(value_of("(-0x7fffffffffffffff - 1) / -1 < 0"), -1);
}

TEST(Expression, SymbolsAreNumbersWhenTheyAreUsed) {
  EXPECT_THAT(bytes_of(".set n, 1\n.byte n\n.set n, n + 1\n.byte n\nn = n * 5\n.byte n"),
              ElementsAre(1, 2, 10));
  EXPECT_THAT(bytes_of(".byte later, later + 1\nlater = 7"), ElementsAre(7, 8));
}

TEST(Expression, DifferencesOfLabelsAreNumbers) {
  EXPECT_THAT(bytes_of("a: .byte b - a, 9, (b - a) * 2\nb: .byte . - a"), ElementsAre(3, 9, 6, 3));
  EXPECT_THAT(bytes_of("a: .byte 0, 0\nb:\n.if b - a == 2\n.byte 1\n.endif\n"),
              ElementsAre(0, 0, 1));
  EXPECT_THAT(error_of(".text\nx: NOP;\n.data\ny: .byte y - x"),
              HasSubstr("a.s:4:10: y and x stand in different sections"));
  EXPECT_THAT(error_of(".data\ny: .byte y - elsewhere"),
              HasSubstr("elsewhere is not defined in this file"));
}

TEST(Expression, AddressesAreRelocations) {
  const ir::Program whole =
      program(".data\na: .long 5, b + 8, elsewhere - 4\nb: .long b - 4 + 1\n");
  const std::vector<ir::Relocation>& found = piece(whole, ".data").relocations;
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0], (ir::Relocation{4, 4, "b", 8, {}}));
  EXPECT_EQ(found[1], (ir::Relocation{8, 4, "elsewhere", -4, {}}));
  EXPECT_EQ(found[2], (ir::Relocation{12, 4, "b", -3, {}}));
  EXPECT_THAT(error_of(".data\na: .short a"), HasSubstr("the address of a takes 4 bytes, not 2"));
  EXPECT_THAT(error_of(".data\na: .long a * 2"),
              HasSubstr("'*' wants numbers, but a is an address"));
}

TEST(Expression, SymbolsThatDependOnEachOtherEnd) {
  EXPECT_THAT(error_of(".set a, b\n.set b, a\n"), HasSubstr("b is set to itself"));
  EXPECT_THAT(error_of(".long 1 / (2 - 2)"), HasSubstr("a.s:1:7: division by zero"));
}

}  // namespace
}  // namespace finback::assembler
