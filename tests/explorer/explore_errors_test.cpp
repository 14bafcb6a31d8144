// What people get wrong with spaces and databases: one clear line, exit code 2, nothing simulated.
#include <cstdlib>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <unistd.h>

#include "../cli/program.hpp"
#include "camera.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

using explorer::camera_text;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ExploreErrors : public ProgramTest {
 protected:
  ExploreErrors() { write("camera.bir", camera_text()); }

  // Explores and checks that it fails in one line, and leaves nothing behind.
  [[nodiscard]] std::string refused(const std::vector<std::string>& arguments) const {
    const std::vector<std::string> before = files();
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 2) << finished.err;
    EXPECT_THAT(finished.out, IsEmpty());
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
    EXPECT_EQ(files(), before) << "something was left behind";
    return finished.err;
  }
  [[nodiscard]] std::string refused_space(const std::string& text) const {
    write("space.toml", text);
    return refused({"explore", "space.toml"});
  }
  // The same with a good [run], which is four lines.
  [[nodiscard]] std::string refused_axes(const std::string& text) const {
    return refused_space(std::string(explorer::kCameraRun) + text);
  }
  void write_space(const std::string& more = "") const {
    write("space.toml", std::string(explorer::kCameraRun) +
                            "[placement]\ncore_a.table_a = [\"l1.data.a\", \"l2\"]\n" + more);
  }
};

TEST_F(ExploreErrors, InPlacements) {
  EXPECT_THAT(refused_axes("[placement]\n\"core_a.table_c\" = [\"l2\"]\n"),
              AllOf(ContainsRegex("finback: space\\.toml:6:[0-9]+: "), HasSubstr("table_c"),
                    HasSubstr("did you mean table_")));
  EXPECT_THAT(refused_axes("[placement]\n\"core_b.table_a\" = [\"l2\"]\n"),
              HasSubstr("core_b of firmware camera has no object or function table_a, but core_a"));
  EXPECT_THAT(refused_axes("[placement]\n\"core_c.table_a\" = [\"l2\"]\n"),
              AllOf(HasSubstr("space.toml:6:"), HasSubstr("names no owner")));
  EXPECT_THAT(refused_axes("[placement]\n\"core_a.table_a\" = [\"l2\", \"l4\"]\n"),
              HasSubstr("space.toml:6:27: core_a has no region l4; did you mean l3?"));
  EXPECT_THAT(refused_axes("[placement]\n\"core_a.table_a\" = [\"l1.code\"]\n"),
              HasSubstr("region l1.code holds functions, not data"));
  EXPECT_THAT(refused_axes("[placement]\n\"core_a.main\" = [\"l1.data.a\"]\n"),
              HasSubstr("region l1.data.a holds data, not functions"));
  EXPECT_THAT(refused_axes("[placement]\n\"core_a.table_a\" = []\n"),
              HasSubstr("space.toml:6:20: core_a.table_a has no value"));
  EXPECT_THAT(refused_axes("[placement]\n\"core_a.table_a\" = [\"l2\", \"l3\", \"l2\"]\n"),
              HasSubstr("space.toml:6:33: core_a.table_a has the value l2 twice"));
  EXPECT_THAT(refused_axes("[placement]\n\"core_a.table_a\" = 3\n"),
              HasSubstr("is a string or a list of strings"));
}

TEST_F(ExploreErrors, InWhatIsGivenTwice) {
  EXPECT_THAT(
      refused_axes("[placement]\n\"core_a.table_a\" = [\"l2\"]\n\"core_a.ta*\" = [\"l3\"]\n"),
      HasSubstr("core_a.table_a is placed by core_a.table_a and by core_a.ta*"));
  EXPECT_THAT(refused_axes("place = \"core_a.table_a=l3\"\n[placement]\ncore_a.table_a = \"l2\"\n"),
              HasSubstr("core_a.table_a is placed here and by place in [run]"));
  EXPECT_THAT(refused_axes("[machine]\n\"clock.cclk_mhz\" = [600]\n[clock]\nmhz = [[600, 120]]\n"),
              HasSubstr("clock.cclk_mhz is set in [machine] and by [clock]"));
  EXPECT_THAT(refused_axes("set = [\"clock.cclk_mhz=300\"]\n[clock]\nmhz = [[600, 120]]\n"),
              HasSubstr("clock.cclk_mhz is set here and by set in [run]"));
  EXPECT_THAT(
      refused_axes("[machine]\n\"memory.l2.read_cycles\" = [9]\nmemory.l2.read_cycles = 7\n"),
      HasSubstr("memory.l2.read_cycles stands in [machine] twice"));
  EXPECT_THAT(refused_axes("[firmware]\nvariants = [\"mesvs2\"]\n"),
              HasSubstr("the firmware is given in [run] and in [firmware]"));
}

TEST_F(ExploreErrors, InMachines) {
  EXPECT_THAT(refused_axes("[machine]\n\"memory.l2.read_cicles\" = [9]\n"),
              AllOf(HasSubstr("space.toml:6:"), HasSubstr("did you mean memory.l2.read_cycles")));
  EXPECT_THAT(refused_axes("[machine]\n\"memory.l2.read_cycles\" = [9, 100000]\n"),
              AllOf(HasSubstr("space.toml:6:31: "), HasSubstr("out of range")));
  EXPECT_THAT(refused_axes("[machine]\n\"memory.l2.read_cycles\" = [9, \"x\"]\n"),
              HasSubstr("memory.l2.read_cycles wants numbers"));
  EXPECT_THAT(refused_axes("[machine]\n\"memory.l2.read_cycles\" = [9, 9.0]\n"),
              HasSubstr("has the value 9 twice"));
  EXPECT_THAT(refused_axes("[machine]\nmemory.l2.read_cycles = { from = 9, to = 7 }\n"),
              HasSubstr("from 9 to 7 by 1 is empty"));
  EXPECT_THAT(refused_axes("[machine]\nmemory.l2.read_cycles = { from = 7, to = 9, step = 0 }\n"),
              HasSubstr("is endless"));
  EXPECT_THAT(refused_axes("[machine]\nmemory.l2.read_cycles = { from = 7 }\n"),
              HasSubstr("wants a number to"));
  EXPECT_THAT(refused_axes("[machine]\nmemory.l2.sub_bank_bytes = [3000]\n"),
              AllOf(HasSubstr("space.toml:6:"), HasSubstr("power of two")));
}

TEST_F(ExploreErrors, InClocks) {
  EXPECT_THAT(refused_axes("[clock]\nmhz = [[600, 120], [500, 120]]\n"),
              AllOf(HasSubstr("space.toml:6:20: "), HasSubstr("whole number")));
  EXPECT_THAT(refused_axes("[clock]\nmhz = [600, 120]\n"), HasSubstr("a list of pairs"));
  EXPECT_THAT(refused_axes("[clock]\nmhz = [[750, 125]]\n"), HasSubstr("ends at 600 MHz"));
  EXPECT_THAT(refused_axes("[clock]\nmhz = []\n"), HasSubstr("clock has no value"));
  EXPECT_THAT(refused_axes("[machine]\nclock.cclk_mhz = [600, 500]\n"),
              AllOf(HasSubstr("space.toml:6:24: "), HasSubstr("whole number")));
}

TEST_F(ExploreErrors, InTheRest) {
  EXPECT_THAT(refused_space("[placment]\n"), HasSubstr("did you mean 'placement'?"));
  EXPECT_THAT(refused_space("[run]\nscene = \n"), HasSubstr("space.toml:2:"));
  EXPECT_THAT(refused_axes(""), HasSubstr("there is nothing to choose from"));
  EXPECT_THAT(refused_space("[run]\nscene = \"venice\"\n[clock]\nmhz = [[600, 120]]\n"),
              AllOf(HasSubstr("space.toml:1:"), HasSubstr("venice")));
  EXPECT_THAT(refused_space("[firmware]\nvariants = [\"camera.bir\", \"mesv2\"]\n"),
              AllOf(HasSubstr("space.toml:2:27: firmware 'mesv2' is not installed"),
                    HasSubstr("did you mean 'mesvs2'")));
  EXPECT_THAT(refused_axes("[clock]\nmhz = [[600, 120]]\n[sample]\nseed = 1\n"),
              HasSubstr("[sample] wants points"));
  EXPECT_THAT(refused_axes("[clock]\nmhz = [[600, 120]]\n[goal]\nframes_per_second = \"20\"\n"),
              HasSubstr("frames_per_second = \">= 20\""));
  EXPECT_THAT(refused({"explore", "absent.toml"}), HasSubstr("absent.toml"));
}

TEST_F(ExploreErrors, InMetricsEndTheExplorationButKeepResults) {
  write_space("[table]\ncolumns = [\"level.l3.bites\"]\n");
  for (const char* plan : {"2 points: 2 to simulate", "2 points: 1 known, 1 to simulate"}) {
    const Finished finished = finback({"explore", "space.toml", "--jobs", "1"});
    EXPECT_THAT(finished.err, HasSubstr(plan));
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_THAT(finished.err, HasSubstr("space.toml:8:"));
    EXPECT_THAT(finished.err, HasSubstr("did you mean level.l3.bytes?"));
  }
  write_space();
  EXPECT_THAT(finback({"explore", "space.toml", "--sort", "power_wats"}).err,
              AllOf(HasSubstr("1 known, 1 to simulate"),
                    HasSubstr("--sort power_wats: no point has a metric power_wats, did you mean "
                              "power_watts?")));
}

TEST_F(ExploreErrors, OfFilesThatCannotBe) {
  write_space();
  write("taken", "");
  EXPECT_THAT(refused({"explore", "space.toml", "--db", "taken/below.sqlite"}),
              HasSubstr("taken/below.sqlite"));
  EXPECT_THAT(refused({"explore", "space.toml", "--csv", "absent/points.csv"}),
              HasSubstr("there is no folder absent"));
  EXPECT_THAT(refused({"explore", "space.toml", "--plot", "points.jpg"}),
              HasSubstr("an .svg or a .png"));
  EXPECT_THAT(refused({"explore", "space.toml", "--point", "3"}), HasSubstr("has 2 points"));
  const Finished no_gnuplot = run_program({"/usr/bin/env", "PATH=/absent", FINBACK_PROGRAM,
                                           "explore", "space.toml", "--plot", "points.svg"},
                                          folder());
  EXPECT_EQ(no_gnuplot.exit_code, 2);
  EXPECT_THAT(no_gnuplot.err, HasSubstr("gnuplot is not installed"));
}

TEST_F(ExploreErrors, OfDatabasesLeaveThemAlone) {
  write_space();
  write("notes.txt", "not a database\n");
  EXPECT_THAT(refused({"explore", "space.toml", "--db", "notes.txt"}),
              HasSubstr("notes.txt: is no SQLite database"));
  EXPECT_EQ(read_text_file(folder() / "notes.txt"), "not a database\n");

  ASSERT_EQ(finback({"explore", "space.toml", "--db", "good.sqlite"}).exit_code, 0);
  const std::string good = read_text_file(folder() / "good.sqlite");
  const int file = ::open((folder() / "good.sqlite").c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(file, LOCK_EX), 0);
  EXPECT_THAT(refused({"explore", "space.toml", "--db", "good.sqlite"}),
              HasSubstr("another finback explore works on it"));
  ::close(file);

  sqlite3* writer = nullptr;
  sqlite3_open((folder() / "good.sqlite").c_str(), &writer);
  sqlite3_exec(writer, "BEGIN EXCLUSIVE", nullptr, nullptr, nullptr);
  EXPECT_EQ(finback({"explore", "space.toml", "--db", "good.sqlite"}).exit_code, 2);
  sqlite3_close(writer);
  EXPECT_EQ(read_text_file(folder() / "good.sqlite"), good);
}

TEST_F(ExploreErrors, OfUsage) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"explore"},
                                                    {"explore", "space.toml", "--jobs", "0"},
                                                    {"explore", "space.toml", "--point", "0"},
                                                    {"explore", "space.toml", "--limit", "-3"},
                                                    {"explore", "space.toml", "--colour"}}) {
    const Finished finished = finback(arguments);
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  }
}

}  // namespace
}  // namespace finback::cli
