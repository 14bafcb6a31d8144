// What a good run writes and prints.
#include <algorithm>
#include <gmock/gmock.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "../report/schema_check.hpp"
#include "program.hpp"
#include <common/file.hpp>
#include <scenes/luma.hpp>

namespace finback::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using Counters = std::map<std::string, std::uint64_t>;

constexpr const char* kRefresh = "scripts/refresh-traces.sh";

class Output : public ProgramTest {
 protected:
  [[nodiscard]] json result(const std::string& out) const {
    return json::parse(read_text_file(folder() / out / "result.json"));
  }
};

// One line for each counter that differs; a few, and how many more.
std::string differences(const Counters& golden, const Counters& now) {
  constexpr std::size_t kShown = 40;
  std::vector<std::string> lines;
  const auto text = [](const Counters& counters, const std::string& name) {
    const auto found = counters.find(name);
    return found == counters.end() ? "absent" : std::to_string(found->second);
  };
  std::set<std::string> names;
  for (const Counters* counters : {&golden, &now}) {
    for (const auto& [name, value] : *counters) {
      names.insert(name);
    }
  }
  for (const std::string& name : names) {
    if (text(golden, name) != text(now, name)) {
      lines.push_back(name + ": was " + text(golden, name) + ", is " + text(now, name));
    }
  }
  std::string all;
  for (std::size_t i = 0; i < std::min(kShown, lines.size()); ++i) {
    all += lines[i] + "\n";
  }
  return lines.size() > kShown ? all + "and " + std::to_string(lines.size() - kShown) + " more\n"
                               : all;
}

// Two runs are compared with each other, and with the golden trace.
TEST_F(Output, OfTheDefaultRunRepeatsAndFollowsItsGoldenTrace) {
  const std::vector<std::string> common = {"run", "--scene", "aloe", "--frames", "4"};
  for (const std::string out : {"first", "second"}) {
    std::vector<std::string> arguments = common;
    arguments.insert(arguments.end(), {"--out", out, "--trace-counters", out + ".json"});
    const Finished finished = finback(arguments);
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("\nVerdict: "));
    EXPECT_THAT(finished.out, HasSubstr("bad_pixels"));
  }
  for (const char* file : {"result.json", "disparity_0000.png", "disparity_0003.png"}) {
    EXPECT_EQ(read_text_file(folder() / "first" / file), read_text_file(folder() / "second" / file))
        << file << " differs between two runs";
  }
  EXPECT_EQ(files(),
            (std::vector<std::string>{
                "first", "first.json", "first/disparity_0000.png", "first/disparity_0001.png",
                "first/disparity_0002.png", "first/disparity_0003.png", "first/result.json",
                "second", "second.json", "second/disparity_0000.png", "second/disparity_0001.png",
                "second/disparity_0002.png", "second/disparity_0003.png", "second/result.json"}));

  const json schema = json::parse(read_text_file(FINBACK_SOURCE_DIR "/report/result.schema.json"));
  EXPECT_EQ(report::schema_complaints(schema, result("first")), std::vector<std::string>{});

  const json golden = json::parse(read_text_file(FINBACK_SOURCE_DIR "/traces/mesvs2_aloe.json"));
  const json now = json::parse(read_text_file(folder() / "first.json"));
  EXPECT_EQ(differences(golden.get<Counters>(), now.get<Counters>()), "")
      << "if this is meant, run " << kRefresh << " and review the change";
}

// What functions and lines moved is what their cores moved, level by level.
void expect_equal_bytes(const json& r) {
  for (const auto& [name, core] : r["cores"].items()) {
    for (const auto& [level, initiators] : r["traffic"].items()) {
      const std::uint64_t moved = initiators[name]["read_bytes"].get<std::uint64_t>() +
                                  initiators[name]["write_bytes"].get<std::uint64_t>();
      for (const char* rows : {"functions", "lines"}) {
        std::uint64_t sum = 0;
        for (const json& row : r[rows]) {
          sum += row["core"] == name ? row["bytes"].value(level, std::uint64_t{0}) : 0;
        }
        EXPECT_EQ(sum, moved) << name << " " << level << " " << rows;
      }
    }
  }
}

// What a core waited for memory is what its accesses to objects cost.
void expect_equal_stalls(const json& r) {
  for (const auto& [name, core] : r["cores"].items()) {
    std::uint64_t by_object = 0;
    for (const json& object : r["objects"]) {
      by_object += object["accesses"].contains(name)
                       ? object["accesses"][name]["stall_cycles"].get<std::uint64_t>()
                       : 0;
    }
    std::uint64_t by_cause = 0;
    for (const char* cause : {"l2_read", "l2_write", "l3_read", "l3_write"}) {
      by_cause += core["stall_cycles"][cause].get<std::uint64_t>();
    }
    EXPECT_EQ(by_object, by_cause) << name;
  }
}

TEST_F(Output, AddsUp) {
  // Buffers in L2 and L3, so that there is something to sum.
  const Finished finished =
      finback({"run", "--scene", "synthetic", "--frames", "2", "--place",
               "core_b.shd_left_words=l2", "--place", "core_b.left_codes=l3", "--out", "o"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const json r = result("o");
  for (const auto& [name, core] : r["cores"].items()) {
    ASSERT_TRUE(core["started"].get<bool>()) << name;
    std::uint64_t cycles = core["issue_cycles"];
    for (const auto& [cause, stall] : core["stall_cycles"].items()) {
      cycles += stall.get<std::uint64_t>();
    }
    EXPECT_EQ(cycles, core["cycles"]) << name;
    std::uint64_t exclusive = 0;
    for (const json& function : r["functions"]) {
      exclusive += function["core"] == name ? function["exclusive_cycles"].get<std::uint64_t>() : 0;
    }
    EXPECT_EQ(exclusive, core["cycles"]) << name;
    std::uint64_t line_cycles = 0;
    for (const json& line : r["lines"]) {
      line_cycles += line["core"] == name ? line["cycles"].get<std::uint64_t>() : 0;
    }
    EXPECT_EQ(line_cycles, core["cycles"]) << name;
  }
  expect_equal_bytes(r);
  expect_equal_stalls(r);
  // Bytes by object sum to bytes by level.
  for (const auto& [level, initiators] : r["traffic"].items()) {
    for (const auto& [initiator, bytes] : initiators.items()) {
      std::uint64_t read = 0;
      std::uint64_t written = 0;
      for (const json& object : r["objects"]) {
        if (object["level"] == level && object["accesses"].contains(initiator)) {
          read += object["accesses"][initiator]["read_bytes"].get<std::uint64_t>();
          written += object["accesses"][initiator]["write_bytes"].get<std::uint64_t>();
        }
      }
      EXPECT_EQ(read, bytes["read_bytes"]) << level << " " << initiator;
      EXPECT_EQ(written, bytes["write_bytes"]) << level << " " << initiator;
    }
  }
  double watts = 0;
  for (const json& part : r["power"]["components"]) {
    watts += part["watts"].get<double>();
  }
  EXPECT_NEAR(watts, r["power_watts"].get<double>(), 1e-9);
  EXPECT_GT(r["frames_per_second"].get<double>(), 0);
  EXPECT_FALSE(r["accuracy"].is_null());
  EXPECT_FALSE(r["stages"].empty());
}

TEST_F(Output, OfOwnPicturesHasNoAccuracy) {
  // A colour-free texture of odd size; the right view sees everything 20 pixels further left.
  constexpr int kWidth = 700;
  constexpr int kHeight = 500;
  scenes::ByteImage left(kWidth, kHeight);
  scenes::ByteImage right(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      left.at(x, y) = static_cast<std::uint8_t>((x / 4 * 37 + y / 4 * 91 + x / 4 * (y / 4)) % 251);
    }
  }
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      right.at(x, y) = left.at(std::min(x + 20, kWidth - 1), y);
    }
  }
  scenes::write_png(left, folder() / "left.png");
  scenes::write_png(right, folder() / "right.png");
  const Finished finished =
      finback({"run", "--left", "left.png", "--right", "right.png", "--frames", "1", "--out", "o"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(result("o")["accuracy"].is_null());
  const scenes::ByteImage map = scenes::load_luma(folder() / "o" / "disparity_0000.png");
  EXPECT_EQ(map.width(), 160);
  EXPECT_EQ(map.height(), 120);
}

TEST_F(Output, OfABareProgramHasNoFrames) {
  write("main.bir", program_text(kReturnsZero));
  const Finished finished = finback({"run", "--firmware", "main.bir", "--out", "o"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const json r = result("o");
  EXPECT_EQ(r["frames"], json::array());
  EXPECT_EQ(r["frames_per_second"], 0.0);
  EXPECT_FALSE(r["cores"]["core_b"]["started"].get<bool>());
  // There is no rate to miss.
  EXPECT_FALSE(r["targets"].contains("frames_per_second"));
  EXPECT_THAT(finished.out, HasSubstr("\nVerdict: pass\n"));
}

TEST_F(Output, IsOfThePlacementAndTheMachineThatOptionsName) {
  const Finished finished =
      finback({"run", "--scene", "synthetic", "--frames", "1", "--place", "shared.hand_over_*=l3",
               "--place", "shared.hand_over_left=l2", "--place", "core_a.stack=l1.data.a", "--set",
               "clock.cclk_mhz=480", "--out", "o"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const json r = result("o");
  EXPECT_EQ(r["core_hertz"], 480e6);
  std::map<std::string, std::string> regions;
  for (const json& object : r["objects"]) {
    regions[object["owner"].get<std::string>() + "." + object["name"].get<std::string>()] =
        object["region"];
  }
  EXPECT_EQ(regions["shared.hand_over_left"], "l2");
  EXPECT_EQ(regions["shared.hand_over_right"], "l3");
  EXPECT_EQ(regions["core_a.stack"], "l1.data.a");
  EXPECT_EQ(r["provenance"]["placement"]["name"], "placement.toml + 5 moved");
}

TEST_F(Output, IsOfTheFilesInFlash) {
  write("main.bir", program_text("  P0.L = 8;\n  P0.H = 0x2000;\n  R0 = B[P0] (Z);\n"
                                 "  R1 = 56;\n  R0 = R0 - R1;\n  RTS;\n"));
  write("table.bin", "12345678");
  const std::vector<std::string> run = {"run", "--firmware", "main.bir", "--out", "o", "--flash"};
  const auto with = [&](const std::string& flash) {
    std::vector<std::string> arguments = run;
    arguments.push_back(flash);
    return finback(arguments);
  };
  Finished finished = with("table.bin@0x20000001");
  EXPECT_THAT(finished.err, HasSubstr("'0x20000001' is no address"));
  ASSERT_EQ(with("table.bin@0x20000004").exit_code, 2) << "the byte at 8 is '5'";
  finished = with("table=table.bin@0x20000008");
  EXPECT_EQ(finished.exit_code, 2);
  write("table.bin", "8");
  finished = with("table=table.bin@0x20000008");
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const json r = result("o");
  const auto table = std::ranges::find_if(
      r["objects"], [](const json& object) { return object["name"] == "table"; });
  ASSERT_NE(table, r["objects"].end());
  EXPECT_EQ((*table)["region"], "flash");
}

TEST_F(Output, OfARunTableHasItsCamerasAndItsFlash) {
  write("main.bir", program_text(kReturnsZero));
  write("table.bin", "12345678");
  const auto check = [&](const std::string& line) {
    write("b.toml", "[run]\nfirmware = \"main.bir\"\n" + line +
                        "\n[limits]\nmemory.shared.flash.used_bytes = \"== 8\"\n");
    return finback({"check", "b.toml"});
  };
  EXPECT_EQ(check("").exit_code, 3);
  Finished finished = check(
      "flash = [\"table=table.bin\"]\ncamera_rate = 60\ndistort = [0.1, 0.01]\n"
      "misalign = [0.5, 1, 2]\ndrop_frame = [\"left:2\"]\nlate_frame = [\"3:5\"]");
  EXPECT_EQ(finished.exit_code, 0) << finished.err << finished.out;
  EXPECT_THAT(check("distort = [0.1]").err, HasSubstr("b.toml:3:11: distort wants [k1, k2]"));
  EXPECT_THAT(check("camera_rate = 0").err, HasSubstr("b.toml:3:15: camera_rate wants"));
  EXPECT_THAT(check("frames_from = \"nowhere\"").err, HasSubstr("nowhere"));
}

TEST_F(Output, TellsHowDeepTheStackWas) {
  const auto used = [&](const std::string& pushes) {
    write("main.bir",
          program_text("  R0 = 0 (X);\n" + pushes + "  SP += " +
                       std::to_string(4 * std::count(pushes.begin(), pushes.end(), ';')) +
                       ";\n  RTS;\n"));
    const Finished finished = finback({"run", "--firmware", "main.bir", "--out", "o"});
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return result("o")["cores"]["core_a"]["stack_used_bytes"].get<int>();
  };
  const std::string push = "  [--SP] = R0;\n";
  EXPECT_EQ(used(push + push + push + push) - used(push), 12);
}

TEST_F(Output, HasNoTraceOfWhereItRan) {
  write("main.bir", program_text(kReturnsZero));
  const Finished finished = finback({"run", "--firmware", "main.bir", "--out", "o"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const std::string text = read_text_file(folder() / "o" / "result.json");
  EXPECT_EQ(text.find(folder().string()), std::string::npos);
  EXPECT_EQ(text.find(FINBACK_SOURCE_DIR), std::string::npos);
}

TEST_F(Output, ReplacesThatOfAnEarlierRun) {
  write("main.bir", program_text(kReturnsZero));
  const std::vector<std::string> run = {"run", "--firmware", "main.bir", "--out", "o"};
  ASSERT_EQ(finback(run).exit_code, 0);
  write("o/result.json", "old");
  ASSERT_EQ(finback(run).exit_code, 0);
  EXPECT_EQ(result("o")["schema_version"], 1);
  EXPECT_EQ(files(), (std::vector<std::string>{"main.bir", "o", "o/result.json"}));
}

TEST_F(Output, LeavesNoMapsOfALongerRun) {
  for (const char* frames : {"3", "1"}) {
    const Finished finished =
        finback({"run", "--scene", "synthetic", "--frames", frames, "--out", "o"});
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"o", "o/disparity_0000.png", "o/result.json"}));
}

TEST_F(Output, OfHelpAndVersion) {
  const Finished version = finback({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, ::testing::MatchesRegex("finback [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  const Finished help = finback({"run", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("finback run --scene aloe --frames 4 --out out/aloe"));
}

TEST_F(Output, OfMachineListsParameters) {
  const Finished finished = finback({"machine"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_THAT(finished.out, HasSubstr("memory.l2.read_cycles"));
  EXPECT_THAT(finished.out, HasSubstr("clock.cclk_mhz"));
  const Finished power = finback({"machine", "--power"});
  EXPECT_EQ(power.exit_code, 0);
  EXPECT_THAT(power.out, HasSubstr("junction_celsius"));
}

TEST_F(Output, OfIsaListsInstructions) {
  const Finished finished = finback({"isa"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_THAT(finished.out, HasSubstr("| `Dl = ONES D` | 4 | dsp | 1 |"));
}

// DMA that is not waited for, and DMA that is.
TEST_F(Output, RacesAreToldAndEndWithThree) {
  const std::string copy =
      ".global _start\n_start: P4.L = 0x1F00; P4.H = 0xFFC0;\n"
      "P0.L = LO(words); P0.H = HI(words); R1 = P0;\n"
      "R0 = 0x4000 (X); [P4 + 0x44] = R0; [P4 + 4] = R1;\n"
      "R0 = 4 (X); W[P4 + 0x50] = R0; W[P4 + 0x10] = R0; W[P4 + 0x54] = R0; W[P4 + 0x14] = R0;\n"
      "R0 = 9 (X); W[P4 + 0x48] = R0; R0 = 11 (X); W[P4 + 8] = R0; SSYNC;\n";
  const std::string end =
      "R2 = [P0];\nP1 = 1000 (X); LSETUP (pause, pause) LC0 = P1;\npause: NOP;\nR0 = 0 (X); P4.L = "
      "0xF020; [P4] = R0;\nsleep: IDLE; JUMP sleep;\n"
      ".data\n.global words\nwords: .space 16\n";
  write("hasty.s", copy + end);
  write("patient.s",
        copy + "wait: R0 = W[P4 + 0x28] (Z); CC = BITTST(R0, 0); IF !CC JUMP wait;\n" + end);
  const auto run = [&](const char* firmware) {
    return finback({"run", "--firmware", firmware, "--scene", "synthetic", "--check-races"});
  };
  const Finished hasty = run("hasty.s");
  EXPECT_EQ(hasty.exit_code, 3) << hasty.err;
  EXPECT_THAT(hasty.out, HasSubstr("Race on words+0 of core_a"));
  EXPECT_THAT(hasty.out, HasSubstr("\n  core_a reads in start (0x"));
  EXPECT_THAT(hasty.out, HasSubstr("\n  mdma1_0 writes, commanded by core_a in start (0x"));
  EXPECT_THAT(hasty.out, HasSubstr("1 race; docs/races.md"));
  const Finished patient = run("patient.s");
  EXPECT_EQ(patient.exit_code, 0) << patient.err;
  EXPECT_THAT(patient.out, HasSubstr("\nNo races.\n"));
}

TEST_F(Output, InstalledMachinesGoByName) {
  write("one.s", "_start: HLT;\n");
  EXPECT_EQ(finback({"exec", "one.s", "--environment", "chip", "--machine", "one_core"}).exit_code,
            0);
  const Finished two = finback(
      {"exec", "one.s", "--core-b", "one.s", "--environment", "chip", "--machine", "one_core"});
  EXPECT_EQ(two.exit_code, 2);
  EXPECT_THAT(two.err, HasSubstr("has code for core_b, which this machine does not have"));
  const Finished typo = finback({"run", "--machine", "half_l2"});
  EXPECT_EQ(typo.exit_code, 2);
  EXPECT_THAT(typo.err, HasSubstr("machine 'half_l2' is not installed, did you mean 'half_l1'; "
                                  "known: bf561, fast_l2, half_l1, one_core"));
  const Finished page = finback({"machine", "fast_l2"});
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_THAT(page.out,
              HasSubstr("  l2             shared   l2    0xfeb00000    256 KB  code, data\n"));
  EXPECT_THAT(page.out,
              HasSubstr("\n  memory.l2.read_cycles                4 CCLK instead of 9\n"));
}

// A machine changes when, never what.
TEST_F(Output, MapsAreTheSameOnAMachineWithLessMemory) {
  for (const std::string machine : {"bf561", "half_l1"}) {
    const Finished run = finback(
        {"run", "--scene", "synthetic", "--frames", "1", "--machine", machine, "--out", machine});
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }
  EXPECT_EQ(read_text_file(folder() / "bf561" / "disparity_0000.png"),
            read_text_file(folder() / "half_l1" / "disparity_0000.png"));
  EXPECT_GT(result("half_l1")["counters"]["core_b.stall.l2_read.cycles"],
            result("bf561")["counters"]["core_b.stall.l2_read.cycles"]);
}

}  // namespace
}  // namespace finback::cli
