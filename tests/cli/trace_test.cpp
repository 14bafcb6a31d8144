// finback trace, as a user runs it.
#include <gmock/gmock.h>
#include <map>
#include <sstream>

#include "page_examples.hpp"
#include "program.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class Trace : public ProgramTest {
 protected:
  // Two functions, the second called thrice, and a sum in memory.
  void SetUp() override {
    write("calls.s",
          "_start: P5 = 3 (X);\n"
          "        LSETUP (.La, .Lb) LC0 = P5;\n"
          ".La:    CALL _add;\n"
          ".Lb:    R0 += 1;\n"
          "        HLT;\n"
          "_add:   P0.L = LO(sum); P0.H = HI(sum);\n"
          "        R1 = [P0];\n"
          "        R1 = R1 + R0;\n"
          "        [P0] = R1;\n"
          "        RTS;\n"
          "        .data\n"
          "sum:    .long 0\n");
  }
};

// Lines that show a packet of core A.
std::vector<std::string> rows(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("a ")) {
      found.push_back(line);
    }
  }
  return found;
}

TEST_F(Trace, PageSaysWhatIsPrinted) { check_page_examples("finback-trace.md", folder()); }

TEST_F(Trace, WindowsByCycleFunctionLabelLineAndAddress) {
  const Finished all = finback({"trace", "calls.s"});
  ASSERT_EQ(all.exit_code, 0) << all.err;
  const std::vector<std::string> every = rows(all.out);
  ASSERT_EQ(every.size(), 2U + 3 * 8 + 1);
  EXPECT_THAT(all.out, HasSubstr("core_a: 27 packets in "));

  const auto window = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"trace", "calls.s"});
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return rows(finished.out);
  };
  const auto part = [&](std::size_t first, std::size_t count) {
    const auto from = every.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<std::string>(from, from + static_cast<std::ptrdiff_t>(count));
  };
  // Column widths are those of what is shown, so only functions and cycles are compared.
  const auto cycles = [](const std::vector<std::string>& lines) {
    std::vector<std::string> found;
    for (const std::string& line : lines) {
      found.push_back(line.substr(0, 32));
    }
    return found;
  };
  EXPECT_EQ(cycles(window({"--from", "add", "--to", "add"})), cycles(part(3, 8)));
  EXPECT_EQ(cycles(window({"--from", "add", "--to", ".Lb"})), cycles(part(3, 6)));
  EXPECT_EQ(cycles(window({"--from", "start:.Lb", "--to", "calls.s:3"})), cycles(part(9, 1)));
  EXPECT_EQ(cycles(window({"--from", "1", "--to", "2"})), cycles(part(1, 1)));
  EXPECT_EQ(cycles(window({"--from", "0x1000", "--limit", "4"})), cycles(part(0, 4)));
  EXPECT_EQ(window({"--function", "a?d"}).size(), 18U);
}

TEST_F(Trace, StopsAtItsLimitAndSaysSo) {
  const Finished finished = finback({"trace", "calls.s", "--limit", "5"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(rows(finished.out).size(), 5U);
  EXPECT_THAT(finished.err, HasSubstr("stopped at 5 packets of a core; --limit 0"));
}

TEST_F(Trace, NamesWhatIsNotThere) {
  EXPECT_THAT(finback({"trace", "calls.s", "--from", "ad"}).err,
              HasSubstr("there is no place ad in what is traced, did you mean add?"));
  EXPECT_THAT(finback({"trace", "calls.s", "--function", "sub"}).err,
              HasSubstr("there is no function sub in what is traced"));
  const Finished late = finback({"trace", "calls.s", "--from", "1000000"});
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_THAT(late.out, IsEmpty());
  EXPECT_THAT(late.err, HasSubstr("nothing was issued in this window"));
}

TEST_F(Trace, ShowsWhatLedToAFault) {
  write("fault.s", "_start: P0 = 3 (X);\n R0 = [P0];\n HLT;\n");
  const Finished finished = finback({"trace", "fault.s"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_EQ(rows(finished.out).size(), 2U);
  EXPECT_THAT(finished.out, HasSubstr("(undone by an exception) R0 = [P0]"));
  EXPECT_THAT(finished.err, HasSubstr("fault.s:2"));
}

TEST_F(Trace, OfTheFirmwareNamesTheObjectThatIsWaitedFor) {
  const Finished finished = finback({"trace", "--place", "core_b.shd_scores=l3", "--from",
                                     "shd_update_row", "--to", "shd_update_row", "--function",
                                     "shd_update_row", "--frames", "1", "--limit", "120"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(rows(finished.out), IsEmpty());  // core A does not have the function
  EXPECT_THAT(finished.out, HasSubstr("l3_read of shd_scores"));
  EXPECT_THAT(finished.out, HasSubstr("core_b: 120 packets in "));
}

// The rules of the format: every row begins, has stages in order of time and ends once.
TEST_F(Trace, KonataLogsAreWellFormed) {
  const Finished finished = finback({"trace", "calls.s", "--konata", "calls.kanata"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, Not(HasSubstr("cycles")));
  std::istringstream in(read_text_file(folder() / "calls.kanata"));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "Kanata\t0004");
  struct Row {
    long begin = -1;
    long stages = 0;
    long end = -1;
    std::string last;
  };
  std::map<std::string, Row> found;
  long now = 0;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string command;
    std::string id;
    words >> command >> id;
    if (command == "C=" || command == "C") {
      now = (command == "C" ? now : 0) + std::stol(id);
      continue;
    }
    Row& row = found[id];
    ASSERT_EQ(row.end, -1) << "after its end: " << line;
    if (command == "I") {
      ASSERT_EQ(row.begin, -1) << line;
      row.begin = now;
    } else if (command == "S") {
      ASSERT_NE(row.begin, -1) << line;
      ++row.stages;
      row.last = line.substr(line.rfind('\t') + 1);
    } else if (command == "R") {
      row.end = now;
    }
  }
  EXPECT_EQ(found.size(), 27U);
  for (const auto& [id, row] : found) {
    EXPECT_GE(row.stages, 10) << id;
    EXPECT_EQ(row.last, "WB") << id;
    EXPECT_GT(row.end, row.begin) << id;
  }
}

}  // namespace
}  // namespace finback::cli
