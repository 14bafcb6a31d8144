// What points run, and when two of them are one simulation.
#include <filesystem>
#include <gmock/gmock.h>
#include <set>
#include <unistd.h>

#include "camera.hpp"
#include <common/file.hpp>
#include <explorer/candidate.hpp>
#include <explorer/exploration.hpp>

namespace finback::explorer {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class Candidates : public ::testing::Test {
 public:
  ~Candidates() override { fs::remove_all(folder_); }

 protected:
  Candidates() {
    std::string pattern = (fs::temp_directory_path() / "finback-test-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    write_file_whole(folder_ / "camera.bir", camera_text());
  }

  [[nodiscard]] Space space(const std::string& axes, const std::string& run = "") const {
    return parse_space(
        "[run]\nfirmware = \"camera.bir\"\nscene = \"synthetic\"\nframes = 1\n" + run + axes,
        (folder_ / "space.toml").string());
  }
  static std::vector<Candidate> candidates_of(const Space& space) {
    return prepare(space, points_of(space));
  }
  // How many simulations the points of a space are.
  [[nodiscard]] std::size_t keys_of(const std::string& axes) const {
    std::set<std::string> keys;
    for (const Candidate& candidate : candidates_of(space(axes))) {
      keys.insert(candidate.identity.key);
    }
    return keys.size();
  }
  [[nodiscard]] std::string first_key(const std::string& axes, const std::string& run = "") const {
    return candidates_of(space(axes, run)).at(0).identity.key;
  }

  fs::path folder_;
};

constexpr const char* kTable = "[placement]\n\"core_a.table_a\" = [\"l1.data.b\"]\n";

TEST_F(Candidates, DifferByEveryAxis) {
  EXPECT_EQ(keys_of("[placement]\n\"core_a.table_a\" = [\"l1.data.a\", \"l2\", \"l3\"]\n"
                    "[machine]\nmemory.l2.read_cycles = { from = 7, to = 9 }\n"
                    "[clock]\nmhz = [[600, 120], [300, 100]]\n"),
            18U);
}

TEST_F(Candidates, ThatComeOutEqualAreOneSimulation) {
  EXPECT_EQ(first_key(kTable), first_key("[machine]\nmemory.l2.read_cycles = [9]\n",
                                         "place = \"core_a.table_a=l1.data.b\"\n"));
  EXPECT_EQ(keys_of("[machine]\nmemory.l2.read_cycles = [8, 9]\n"), 2U);
}

TEST_F(Candidates, KnowWhatTheyDependOn) {
  const std::string key = first_key(kTable);
  EXPECT_EQ(first_key(kTable), key);
  EXPECT_NE(first_key(kTable, "max_seconds = 3\n"), key);
  EXPECT_NE(first_key(kTable, "set = \"core.branch.taken_cycles=6\"\n"), key);
  write_file_whole(folder_ / "power.toml", "[power.board]\nother_watts = 0.2\n");
  EXPECT_NE(first_key(kTable, "power = \"power.toml\"\n"), key);
  write_file_whole(folder_ / "camera.bir", camera_text(131072));
  EXPECT_NE(first_key(kTable), key);
}

TEST_F(Candidates, WhoseImageChangesAreOthersThoughTheirAddressesStay) {
  const std::vector<Candidate> before = candidates_of(space(kTable));
  write_file_whole(folder_ / "camera.bir", camera_text(131072));
  const std::vector<Candidate> after = candidates_of(space(kTable));
  EXPECT_NE(before[0].identity.image_hash, after[0].identity.image_hash);
}

TEST_F(Candidates, ThatDoNotFitSayWhyInALineWithoutFolders) {
  const std::vector<Candidate> candidates =
      candidates_of(space("[placement]\n\"core_a.huge_table\" = [\"l2\", \"l1.data.a\"]\n"));
  EXPECT_EQ(candidates[0].misfit, "");
  EXPECT_THAT(candidates[1].misfit,
              HasSubstr("space.toml:6:30: l1.data.a overflows: object huge_table of core_a"));
  EXPECT_EQ(candidates[1].misfit.find_first_of("/\n"), std::string::npos);
}

TEST_F(Candidates, HaveTheirTimeLimitAtTheirOwnClock) {
  const Space s = space("[clock]\nmhz = [[600, 120], [300, 100]]\n", "max_seconds = 2\n");
  EXPECT_EQ(inputs_of(s, {0}).cycle_limit, 1'200'000'000U);
  EXPECT_EQ(inputs_of(s, {1}).cycle_limit, 600'000'000U);
}

TEST_F(Candidates, MoveAllThatAPatternMatches) {
  const Space s = space("[placement]\n\"core_a.table_?\" = [\"l2\", \"l3\"]\n");
  EXPECT_THAT(run_command(s, {1}),
              HasSubstr(" --place core_a.table_a=l3 --place core_a.table_b=l3"));
}

TEST_F(Candidates, ArePlannedOnce) {
  std::vector<Candidate> candidates(6);
  const std::vector<const char*> keys = {"a", "b", "a", "", "c", "b"};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    candidates[i].identity.key = keys[i];
    candidates[i].misfit = i == 3 ? "too large" : "";
  }
  const Plan plan = plan_of(candidates, {"c", "of another space"});
  EXPECT_EQ(plan.to_simulate, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(plan.to_string(),
            "6 points: 1 does not fit, 2 equal to another, 1 known, 2 to simulate");
}

}  // namespace
}  // namespace finback::explorer
