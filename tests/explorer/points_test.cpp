// Which points are looked at, and in what order.
#include <gmock/gmock.h>
#include <set>

#include <common/error.hpp>
#include <explorer/points.hpp>

namespace finback::explorer {
namespace {

using ::testing::ElementsAre;

// Axes with so many choices each.
Space space_of(const std::vector<std::size_t>& choices) {
  Space space;
  space.file = "space.toml";
  for (const std::size_t count : choices) {
    space.axes.emplace_back();
    space.axes.back().choices.resize(count);
  }
  return space;
}

TEST(Points, OfAGridCountWithTheLastAxisFastest) {
  EXPECT_THAT(points_of(space_of({2, 1, 3})),
              ElementsAre(Point{0, 0, 0}, Point{0, 0, 1}, Point{0, 0, 2}, Point{1, 0, 0},
                          Point{1, 0, 1}, Point{1, 0, 2}));
}

// The numbers are fixed: another drawing would make every space another one.
TEST(Points, OfASampleAreTheSameOnEveryComputer) {
  Space space = space_of({10, 10, 10});
  space.sample = Sample{4, 1};
  const std::vector<Point> first = points_of(space);
  EXPECT_THAT(first, ElementsAre(Point{0, 5, 6}, Point{2, 4, 6}, Point{5, 7, 8}, Point{6, 8, 4}));
  space.sample->seed = 2;
  EXPECT_NE(points_of(space), first);
}

TEST(Points, OfASampleAreDifferentAndInTheGridsOrder) {
  Space space = space_of({7, 5, 3});
  for (std::uint64_t count = 1; count <= 105; count += 13) {
    space.sample = Sample{count, 3};
    const std::vector<Point> points = points_of(space);
    EXPECT_EQ(points.size(), count);
    EXPECT_TRUE(std::ranges::is_sorted(points));
    EXPECT_EQ(std::set<Point>(points.begin(), points.end()).size(), count);
  }
}

TEST(Points, OfASampleReachEveryPartOfTheGrid) {
  Space space = space_of({4, 250});
  space.sample = Sample{400, 1};
  std::array<int, 4> by_first{};
  for (const Point& point : points_of(space)) {
    ++by_first.at(point[0]);
  }
  for (const int count : by_first) {
    EXPECT_NEAR(count, 100, 25);
  }
}

TEST(Points, OfASampleLargerThanTheGridAreTheGrid) {
  Space space = space_of({2, 3});
  const std::vector<Point> grid = points_of(space);
  space.sample = Sample{7, 1};
  EXPECT_EQ(points_of(space), grid);
}

TEST(Points, OfAGridBeyondAllMeasureAreRefused) {
  Space space = space_of({100, 100, 100});
  EXPECT_THROW(static_cast<void>(points_of(space)), InputError);
  space.sample = Sample{10, 1};
  EXPECT_EQ(points_of(space).size(), 10U);
  space = space_of(std::vector<std::size_t>(64, 2));
  space.sample = Sample{10, 1};
  EXPECT_THROW(static_cast<void>(points_of(space)), InputError);
}

}  // namespace
}  // namespace finback::explorer
