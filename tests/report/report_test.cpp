// The writers, on a small result made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "schema_check.hpp"
#include "small_result.hpp"
#include <common/file.hpp>
#include <report/json_writer.hpp>
#include <report/text_writer.hpp>

namespace finback::report {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

json schema() {
  return json::parse(read_text_file(FINBACK_SOURCE_DIR "/report/result.schema.json"));
}

TEST(FramesPerSecond, IsTheSteadyState) {
  EXPECT_DOUBLE_EQ(frames_per_second(small_result().frames, kCoreHertz), 600e6 / 25e6);
}

TEST(FramesPerSecond, OfOneFrameIsItsLatency) {
  EXPECT_DOUBLE_EQ(frames_per_second({{0, 10'000'000, 40'000'000}}, kCoreHertz), 20);
}

TEST(FramesPerSecond, WithoutFramesIsZero) {
  EXPECT_DOUBLE_EQ(frames_per_second({}, kCoreHertz), 0);
}

TEST(Verdict, PassesAndNamesWhatFails) {
  RunResult r = small_result();
  EXPECT_EQ(verdict(r), "pass");
  r.targets[0].value = 19.994;
  EXPECT_EQ(verdict(r), "fail: frames_per_second is 19.99 fps, wanted >= 20");
  r.targets[1].value = 2.5;
  EXPECT_EQ(
      verdict(r),
      "fail: frames_per_second is 19.99 fps, wanted >= 20; power_watts is 2.50 W, wanted <= 2.3");
}

TEST(Target, PassesOnItsLimit) {
  EXPECT_TRUE((Target{"a", ">=", 20, 20, ""}).passed());
  EXPECT_TRUE((Target{"a", "<=", 2.3, 2.3, ""}).passed());
  EXPECT_FALSE((Target{"a", ">=", 20, 19.999, ""}).passed());
  EXPECT_FALSE((Target{"a", "<=", 2.3, 2.301, ""}).passed());
}

// Published test vectors of FNV-1a, 64 bits.
TEST(ContentHash, IsFnv1a) {
  EXPECT_EQ(content_hash(""), "fnv1a:cbf29ce484222325");
  EXPECT_EQ(content_hash("a"), "fnv1a:af63dc4c8601ec8c");
  EXPECT_EQ(content_hash("foobar"), "fnv1a:85944171f73967e8");
}

TEST(Json, FollowsItsSchema) {
  const RunResult r = small_result();
  EXPECT_EQ(schema_complaints(schema(), json::parse(to_json(r))), std::vector<std::string>{});
}

TEST(Json, WithoutTruthOrFramesFollowsItsSchemaToo) {
  RunResult r = small_result();
  r.accuracy.reset();
  r.frames.clear();
  r.stages.clear();
  r.objects.clear();
  const json document = json::parse(to_json(r));
  EXPECT_EQ(schema_complaints(schema(), document), std::vector<std::string>{});
  EXPECT_TRUE(document["accuracy"].is_null());
}

TEST(Json, HoldsTheNumbers) {
  const json document = json::parse(to_json(small_result()));
  EXPECT_EQ(document["schema_version"], 1);
  EXPECT_EQ(document["frames_per_second"], 24.0);
  EXPECT_EQ(document["targets"]["frames_per_second"]["verdict"], "pass");
  EXPECT_EQ(document["cores"]["core_a"]["issue_cycles"], 50);
  EXPECT_EQ(document["cores"]["core_a"]["stall_cycles"],
            json::parse(R"({"idle":30,"l3_read":20})"));
  EXPECT_EQ(document["cores"]["core_b"]["started"], false);
  EXPECT_EQ(document["functions"][0]["inclusive_cycles"], 90);
  EXPECT_EQ(document["functions"][0]["exclusive_cycles"], 60);
  EXPECT_EQ(document["traffic"]["l3"]["core_a"]["read_bytes"], 3'000'000);
  EXPECT_EQ(document["objects"][0]["accesses"]["core_a"]["stall_cycles"], 400);
  EXPECT_EQ(document["counters"]["core_a.instructions"], 60);
  EXPECT_TRUE(document["memory"][1]["core"].is_null());
}

TEST(Json, KeepsCountsExact) {
  RunResult r = small_result();
  r.cycles = 9'007'199'254'740'993;  // 2^53 + 1: not a double
  EXPECT_EQ(json::parse(to_json(r))["cycles"].get<Cycles>(), r.cycles);
}

TEST(Json, IsTheSameBytesTwice) { EXPECT_EQ(to_json(small_result()), to_json(small_result())); }

TEST(Text, ShowsWhatMatters) {
  const std::string text = to_text(small_result());
  EXPECT_THAT(text, HasSubstr("firmware mesvs2, scene aloe, placement default, machine bf561"));
  EXPECT_THAT(text, HasSubstr("frames_per_second       24.00 fps   target >= 20     pass"));
  EXPECT_THAT(text, HasSubstr("bad_pixels              25.00 %"));
  EXPECT_THAT(text, HasSubstr("rectification             core_a         1000000"));
  EXPECT_THAT(text, HasSubstr("core_b (never started)"));
  EXPECT_THAT(text, HasSubstr("l3                    core_a        1.00 MB         200 B"));
  EXPECT_THAT(text, HasSubstr("core_a.dynamic"));
  EXPECT_THAT(text, ::testing::EndsWith("\nVerdict: pass\n"));
}

TEST(Text, LeavesOutWhatIsNothing) {
  const std::string text = to_text(small_result());
  EXPECT_THAT(text, ::testing::Not(HasSubstr("mdma1_0")));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("never_called")));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("l1.data.a")));
}

TEST(Text, FitsATerminal) {
  std::string line;
  std::istringstream text(to_text(small_result()));
  while (std::getline(text, line)) {
    EXPECT_LE(line.size(), 100U) << line;
  }
}

}  // namespace
}  // namespace finback::report
