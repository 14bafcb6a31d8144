#include <cmath>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <stereo_reference/evaluation.hpp>

namespace finback::stereo_reference {
namespace {

// Six pixels in a row: exact, one off, more than one off, invalid, unknown truth, exact.
ByteImage example_map() {
  ByteImage map(6, 1);
  const int values[] = {10, 11, 13, 0, 9, 20};
  for (int x = 0; x < 6; ++x) {
    map.at(x, 0) = static_cast<std::uint8_t>(values[x]);
  }
  return map;
}

FloatImage example_truth() {
  FloatImage truth(6, 1);
  const float values[] = {10.0F, 10.0F, 11.5F, 8.0F, 0.0F, 20.0F};
  for (int x = 0; x < 6; ++x) {
    truth.at(x, 0) = values[x];
  }
  return truth;
}

TEST(Evaluation, CountsBadPixelsByHand) {
  const MapQuality q = evaluate(example_map(), example_truth(), inner_region(6, 1, 0));
  EXPECT_EQ(q.compared, 5);
  EXPECT_EQ(q.invalid, 1);
  EXPECT_EQ(q.wrong, 1);  // 13 against 11.5; an error of exactly delta is not bad
  EXPECT_DOUBLE_EQ(q.bad_percent(), 40.0);
  EXPECT_DOUBLE_EQ(q.wrong_percent(), 25.0);
  EXPECT_DOUBLE_EQ(q.rms_error, std::sqrt((1.0 + 1.5 * 1.5 + 64.0) / 5));
  EXPECT_DOUBLE_EQ(q.rms_error_valid, std::sqrt((1.0 + 1.5 * 1.5) / 4));
}

TEST(Evaluation, DeltaAndRegionDecideWhatCounts) {
  EXPECT_EQ(evaluate(example_map(), example_truth(), {0, 0, 6, 1}, 0.5).wrong, 2);
  EXPECT_EQ(evaluate(example_map(), example_truth(), {0, 0, 6, 1}, 1.5).wrong, 0);
  const MapQuality q = evaluate(example_map(), example_truth(), {2, 0, 4, 1});
  EXPECT_EQ(q.compared, 2);
  EXPECT_EQ(q.wrong, 1);
  EXPECT_EQ(q.invalid, 1);
}

TEST(Evaluation, NothingComparedGivesZeros) {
  const MapQuality q = evaluate(example_map(), FloatImage(6, 1), {0, 0, 6, 1});
  EXPECT_EQ(q.compared, 0);
  EXPECT_EQ(q.bad_percent(), 0);
  EXPECT_EQ(q.wrong_percent(), 0);
  EXPECT_EQ(q.rms_error, 0);
}

TEST(Evaluation, RejectsWhatDoesNotFit) {
  EXPECT_THROW((void)evaluate(example_map(), FloatImage(5, 1), {0, 0, 5, 1}), InputError);
  EXPECT_THROW((void)evaluate(example_map(), example_truth(), {0, 0, 7, 1}), InputError);
  EXPECT_THROW((void)evaluate(example_map(), example_truth(), inner_region(6, 1, 1)), InputError);
  EXPECT_THROW((void)evaluate(example_map(), example_truth(), {0, 0, 6, 1}, -1), InputError);
}

}  // namespace
}  // namespace finback::stereo_reference
