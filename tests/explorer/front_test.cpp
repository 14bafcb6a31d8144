// The Pareto front of speed against power.
#include <gmock/gmock.h>

#include <explorer/front.hpp>

namespace finback::explorer {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Front, OfNothingIsEmpty) { EXPECT_THAT(pareto_front({}), IsEmpty()); }

TEST(Front, OfOnePointIsThatPoint) { EXPECT_THAT(pareto_front({{20, 1}}), ElementsAre(true)); }

TEST(Front, HoldsWhatNothingElseBeatsInBoth) {
  EXPECT_THAT(pareto_front({{20, 1.0}, {30, 2.0}, {19, 1.1}, {25, 1.5}, {25, 1.6}, {24, 1.5}}),
              ElementsAre(true, true, false, true, false, false));
}

TEST(Front, HoldsEqualPointsTogether) {
  EXPECT_THAT(pareto_front({{20, 1}, {20, 1}, {10, 1}, {20, 2}}),
              ElementsAre(true, true, false, false));
}

TEST(Front, IsWhatComparingAllWithAllFinds) {
  std::vector<Merit> points;
  points.reserve(200);
  for (int i = 0; i < 200; ++i) {
    points.push_back({static_cast<double>(i * 7919 % 31), static_cast<double>(i * 104729 % 37)});
  }
  const std::vector<bool> front = pareto_front(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool beaten = false;
    for (const Merit& other : points) {
      const bool no_worse =
          other.frames_per_second >= points[i].frames_per_second && other.watts <= points[i].watts;
      const bool better =
          other.frames_per_second > points[i].frames_per_second || other.watts < points[i].watts;
      beaten = beaten || (no_worse && better);
    }
    EXPECT_EQ(front[i], !beaten) << i;
  }
}

}  // namespace
}  // namespace finback::explorer
