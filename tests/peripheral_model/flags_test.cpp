// Programmable flags: outputs, inputs, edges and their interrupts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <peripheral_model/flags.hpp>

namespace finback::peripheral {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint32_t kData = 0x00, kClear = 0x04, kSet = 0x08, kToggle = 0x0C, kMaskA = 0x10,
                        kMaskB = 0x20, kDirection = 0x30, kPolarity = 0x34, kEdge = 0x38,
                        kBoth = 0x3C, kInputs = 0x40;

class FlagsTest : public testing::Test {
 protected:
  void write(std::uint32_t offset, std::uint32_t value, Cycles now = 0) {
    flags_.write(offset, 2, value, now);
  }
  std::uint32_t read(std::uint32_t offset) { return flags_.read(offset, 2, 0); }

  std::vector<std::tuple<int, bool, Cycles>> lines_;
  std::vector<std::tuple<Cycles, int, bool>> pins_;
  Flags flags_{
      1,
      {.line = [this](int mask, bool level, Cycles at) { lines_.emplace_back(mask, level, at); },
       .changed =
           [this](const PinChange& change) {
             pins_.emplace_back(change.at, change.pin, change.level);
           }}};
};

TEST_F(FlagsTest, EveryGroupCanBeWrittenClearedSetAndToggled) {
  write(kDirection, 0xFFFF);
  for (const std::uint32_t group : {kData, kMaskA, kMaskB}) {
    write(group, 0x00FF);
    write(group + kSet, 0x0F00);
    write(group + kClear, 0x000F);
    write(group + kToggle, 0x8010);
    for (const std::uint32_t action : {0U, 4U, 8U, 12U}) {
      EXPECT_EQ(read(group + action), 0x8FE0U);
    }
  }
}

TEST_F(FlagsTest, OutputsAreToldWithTheirTimeAndPin) {
  write(kSet, 0x0003, 10);
  EXPECT_THAT(pins_, IsEmpty()) << "inputs as yet";
  write(kDirection, 0x0006, 20);
  write(kToggle, 0x0006, 30);
  write(kToggle, 0x0001, 40);
  write(kDirection, 0, 50);
  using Pin = std::tuple<Cycles, int, bool>;
  EXPECT_THAT(pins_, ElementsAre(Pin(20, 17, true), Pin(30, 17, false), Pin(30, 18, true),
                                 Pin(50, 18, false)));
}

TEST_F(FlagsTest, LevelsOfInputsFollowThePinWherePolarityTurnsThem) {
  flags_.drive({{100, 16, true}, {200, 19, true}, {300, 16, false}});
  write(kPolarity, 0x0008);
  EXPECT_EQ(read(kData), 0U) << "not enabled";
  write(kInputs, 0x0009);
  EXPECT_EQ(read(kData), 0x0008U);
  EXPECT_EQ(flags_.next_event_time(), 100U);
  flags_.advance(100);
  EXPECT_EQ(read(kData), 0x0009U);
  flags_.advance(250);
  EXPECT_EQ(read(kData), 0x0001U);
  flags_.advance(300);
  EXPECT_EQ(read(kData), 0U);
  EXPECT_EQ(flags_.next_event_time(), kNever);
}

TEST_F(FlagsTest, EdgesStayUntilTheyAreCleared) {
  flags_.drive({{10, 16, true}, {20, 16, false}, {30, 17, true}, {40, 17, false}, {50, 18, true}});
  write(kEdge, 0x0007);
  write(kInputs, 0x0007);
  write(kPolarity, 0x0002);  // PF17 falling
  write(kBoth, 0x0001);
  flags_.advance(10);
  EXPECT_EQ(read(kData), 1U);
  write(kClear, 1);
  EXPECT_EQ(read(kData), 0U);
  flags_.advance(20);
  EXPECT_EQ(read(kData), 1U) << "the other edge, too";
  flags_.advance(30);
  EXPECT_EQ(read(kData), 1U);
  flags_.advance(40);
  EXPECT_EQ(read(kData), 3U);
  flags_.advance(50);
  EXPECT_EQ(read(kData), 7U);
}

TEST_F(FlagsTest, EachMaskHasALine) {
  flags_.drive({{10, 16, true}, {20, 31, true}});
  write(kInputs, 0x8001);
  write(kEdge, 0x8000);
  write(kMaskA, 0x0001);
  write(kMaskB, 0x8000);
  flags_.advance(10);
  flags_.advance(20);
  write(kClear, 0x8000, 25);
  write(kMaskA + kClear, 0x0001, 30);
  using Line = std::tuple<int, bool, Cycles>;
  EXPECT_THAT(lines_, ElementsAre(Line(0, true, 10), Line(1, true, 20), Line(1, false, 25),
                                  Line(0, false, 30)));
}

TEST_F(FlagsTest, AnOutputCanInterrupt) {
  write(kDirection, 1);
  write(kMaskB, 1);
  write(kSet, 1, 5);
  EXPECT_THAT(lines_, ElementsAre(std::tuple(1, true, Cycles{5})));
}

}  // namespace
}  // namespace finback::peripheral
