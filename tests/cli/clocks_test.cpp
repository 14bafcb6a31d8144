// Clocks as a user sees them: docs/clocks.md, both cores, results.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "page_examples.hpp"
#include "program.hpp"

namespace finback::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class Clocks : public ProgramTest {
 protected:
  // The result of a program of both cores.
  json result_of(const std::vector<std::string>& more) {
    std::vector<std::string> command = {"exec",     "--environment", "chip",   "a.s",
                                        "--core-b", "b.s",           "--json", "-"};
    command.insert(command.end(), more.begin(), more.end());
    const Finished finished = finback(command);
    EXPECT_EQ(finished.err, "");
    return json::parse(finished.out)["result"];
  }
};

TEST_F(Clocks, ThePagesExampleRuns) { check_page_examples("clocks.md", folder().string()); }

// Core A asks for 500 MHz and sleeps; core B works for 100000 cycles before it sleeps, too.
TEST_F(Clocks, AChangeWaitsForBothCores) {
  write("a.s",
        "__start: P0.L = 0x0104; P0.H = 0xFFC0; R0 = 0 (X); W[P0] = R0; SSYNC;\n"
        "P0.L = 0; R0.L = 0x2800; W[P0] = R0; SSYNC; IDLE; HLT;\n");
  write("b.s",
        "__start: P1.L = LO(100000); P1.H = HI(100000);\nLSETUP (1f, 1f) LC0 = P1;\n1: NOP;\n"
        "2: IDLE; JUMP 2b;\n");
  const json both = result_of({});
  ASSERT_EQ(both["clocks"]["segments"].size(), 3U);
  EXPECT_GT(both["clocks"]["segments"][1]["from_cycle"], 100000);
  EXPECT_EQ(both["clocks"]["segments"][2]["core_hertz"], 500e6);
  const json one = result_of({"--set", "clock.both_cores_idle=0"});
  EXPECT_LT(one["clocks"]["segments"][1]["from_cycle"], 1000);
}

// A program that works for a tenth of the time and hibernates has that average power.
TEST_F(Clocks, EnergyIsSummedOverTheModes) {
  write("a.s",
        "__start: P1.L = LO(60000); P1.H = HI(60000);\nLSETUP (1f, 1f) LC0 = P1;\n1: NOP;\n"
        "P0.L = 8; P0.H = 0xFFC0; R0 = 0xF8 (Z); W[P0] = R0; SSYNC; IDLE; HLT;\n");
  const Finished finished = finback({"exec", "--environment", "chip", "a.s", "--json", "-",
                                     "--summary", "--set", "clock.reset_after_us=900"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_THAT(finished.err, HasSubstr("hibernate"));
  const json result = json::parse(finished.out)["result"];
  const json& points = result["clocks"]["points"];
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(result["seconds"], 1e-3, 1e-6);
  EXPECT_NEAR(points[1]["seconds"], 9e-4, 1e-9);
  EXPECT_LT(points[1]["watts"], points[0]["watts"].get<double>() / 3);
  EXPECT_NEAR(result["power_watts"],
              (points[0]["joules"].get<double>() + points[1]["joules"].get<double>()) /
                  result["seconds"].get<double>(),
              1e-9);
}

TEST_F(Clocks, HibernationThatNothingEndsIsAnError) {
  write("a.s", "__start: P0.L = 8; P0.H = 0xFFC0; R0 = 0xF8 (Z); W[P0] = R0; SSYNC; IDLE; HLT;\n");
  const Finished finished = finback({"exec", "--environment", "chip", "a.s"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_THAT(finished.err, HasSubstr("a.s: the chip is in hibernate, which only RESET ends"));
}

}  // namespace
}  // namespace finback::cli
