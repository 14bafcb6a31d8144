// The 2-D walk against its rule, element by element.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <dma_model/address_generator.hpp>

namespace finback::dma {
namespace {

// hardware.md 3.1: X_MODIFY after each element except the last of a row, then Y_MODIFY instead.
std::vector<Address> by_the_rule(const TransferShape& shape) {
  std::vector<Address> addresses;
  Address address = shape.start;
  for (std::uint32_t y = 0; y < shape.y_count; ++y) {
    for (std::uint32_t x = 0; x < shape.x_count; ++x) {
      addresses.push_back(address);
      address += static_cast<Address>(x + 1 < shape.x_count ? shape.x_modify : shape.y_modify);
    }
  }
  return addresses;
}

std::vector<Address> by_bursts(const TransferShape& shape, std::uint32_t burst) {
  AddressGenerator generator(shape);
  std::vector<Address> addresses;
  while (!generator.finished()) {
    std::vector<memory::DmaRun> runs;
    generator.take(burst, runs);
    std::uint32_t elements = 0;
    for (const memory::DmaRun& run : runs) {
      elements += run.count;
      for (std::uint32_t i = 0; i < run.count; ++i) {
        addresses.push_back(run.address + i * static_cast<Address>(run.stride));
      }
    }
    EXPECT_LE(elements, burst);
    EXPECT_GT(elements, 0U);
  }
  return addresses;
}

TEST(AddressGenerator, FollowsTheRuleForEveryBurstLength) {
  const std::vector<TransferShape> shapes = {
      {.start = 100, .x_count = 10, .x_modify = 1},
      {.start = 100, .x_count = 1, .x_modify = 4, .y_count = 7, .y_modify = -12},
      {.start = 0, .x_count = 160, .x_modify = 4, .y_count = 12, .y_modify = 4 + 3 * 640},
      {.start = 64, .element_bytes = 4, .x_count = 5, .x_modify = 4, .y_count = 5, .y_modify = 4},
      {.start = 900, .x_count = 9, .x_modify = -3, .y_count = 4, .y_modify = 50},
      {.start = 8, .x_count = 3, .x_modify = 0, .y_count = 3, .y_modify = 0},
  };
  for (const TransferShape& shape : shapes) {
    for (const std::uint32_t burst : {1U, 3U, 16U, 64U}) {
      EXPECT_EQ(by_bursts(shape, burst), by_the_rule(shape)) << shape.start << ' ' << burst;
    }
  }
}

TEST(AddressGenerator, AContiguousBlockIsOneRunEvenAcrossRows) {
  AddressGenerator generator(
      {.element_bytes = 4, .x_count = 8, .x_modify = 4, .y_count = 8, .y_modify = 4});
  std::vector<memory::DmaRun> runs;
  generator.take(64, runs);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].count, 64U);
  EXPECT_TRUE(generator.finished());
}

TEST(AddressGenerator, TellsWhereItStands) {
  AddressGenerator generator(
      {.start = 16, .x_count = 4, .x_modify = 2, .y_count = 2, .y_modify = 100});
  std::vector<memory::DmaRun> runs;
  generator.take(3, runs);
  EXPECT_EQ(generator.address(), 16U + 6);
  EXPECT_EQ(generator.columns_left(), 1U);
  EXPECT_EQ(generator.rows_left(), 2U);
  generator.take(1, runs);
  EXPECT_EQ(generator.address(), 16U + 6 + 100);
  EXPECT_EQ(generator.columns_left(), 4U);
  EXPECT_EQ(generator.rows_done(), 1U);
}

}  // namespace
}  // namespace finback::dma
