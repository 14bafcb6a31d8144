#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <memory_model/clock_parameters.hpp>
#include <memory_model/memory_map.hpp>

namespace finback::memory {
namespace {

TEST(MemoryMap, RegionsAreOrderedAndApart) {
  const MemoryMap map = bf561_map();
  for (std::size_t i = 1; i < map.regions.size(); ++i) {
    const Region& before = map.regions[i - 1];
    EXPECT_LE(std::uint64_t{before.base} + before.size, map.regions[i].base) << before.name;
  }
}

TEST(MemoryMap, OnChipMemoryIs328KilobytesAsTheDataSheetSays) {
  std::uint32_t bytes = 0;
  for (const Region& region : bf561_map().regions) {
    bytes += region.level == Level::l3 ? 0 : region.size;
  }
  EXPECT_EQ(bytes, 328U * 1024);
}

TEST(MemoryMap, FindsTheRegionOfAnAddress) {
  const MemoryMap map = bf561_map();
  EXPECT_EQ(map.find(0)->name, "l3");
  EXPECT_EQ(map.find(0x03FFFFFF)->name, "l3");
  EXPECT_EQ(map.find(0x04000000), nullptr);
  EXPECT_EQ(map.find(0xFEAFFFFF), nullptr);
  EXPECT_EQ(map.find(0xFEB00000)->name, "l2");
  EXPECT_EQ(map.find(0xFF807FFF)->name, "l1.data.a");
  EXPECT_EQ(map.find(0xFF808000), nullptr);
  EXPECT_EQ(map.find(0xFFFFFFFF), nullptr);
}

TEST(MemoryMap, ANameMeansTheCoresOwnRegion) {
  const MemoryMap map = bf561_map();
  EXPECT_EQ(map.find(0, "l1.data.b")->base, 0xFF900000);
  EXPECT_EQ(map.find(1, "l1.data.b")->base, 0xFF500000);
  EXPECT_EQ(map.find(0, "l2"), map.find(1, "l2"));
  EXPECT_EQ(map.find(-1, "l1.data.b"), nullptr);
  EXPECT_EQ(map.find(0, "l4"), nullptr);
  EXPECT_THAT(map.names(-1), testing::ElementsAre("l3", "flash", "l2"));
  EXPECT_THAT(map.names(1), testing::ElementsAre("l3", "flash", "l2", "l1.data.a", "l1.data.b",
                                                 "l1.code", "l1.code.cache", "l1.scratch"));
}

TEST(ClockParameters, TheRatioIsWhole) {
  ClockParameters clock;
  EXPECT_EQ(clock.ratio(), 5U);
  clock.sclk_mhz.set(100);
  EXPECT_EQ(clock.ratio(), 6U);
  clock.sclk_mhz.set(133);
  try {
    static_cast<void>(clock.ratio());
    FAIL() << "600 / 133 was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("clock.sclk_mhz = 133"));
    EXPECT_THAT(error.what(), testing::HasSubstr("whole number from 1 to 15"));
  }
}

}  // namespace
}  // namespace finback::memory
