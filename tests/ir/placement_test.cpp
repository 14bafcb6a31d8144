// placement.toml: what it may say, and the messages for what it may not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tests/ir/support.hpp>

#include <common/pattern.hpp>
#include <isa_sim/ir/placement.hpp>

namespace finback::ir {
namespace {

using testing::ElementsAre;

std::string placement_error(const std::string& text) {
  return error_of([&] { (void)parse_placement(text, "p.toml"); });
}

TEST(Placement, ReadsAllItMaySay) {
  const Placement p = parse_placement(R"([core_a]
code    = ["l1.code", "l2"]
default = "l3"
stack   = { region = "l2", size = 8192 }
[core_a.functions]
"printf*" = "l3"
[core_a.objects]
"z_*" = "l3"
"a_?" = ["l2", "l3"]
[core_b]
stack = "l1.data.a"
[shared.objects]
"map" = "l3"
)",
                                      "p.toml");
  const OwnerPlacement& a = p.of(Owner::core_a);
  EXPECT_THAT(a.code.names, ElementsAre("l1.code", "l2"));
  EXPECT_THAT(a.defaults.names, ElementsAre("l3"));
  EXPECT_EQ(a.stack_region, "l2");
  EXPECT_EQ(a.stack_size, 8192u);
  ASSERT_EQ(a.functions.size(), 1u);
  ASSERT_EQ(a.objects.size(), 2u);
  EXPECT_EQ(a.objects[0].pattern, "z_*") << "the order of the text, not of the alphabet";
  EXPECT_EQ(a.objects[0].regions.written.to_string(), "p.toml:8:9");
  EXPECT_THAT(a.objects[1].regions.names, ElementsAre("l2", "l3"));
  const OwnerPlacement& b = p.of(Owner::core_b);
  EXPECT_EQ(b.stack_region, "l1.data.a");
  EXPECT_EQ(b.stack_size, 4096u);
  EXPECT_THAT(b.code.names, ElementsAre("l1.code", "l1.code.cache", "l2", "l3"));
  EXPECT_EQ(p.of(Owner::shared).objects.size(), 1u);
}

TEST(Placement, OverridesComeFirst) {
  Placement p = default_placement();
  p.override_object(Owner::core_b, "x", "l3");
  p.override_object(Owner::core_b, "x", "l2");
  p.override_function(Owner::core_a, "f", "l3");
  ASSERT_EQ(p.of(Owner::core_b).objects.size(), 2u);
  EXPECT_EQ(p.of(Owner::core_b).objects[0].regions.names[0], "l2");
  EXPECT_TRUE(p.of(Owner::core_b).objects[0].exact);
  EXPECT_EQ(p.of(Owner::core_a).functions.size(), 1u);
}

TEST(Placement, SaysWhatIsWrong) {
  EXPECT_EQ(placement_error("[core_c]"),
            "p.toml:1:1: unknown key 'core_c' in a placement; did you mean 'core_a'?");
  EXPECT_EQ(placement_error("[core_a]\ndefalt = \"l3\""),
            "p.toml:2:10: unknown key 'defalt' in [core_a]; did you mean 'default'?");
  EXPECT_EQ(placement_error("[shared]\nstack = \"l3\""),
            "p.toml:2:9: unknown key 'stack' in [shared]; it knows default, objects");
  EXPECT_EQ(placement_error("[core_a]\ncode = 5"),
            "p.toml:2:8: 'code' is a string or a list of strings");
  EXPECT_EQ(placement_error("[core_a]\ncode = []"),
            "p.toml:2:8: 'code' is a string or a list of strings");
  EXPECT_EQ(placement_error("[core_a]\ncode = [\"l1.code\", 5]"),
            "p.toml:2:8: 'code' is a string or a list of strings");
  EXPECT_EQ(placement_error("[core_a.objects]\nx = true"),
            "p.toml:2:5: 'x' is a string or a list of strings");
  EXPECT_EQ(placement_error("core_a = 1"), "p.toml:1:10: 'core_a' is a table: write [core_a]");
  EXPECT_EQ(placement_error("[core_a]\nstack = { region = \"l2\", size = 30 }"),
            "p.toml:2:33: a stack's size is a multiple of 4, from 64 to 67108864 bytes");
  EXPECT_EQ(placement_error("[core_a]\nstack = { size = 64 }"),
            "p.toml:2:9: 'stack' wants a region");
  EXPECT_THAT(placement_error("[core_a\n"), testing::StartsWith("p.toml:1:8: "));
}

TEST(Pattern, MatchesWholeNames) {
  EXPECT_TRUE(matches_pattern("abc", "abc"));
  EXPECT_FALSE(matches_pattern("abc", "abcd"));
  EXPECT_TRUE(matches_pattern("*", ""));
  EXPECT_TRUE(matches_pattern("a*c", "abbc"));
  EXPECT_FALSE(matches_pattern("a*c", "abcb"));
  EXPECT_TRUE(matches_pattern("*_row*", "shd_row_2"));
  EXPECT_TRUE(matches_pattern("a?c", "abc"));
  EXPECT_FALSE(matches_pattern("a?c", "ac"));
  EXPECT_TRUE(matches_pattern("a**b*", "axxb"));
  EXPECT_FALSE(matches_pattern("", "a"));
}

}  // namespace
}  // namespace finback::ir
