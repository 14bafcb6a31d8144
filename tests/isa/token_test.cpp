// The words of BIR text: signs, numbers, comments, and the places of errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <isa_sim/isa/token.hpp>

namespace finback::isa {
namespace {

using testing::ElementsAre;

std::vector<std::string> texts(std::string_view text) {
  std::vector<std::string> result;
  for (const Token& token : tokenize(text)) {
    result.emplace_back(token.text);
  }
  return result;
}

std::int64_t number(std::string_view text) {
  const std::vector<Token> tokens = tokenize(text);
  EXPECT_EQ(tokens.size(), 1u);
  EXPECT_EQ(tokens.at(0).kind, TokenKind::number);
  return tokens.at(0).number;
}

std::string token_error(std::string_view text) {
  try {
    (void)tokenize(text, "a.bir");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Token, TakesTheLongestSign) {
  EXPECT_THAT(texts("R2=R0+|+R1"), ElementsAre("R2", "=", "R0", "+|+", "R1"));
  EXPECT_THAT(texts("R0>>>=R1||[--SP]=R2"),
              ElementsAre("R0", ">>>=", "R1", "||", "[", "--", "SP", "]", "=", "R2"));
  EXPECT_THAT(texts("[P0++P1]"), ElementsAre("[", "P0", "++", "P1", "]"));
  EXPECT_THAT(texts("[FP+-8]"), ElementsAre("[", "FP", "+", "-", "8", "]"));
}

TEST(Token, KeepsDotsInNames) {
  EXPECT_THAT(texts("R0.L JUMP.S .Lx_1 .-_f"),
              ElementsAre("R0.L", "JUMP.S", ".Lx_1", ".", "-", "_f"));
}

TEST(Token, ReadsNumbersAsC) {
  EXPECT_EQ(number("0"), 0);
  EXPECT_EQ(number("1234567890123"), 1234567890123);
  EXPECT_EQ(number("0xFFc0F020"), 0xFFC0F020);
  EXPECT_EQ(number("0b101"), 5);
  EXPECT_EQ(number("017"), 15);
  EXPECT_EQ(number("'a'"), 'a');
  EXPECT_EQ(number("'\\n'"), '\n');
  EXPECT_EQ(number("'\\0'"), 0);
  EXPECT_EQ(number("';'"), ';');
}

TEST(Token, LeavesOutComments) {
  EXPECT_THAT(texts("# a line\n  # another\nNOP; // to the end\n/* two\nlines */ RTS;"),
              ElementsAre("NOP", ";", "RTS", ";"));
}

TEST(Token, KnowsPlacesAndLineStarts) {
  const std::vector<Token> tokens = tokenize("NOP;\n /* x\n */ R0 = R1;\n");
  ASSERT_EQ(tokens.size(), 6u);
  EXPECT_EQ(tokens[2].text, "R0");
  EXPECT_EQ(tokens[2].line, 3);
  EXPECT_EQ(tokens[2].column, 5);
  EXPECT_TRUE(tokens[0].first_in_line);
  EXPECT_FALSE(tokens[1].first_in_line);
  EXPECT_TRUE(tokens[2].first_in_line);
  EXPECT_FALSE(tokens[3].first_in_line);
}

TEST(Token, KeepsEscapesOfStrings) {
  const std::vector<Token> tokens = tokenize(R"(.ascii "a\"b\\" )");
  ASSERT_EQ(tokens.size(), 2u);
  EXPECT_EQ(tokens[1].kind, TokenKind::text);
  EXPECT_EQ(tokens[1].text, R"(a\"b\\)");
}

TEST(Token, NamesThePlaceOfWhatItCannotRead) {
  EXPECT_EQ(token_error("NOP;\n  ?"), "a.bir:2:3: '?' cannot stand here");
  EXPECT_EQ(token_error("\x80"),
            "a.bir:1:1: byte 0x80 cannot stand here: programs are plain ASCII text");
  EXPECT_EQ(token_error("NOP; /* and so on"), "a.bir:1:6: this comment is never closed: add */");
  EXPECT_EQ(token_error(".ascii \"x\n"), "a.bir:1:8: this string is never closed: add \"");
  EXPECT_EQ(token_error("R0 = 12ab"), "a.bir:1:8: 'a' is no digit of a base 10 number");
  EXPECT_EQ(token_error("R0 = 08"), "a.bir:1:7: '8' is no digit of a base 8 number");
  EXPECT_EQ(token_error("99999999999999999999"),
            "a.bir:1:1: this number does not fit into 64 bits");
  EXPECT_EQ(token_error("0x"), "a.bir:1:3: this number has no digits");
  EXPECT_EQ(
      token_error("'\\q'"),
      "a.bir:1:1: unknown escape in a character: write \\n \\t \\r \\0 \\\\ \\' or the number");
  EXPECT_EQ(token_error("'ab'"), "a.bir:1:1: a character stands between two quotes, as in 'a'");
}

}  // namespace
}  // namespace finback::isa
