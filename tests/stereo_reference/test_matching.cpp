#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "random_images.hpp"
#include <common/error.hpp>
#include <stereo_reference/matching.hpp>

namespace finback::stereo_reference {
namespace {

using testing::AllOf;
using testing::HasSubstr;

ByteImage row_of(std::initializer_list<int> values) {
  ByteImage image(static_cast<int>(values.size()), 1);
  int x = 0;
  for (const int value : values) {
    image.at(x++, 0) = static_cast<std::uint8_t>(value);
  }
  return image;
}

std::string error_of(const ByteImage& left, const ByteImage& right, const MatchParameters& p) {
  try {
    (void)match_recursive(left, right, p);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// Window 1, disparities 1..3, one row; Hamming distances by hand:
//   left   x:  0    1    2    3    4    5
//   left      00   FF   0F   01   03   FF
//   right     FF   0F   01   07   00   FF
//   x = 1: d=1 FF^FF=0                            -> 1
//   x = 2: d=1 0F^0F=0  d=2 0F^FF=4               -> 1
//   x = 3: d=1 01^01=0  d=2 01^0F=3  d=3 01^FF=7  -> 1
//   x = 4: d=1 03^07=1  d=2 03^01=1  d=3 03^0F=2  -> 1, the tie keeps the smaller
//   x = 5: d=1 FF^00=8  d=2 FF^07=5  d=3 FF^01=7  -> 2
TEST(Matching, HandWorkedRow) {
  const ByteImage left = row_of({0x00, 0xFF, 0x0F, 0x01, 0x03, 0xFF});
  const ByteImage right = row_of({0xFF, 0x0F, 0x01, 0x07, 0x00, 0xFF});
  const MatchParameters p{1, 1, 3};
  EXPECT_EQ(match_left_plain(left, right, p), row_of({0, 1, 1, 1, 1, 2}));
  // Right x, its candidates being left x + d: 0 -> d=1 (0, 4, 7); 1 -> d=1 (0, 3, 2);
  // 2 -> d=1 (0, 1, 7); 3 -> d=1 (1), d=2 (5); 4 -> d=1 (8); 5 has none.
  EXPECT_EQ(match_right_plain(left, right, p), row_of({1, 1, 1, 1, 1, 0}));
  const DisparityPair maps = match_recursive(left, right, p);
  EXPECT_EQ(maps.left, row_of({0, 1, 1, 1, 1, 2}));
  EXPECT_EQ(maps.right, row_of({1, 1, 1, 1, 1, 0}));
  // x = 5 goes to right 3, which says 1: |1 - 2| <= 1 keeps it, threshold 0 does not.
  EXPECT_EQ(check_left_right(maps, 1), row_of({0, 1, 1, 1, 1, 2}));
  EXPECT_EQ(check_left_right(maps, 0), row_of({0, 1, 1, 1, 1, 0}));
}

TEST(Matching, TiesKeepTheSmallestDisparityInBothViews) {
  const ByteImage flat(30, 9, 0);
  const MatchParameters p{3, 4, 9};
  const DisparityPair maps = match_recursive(flat, flat, p);
  for (int y = 1; y < 8; ++y) {
    for (int x = 0; x < 30; ++x) {
      EXPECT_EQ(maps.left.at(x, y), x >= 5 && x <= 28 ? 4 : 0) << x;
      EXPECT_EQ(maps.right.at(x, y), x >= 1 && x <= 24 ? 4 : 0) << x;
    }
  }
}

TEST(Matching, ShiftedPairGivesTheShiftWhereverItIsACandidate) {
  std::mt19937 generator(11);
  for (const int disparity : {5, 12, 35}) {
    const ByteImage left = test::random_image(generator, 160, 40);
    const ByteImage right = test::shifted(generator, left, disparity);
    const MatchParameters p;
    const ByteImage map = disparity_map(left, right, p);
    // One column more than the window needs: the census of the outermost column looks beyond it.
    for (int y = 7; y < 33; ++y) {
      for (int x = 7 + disparity + 1; x <= 152; ++x) {
        ASSERT_EQ(map.at(x, y), disparity) << x << "," << y;
      }
    }
  }
}

TEST(Matching, NothingIsComputedOutsideTheRegion) {
  std::mt19937 generator(12);
  const ByteImage left = test::random_image(generator, 50, 30);
  const ByteImage right = test::random_image(generator, 50, 30);
  const MatchParameters p{7, 3, 12};
  const Region region = computed_region(50, 30, p);
  EXPECT_EQ(region, (Region{6, 3, 47, 27}));
  const ByteImage map = match_recursive(left, right, p).left;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 50; ++x) {
      const bool inside =
          x >= region.left && x < region.right && y >= region.top && y < region.bottom;
      EXPECT_EQ(map.at(x, y) != 0, inside) << x << "," << y;
    }
  }
}

struct Case {
  int width;
  int height;
  MatchParameters parameters;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.width << "x" << c.height << " window " << c.parameters.window << " disparities "
       << c.parameters.disparity_min << ".." << c.parameters.disparity_max;
}

class RecursionEqualsPlain : public testing::TestWithParam<Case> {};

TEST_P(RecursionEqualsPlain, InBothViews) {
  const auto& [width, height, parameters] = GetParam();
  std::mt19937 generator(static_cast<unsigned>(width * 1000 + height));
  // Few levels make many ties, many make few.
  for (const unsigned levels : {2U, 4U, 256U}) {
    const ByteImage left = test::random_image(generator, width, height, levels);
    const ByteImage right = test::random_image(generator, width, height, levels);
    const DisparityPair maps = match_recursive(left, right, parameters);
    EXPECT_EQ(maps.left, match_left_plain(left, right, parameters));
    EXPECT_EQ(maps.right, match_right_plain(left, right, parameters));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, RecursionEqualsPlain,
                         testing::Values(Case{40, 30, {1, 1, 1}}, Case{40, 30, {1, 1, 16}},
                                         Case{40, 30, {3, 2, 9}}, Case{41, 23, {5, 5, 35}},
                                         Case{64, 17, {15, 5, 35}}, Case{80, 31, {9, 1, 64}},
                                         Case{37, 37, {13, 7, 7}}, Case{16, 15, {15, 1, 30}},
                                         Case{25, 9, {9, 3, 255}}, Case{300, 5, {5, 200, 255}},
                                         Case{160, 40, {15, 5, 35}}, Case{53, 60, {21, 4, 20}}));

TEST(Matching, LeftRightCheckDropsAnOccludedStrip) {
  // A near plate (disparity 12) before a far wall (disparity 5): the wall's 7 columns left of the
  // plate are hidden from the right view.
  std::mt19937 generator(13);
  const ByteImage wall = test::random_image(generator, 120, 40);
  const ByteImage plate = test::random_image(generator, 120, 40);
  ByteImage left = wall;
  ByteImage right = test::shifted(generator, wall, 5);
  for (int y = 0; y < 40; ++y) {
    for (int x = 60; x < 100; ++x) {
      left.at(x, y) = plate.at(x, y);
      right.at(x - 12, y) = plate.at(x, y);
    }
  }
  const ByteImage map = disparity_map(left, right, {5, 1, 20});
  for (int y = 5; y < 35; ++y) {
    EXPECT_EQ(map.at(45, y), 5);
    EXPECT_EQ(map.at(80, y), 12);
    EXPECT_EQ(map.at(56, y), 0) << "row " << y;
  }
}

TEST(Matching, CheckAsksForAValidOppositePixel) {
  DisparityPair maps{row_of({0, 1, 0, 3}), row_of({0, 0, 0, 0})};
  EXPECT_EQ(check_left_right(maps, 5), row_of({0, 0, 0, 0}));
  maps.right = row_of({2, 0, 0, 0});
  EXPECT_EQ(check_left_right(maps, 1), row_of({0, 1, 0, 3}));
  // A disparity that leads out of the image has no opposite pixel.
  maps.left = row_of({0, 2, 0, 0});
  EXPECT_EQ(check_left_right(maps, 1), row_of({0, 0, 0, 0}));
}

TEST(Matching, ErrorsNameWhatIsWrong) {
  const ByteImage image(40, 20, 0);
  EXPECT_THAT(error_of(image, ByteImage(41, 20, 0), {}),
              AllOf(HasSubstr("40x20"), HasSubstr("41x20"), HasSubstr("same size")));
  EXPECT_THAT(error_of(image, image, {4, 1, 5}), HasSubstr("matching window 4: it must be an odd"));
  EXPECT_THAT(error_of(image, image, {-1, 1, 5}), HasSubstr("matching window -1"));
  EXPECT_THAT(error_of(image, image, {3, 6, 5}), HasSubstr("disparities 6..5"));
  EXPECT_THAT(error_of(image, image, {3, 0, 5}), HasSubstr("0 marks invalid pixels"));
  EXPECT_THAT(error_of(image, image, {3, 1, 256}), HasSubstr("disparities 1..256"));
  EXPECT_THAT(error_of(image, image, {21, 1, 5}), HasSubstr("40x20: too small for a window of 21"));
  EXPECT_THAT(error_of(image, image, {15, 26, 30}), HasSubstr("at least 41x15 needed"));
  EXPECT_EQ(error_of(image, image, {15, 25, 30}), "no error");
  EXPECT_THROW((void)check_left_right({ByteImage(3, 3), ByteImage(3, 4)}), InputError);
  EXPECT_THROW((void)check_left_right({ByteImage(3, 3), ByteImage(3, 3)}, -1), InputError);
}

}  // namespace
}  // namespace finback::stereo_reference
