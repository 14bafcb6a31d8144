// Texts that would never end or take all memory are refused, soon.
#include <gmock/gmock.h>

#include "support.hpp"

namespace finback::assembler {
namespace {

using testing::HasSubstr;

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    all += text;
  }
  return all;
}

TEST(Bounds, Recursion) {
  EXPECT_THAT(error_of(".macro a\na\n.endm\na\n"), HasSubstr("does one call itself without end?"));
  EXPECT_THAT(error_of(".macro d x\nd \\x\\x\\x\\x\n.endm\nd 0123456789\n"),
              HasSubstr("becomes more than"));
}

TEST(Bounds, Repetitions) {
  EXPECT_THAT(error_of(".rept 1000000000\n.endr\n"), HasSubstr("does not end"));
  EXPECT_THAT(error_of(".rept -1\n.endr\n"), HasSubstr("-1 times is no number of repetitions"));
}

TEST(Bounds, Room) {
  EXPECT_THAT(error_of(".space 9999999999"), HasSubstr("a file has at most 256 MB"));
  EXPECT_THAT(error_of(".space -1"), HasSubstr("-1 is no number of bytes"));
  EXPECT_THAT(error_of(".fill 0x7fffffffffffffff, 8"), HasSubstr("a file has at most 256 MB"));
  EXPECT_THAT(error_of(".rept 9\n.space 100000000\n.endr"), HasSubstr("a file has at most 256 MB"));
  EXPECT_THAT(error_of(".org 0x7fffffffffffffff"), HasSubstr("a file has at most 256 MB"));
  EXPECT_THAT(error_of(".p2align 60"), HasSubstr("an alignment is a power of two"));
}

TEST(Bounds, Expressions) {
  EXPECT_THAT(error_of(".long " + repeated("(", 5000)), HasSubstr("too long"));
  EXPECT_THAT(error_of(".long 1" + repeated("+x", 5000)), HasSubstr("too long"));
  EXPECT_THAT(error_of(".set x, y\n" + repeated(".set x, x + z\n", 5000) + ".long x"),
              HasSubstr("too long"));
}

TEST(Bounds, AnInstructionThatNeverEnds) {
  EXPECT_THAT(error_of(repeated("what is this\n", 1000)), HasSubstr("is a ';' missing?"));
}

}  // namespace
}  // namespace finback::assembler
