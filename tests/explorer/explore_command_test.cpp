// What a good exploration does: it survives being killed, simulates nothing twice, and what it
// says is the best is the best.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <gmock/gmock.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sqlite3.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "../cli/program.hpp"
#include "camera.hpp"
#include <common/file.hpp>

namespace finback::cli {
namespace {

using explorer::camera_text;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// 16 points, 64 with the second part.
constexpr std::string_view kAxes =
    "[placement]\n"
    "\"core_a.table_a\" = [\"l1.data.a\", \"l2\"]\n"
    "\"core_a.table_b\" = [\"l1.data.b\", \"l2\"]\n"
    "[clock]\n"
    "mhz = [[600, 120], [480, 120], [300, 100], [250, 125]]\n"
    "[goal]\nframes_per_second = \">= 900\"\n";
constexpr std::string_view kMoreAxes =
    "[machine]\n"
    "\"memory.l2.read_cycles\" = { from = 7, to = 10 }\n";

using Line = std::map<std::string, std::string>;

// The lines of a CSV by the names of their columns; for fields without quotes.
std::vector<Line> read_csv(const std::string& text) {
  const auto split = [](const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream stream(line + ",");
    for (std::string field; std::getline(stream, field, ',');) {
      fields.push_back(field);
    }
    return fields;
  };
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = split(line);
  std::vector<Line> lines;
  while (std::getline(stream, line)) {
    const std::vector<std::string> fields = split(line);
    lines.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) {
      lines.back()[names[i]] = fields.at(i);
    }
  }
  return lines;
}

double number(const Line& line, const std::string& column) { return std::stod(line.at(column)); }

class Explore : public ProgramTest {
 protected:
  void write_camera(unsigned rounds = 65536) const { write("camera.bir", camera_text(rounds)); }

  // How many runs a database shows to somebody who looks on.
  [[nodiscard]] int runs_in(const std::string& database) const {
    sqlite3* connection = nullptr;
    sqlite3_stmt* statement = nullptr;
    int count = 0;
    if (sqlite3_open_v2((folder() / database).c_str(), &connection, SQLITE_OPEN_READONLY,
                        nullptr) == SQLITE_OK &&
        sqlite3_prepare_v2(connection, "SELECT count(*) FROM runs", -1, &statement, nullptr) ==
            SQLITE_OK &&
        sqlite3_step(statement) == SQLITE_ROW) {
      count = sqlite3_column_int(statement, 0);
    }
    sqlite3_finalize(statement);
    sqlite3_close(connection);
    return count;
  }

  // Begins an exploration and kills it without mercy when so many of its runs are kept.
  void kill_after(int runs, const std::string& database) const {
    const pid_t child = ::fork();
    if (child == 0) {
      if (::chdir(folder().c_str()) == 0 && ::freopen("/dev/null", "w", stdout) != nullptr &&
          ::freopen("/dev/null", "w", stderr) != nullptr) {
        ::execl(FINBACK_PROGRAM, FINBACK_PROGRAM, "explore", "space.toml", "--db", database.c_str(),
                static_cast<char*>(nullptr));
      }
      ::_exit(127);
    }
    int status = 0;
    while (runs_in(database) < runs && ::waitpid(child, &status, WNOHANG) == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
  }

  // Explores into files that begin with `name`; the arguments of all runs are the same else.
  [[nodiscard]] Finished explore(const std::string& name,
                                 const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"explore", "space.toml",  "--db",   name + ".sqlite",
                                          "--csv",   name + ".csv", "--plot", name + ".svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return finback(arguments);
  }
  [[nodiscard]] std::string bytes(const std::string& file) const {
    return read_text_file(folder() / file);
  }
};

TEST_F(Explore, KilledInTheMiddleGoesOnAndEndsWithTheSameBytes) {
  write_camera(4 * 65536);
  write("space.toml",
        std::string(explorer::kCameraRun) + std::string(kAxes) + std::string(kMoreAxes));
  const Finished whole = explore("whole");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(whole.err, "space.toml: 64 points: 64 to simulate\n");

  kill_after(10, "killed.sqlite");
  const int kept = runs_in("killed.sqlite");
  ASSERT_GE(kept, 10);
  ASSERT_LT(kept, 64) << "it was done before it could be killed";
  const Finished resumed = explore("killed");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(resumed.err,
            fmt::format("space.toml: 64 points: {} known, {} to simulate\n", kept, 64 - kept));
  const Finished single = explore("single", {"--jobs", "1"});
  ASSERT_EQ(single.exit_code, 0) << single.err;

  for (const std::string other : {"killed", "single"}) {
    for (const char* extension : {".sqlite", ".csv", ".svg"}) {
      EXPECT_EQ(bytes(other + extension), bytes(std::string("whole") + extension))
          << other << extension;
    }
  }
  EXPECT_EQ(resumed.out, whole.out);
  EXPECT_EQ(single.out, whole.out);
  EXPECT_EQ(files(),
            (std::vector<std::string>{"camera.bir", "killed.csv", "killed.sqlite", "killed.svg",
                                      "single.csv", "single.sqlite", "single.svg", "space.toml",
                                      "whole.csv", "whole.sqlite", "whole.svg"}));
  const Finished again = explore("whole");
  EXPECT_EQ(again.err, "space.toml: 64 points: 64 known, 0 to simulate\n");
  EXPECT_EQ(again.out, whole.out);
}

TEST_F(Explore, FindsTheBestThatTryingAllFinds) {
  write_camera();
  write("space.toml", std::string(explorer::kCameraRun) + std::string(kAxes));
  const Finished finished = explore("all");
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const std::vector<Line> lines = read_csv(bytes("all.csv"));
  ASSERT_EQ(lines.size(), 16U);
  const Line* best = nullptr;
  for (const Line& line : lines) {
    const double rate = number(line, "frames_per_second");
    const double watts = number(line, "power_watts");
    bool beaten = false;
    for (const Line& other : lines) {
      const double its_rate = number(other, "frames_per_second");
      const double its_watts = number(other, "power_watts");
      beaten = beaten ||
               (its_rate >= rate && its_watts <= watts && (its_rate > rate || its_watts < watts));
    }
    EXPECT_EQ(line.at("front"), beaten ? "0" : "1") << line.at("point");
    if (rate >= 900 && (best == nullptr || watts < number(*best, "power_watts"))) {
      best = &line;
    }
  }
  ASSERT_NE(best, nullptr);
  EXPECT_EQ(best->at("front"), "1");
  EXPECT_THAT(finished.out, HasSubstr("Goal frames_per_second >= 900, with the least watts:\n"
                                      "  point " +
                                      best->at("point") + ": "));
}

TEST_F(Explore, TellsTheCommandThatRunsAPointAgain) {
  write_camera();
  write("space.toml", std::string(explorer::kCameraRun) + std::string(kAxes));
  ASSERT_EQ(explore("all").exit_code, 0);
  const Line line = read_csv(bytes("all.csv")).at(10);
  std::string command = line.at("command");
  EXPECT_EQ(finback({"explore", "space.toml", "--point", "11"}).out, command + "\n");
  command.replace(0, std::string("finback").size(), FINBACK_PROGRAM);
  const Finished run = run_program({"/bin/sh", "-c", command + " --out again"}, folder());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto result = nlohmann::json::parse(bytes("again/result.json"));
  EXPECT_EQ(result["frames_per_second"].get<double>(), number(line, "frames_per_second"));
  EXPECT_EQ(result["power_watts"].get<double>(), number(line, "power_watts"));
}

TEST_F(Explore, TellsWhatDoesNotFitBeforeAndAfter) {
  write_camera();
  write("space.toml", std::string(explorer::kCameraRun) +
                          "[placement]\n\"core_a.table_a\" = [\"l2\", \"l3\"]\n"
                          "\"core_a.huge_table\" = [\"l2\", \"l1.data.a\"]\n");
  const std::string why = "space.toml:7:30: l1.data.a overflows: object huge_table of core_a";
  const Finished dry = finback({"explore", "space.toml", "--dry-run"});
  EXPECT_THAT(dry.out, HasSubstr("space.toml: 4 points: 2 do not fit, 2 to simulate\n"
                                 "Does not fit, 2 points (2 4): " +
                                 why));
  const Finished finished = explore("all");
  EXPECT_EQ(finished.err, "space.toml: 4 points: 2 do not fit, 2 to simulate\n");
  EXPECT_THAT(finished.out, AllOf(HasSubstr("  does not fit [1]\n"),
                                  HasSubstr("  [1] does not fit, 2 points: " + why)));
  EXPECT_THAT(bytes("all.csv"), HasSubstr("\n2,does not fit,0,l2,l1.data.a,,,,,\"" + why));
}

TEST_F(Explore, SimulatesNothingThatAnotherSpaceDid) {
  write_camera();
  write("space.toml", std::string(explorer::kCameraRun) +
                          "[placement]\ncore_a.table_a = [\"l1.data.a\", \"l2\"]\n");
  ASSERT_EQ(explore("shared").exit_code, 0);
  write("space.toml", std::string(explorer::kCameraRun) +
                          "[placement]\n\"core_a.table_a\" = [\"l2\", \"l3\"]\n"
                          "[machine]\nmemory.l2.read_cycles = [8, 9]\n");
  EXPECT_THAT(explore("shared").err, HasSubstr("4 points: 1 known, 3 to simulate"));
}

TEST_F(Explore, KeepsFaultsAsResults) {
  write_camera();
  write("bad.bir", camera_text(65536, "  P2.L = 2; P2.H = 0xFEB0; R0 = [P2];\n"));
  write("space.toml",
        "[run]\nscene = \"synthetic\"\nframes = 1\n[firmware]\n"
        "variants = [\"camera.bir\", \"bad.bir\"]\n");
  const Finished finished = explore("all");
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, AllOf(HasSubstr("     bad.bir     fault [1]\n"),
                                  HasSubstr("  [1] fault, 1 point: "), HasSubstr("feb00002")));
  EXPECT_THAT(bytes("all.csv"),
              AllOf(HasSubstr("\n2,fault,0,bad.bir,,,,,"), Not(HasSubstr(folder().string()))));
  EXPECT_THAT(explore("all").err, HasSubstr("2 points: 2 known, 0 to simulate"));
}

TEST_F(Explore, DryRunLeavesNothing) {
  write_camera();
  write("space.toml", std::string(explorer::kCameraRun) + std::string(kAxes));
  const std::vector<std::string> before = files();
  const Finished finished = finback({"explore", "space.toml", "--dry-run"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "space.toml: 16 points: 16 to simulate\n");
  EXPECT_EQ(files(), before);
}

TEST_F(Explore, InterruptedKeepsWhatIsDone) {
  write("camera.bir", program_text(kNeverEnds));
  write("space.toml", std::string(explorer::kCameraRun) +
                          "max_seconds = 100000\n[placement]\ncore_a.stack = [\"l2\", \"l3\"]\n");
  constexpr int kWhileItRuns = 700;
  const Finished finished = finback({"explore", "space.toml"}, kWhileItRuns);
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_EQ(finished.err,
            "space.toml: 2 points: 2 to simulate\n"
            "finback: interrupted; 0 of 2 simulations are kept in out/space.sqlite; the same "
            "command goes on from there\n");
  EXPECT_EQ(finished.out, "");
}

TEST_F(Explore, ShowsAndSortsByAnyMetric) {
  write_camera();
  write("space.toml", std::string(explorer::kCameraRun) + std::string(kAxes));
  ASSERT_EQ(explore("all").exit_code, 0);
  const Finished sorted = explore("all", {"--column", "object.core_a.table_a.stall_cycles",
                                          "--sort", "latency", "--limit", "2"});
  ASSERT_EQ(sorted.exit_code, 0) << sorted.err;
  EXPECT_THAT(sorted.err, HasSubstr("16 known, 0 to simulate"));
  EXPECT_THAT(sorted.out, AllOf(HasSubstr("object.core_a.table_a.stall_cycles"),
                                HasSubstr("... and 14 more"), HasSubstr("\n      1  *  ")));
  EXPECT_THAT(bytes("all.csv"), HasSubstr(",object.core_a.table_a.stall_cycles,reason,"));
}

}  // namespace
}  // namespace finback::cli
