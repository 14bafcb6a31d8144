// Reading a result back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "small_result.hpp"
#include <common/error.hpp>
#include <report/json_reader.hpp>
#include <report/json_writer.hpp>

namespace finback::report {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;

// The message for a document changed by `change`.
template <class Change>
std::string message_for(const Change& change) {
  ordered_json document = ordered_json::parse(to_json(small_result()));
  change(document);
  try {
    (void)parse_result(document.dump(), "r.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadResult, GivesBackWhatWasWritten) {
  const std::string text = to_json(small_result());
  EXPECT_EQ(to_json(parse_result(text, "r.json")), text);
}

TEST(ReadResult, WithoutTruthGivesBackWhatWasWritten) {
  RunResult result = small_result();
  result.accuracy.reset();
  result.frames.clear();
  result.targets.clear();
  const std::string text = to_json(result);
  EXPECT_EQ(to_json(parse_result(text, "r.json")), text);
}

RunResult clocked_result() {
  RunResult result = small_result();
  const clock::OperatingPoint fast{clock::Mode::full_on, 600e6, 120e6, 1.3};
  const clock::OperatingPoint slow{clock::Mode::full_on, 300e6, 100e6, 0.9};
  result.clocks = clock::ClockHistory(fast);
  result.clocks.change(result.cycles / 2, slow);
  result.points = {{fast, result.cycles / 2, 0.01, 2.0}, {slow, result.cycles / 2, 0.02, 1.0}};
  return result;
}

TEST(ReadResult, GivesBackTheClocks) {
  const RunResult result = clocked_result();
  EXPECT_DOUBLE_EQ(result.seconds(), static_cast<double>(result.cycles) / 400e6);
  const std::string text = to_json(result);
  const RunResult back = parse_result(text, "r.json");
  EXPECT_EQ(to_json(back), text);
  EXPECT_EQ(back.seconds(), result.seconds());
}

TEST(ReadResult, OfAnOlderVersionHasOneClock) {
  ordered_json document = ordered_json::parse(to_json(small_result()));
  document.erase("clocks");
  const RunResult result = parse_result(document.dump(), "r.json");
  EXPECT_FALSE(result.clocks.changed());
  EXPECT_EQ(result.seconds(), small_result().seconds());
}

TEST(ReadResult, OfAnUnknownModeSaysSo) {
  ordered_json document = ordered_json::parse(to_json(clocked_result()));
  document["clocks"]["segments"][1]["mode"] = "turbo";
  EXPECT_THAT([&] { (void)parse_result(document.dump(), "r.json"); },
              testing::ThrowsMessage<InputError>(
                  HasSubstr("clocks.segments[1].mode wants a mode such as full_on")));
}

TEST(ReadResult, OfNewerKeysPassesThemOver) {
  EXPECT_EQ(message_for([](ordered_json& d) { d["weather"] = "fine"; }), "");
}

TEST(ReadResult, NamesWhatIsWrong) {
  EXPECT_THAT(message_for([](ordered_json& d) { d.erase("cycles"); }),
              HasSubstr("r.json: cycles is missing"));
  EXPECT_THAT(message_for([](ordered_json& d) { d["cores"]["core_a"].erase("packets"); }),
              HasSubstr("r.json: cores.core_a.packets is missing"));
  EXPECT_EQ(message_for([](ordered_json& d) { d["functions"][1]["calls"] = "three"; }),
            "r.json: functions[1].calls wants a whole number, not below 0");
  EXPECT_EQ(message_for([](ordered_json& d) { d["cycles"] = -1; }),
            "r.json: cycles wants a whole number, not below 0");
  EXPECT_EQ(message_for([](ordered_json& d) { d["lines"] = 7; }), "r.json: lines wants a list");
  EXPECT_THAT(message_for([](ordered_json& d) { d["schema_version"] = 2; }),
              HasSubstr("r.json: schema_version is 2, this program reads 1"));
}

TEST(ReadResult, OfNoJsonSaysSo) {
  EXPECT_THROW((void)parse_result("{", "r.json"), InputError);
  EXPECT_THROW((void)parse_result("[]", "r.json"), InputError);
  EXPECT_THROW((void)parse_result("", "r.json"), InputError);
}

}  // namespace
}  // namespace finback::report
