// Sources, masks, latencies and the two cores' signals to each other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include <common/error.hpp>
#include <isa_sim/machine/system_interrupts.hpp>

namespace finback::machine {
namespace {

constexpr std::uint32_t kSyscr = 0x04, kMask0 = 0x0C, kMask1 = 0x10, kStatus1 = 0x18;
constexpr std::uint32_t kWakeup1 = 0x20, kAssignment0 = 0x24;
constexpr int kCoreA = 0, kCoreB = 1;

constexpr std::uint32_t second_word(int source) { return 1U << (source - 32); }

struct Change {
  int core;
  std::uint32_t pending;
  bool wake;
  Cycles at;
  friend bool operator==(const Change&, const Change&) = default;
};

class SystemInterruptsTest : public testing::Test {
 protected:
  SystemInterruptsTest() {
    SystemInterrupts::Outputs outputs;
    outputs.lines_changed = [this](int core, std::uint32_t pending, bool wake, Cycles at) {
      changes_.push_back({core, pending, wake, at});
    };
    outputs.core_b_released = [this](Cycles at) { released_.push_back(at); };
    interrupts_ = std::make_unique<SystemInterrupts>(parameters_, 5, outputs);
    for (const int core : {kCoreA, kCoreB}) {
      interrupts_->write(core, kWakeup1, 0, 0);  // wake-up has a test of its own
    }
  }
  DeviceParameters parameters_;
  std::vector<Change> changes_;
  std::vector<Cycles> released_;
  std::unique_ptr<SystemInterrupts> interrupts_;
};

TEST_F(SystemInterruptsTest, ResetValues) {
  SystemInterrupts fresh(parameters_, 5, {});
  EXPECT_EQ(fresh.read(kCoreA, kMask0), 0U);
  EXPECT_EQ(fresh.read(kCoreA, kWakeup1), 0xFFFFFFFFU);
  EXPECT_EQ(fresh.read(kCoreA, kSyscr), 0x20U);
  EXPECT_EQ(fresh.read(kCoreB, kAssignment0 + 4), 0x11111000U);      // 8 to 15
  EXPECT_EQ(fresh.read(kCoreB, kAssignment0 + 4 * 6), 0x21144444U);  // 48 to 55
  EXPECT_EQ(fresh.read(kCoreB, kAssignment0 + 4 * 7), 0x00006552U);  // 56 to 63
}

TEST_F(SystemInterruptsTest, APeripheralIsSeenAfterItsLatencyByTheCoreThatAdmitsIt) {
  interrupts_->write(kCoreA, kMask1, second_word(kMdma1Stream0), 0);
  interrupts_->set_line(kMdma1Stream0, true, 100);
  EXPECT_EQ(interrupts_->read(kCoreA, kStatus1), second_word(kMdma1Stream0));
  EXPECT_EQ(interrupts_->next_event_time(), 115U);
  interrupts_->advance(114);
  EXPECT_TRUE(changes_.empty());
  interrupts_->advance(115);
  EXPECT_EQ(changes_, (std::vector<Change>{{kCoreA, 1U << 8, false, 115}}));
  EXPECT_EQ(interrupts_->next_event_time(), kNever);
  // Falling is seen at once.
  interrupts_->set_line(kMdma1Stream0, false, 130);
  EXPECT_EQ(changes_.back(), (Change{kCoreA, 0, false, 130}));
}

TEST_F(SystemInterruptsTest, AssignmentMovesASourceToAnotherLevel) {
  interrupts_->write(kCoreB, kMask1, second_word(kMdma2Stream1), 0);
  interrupts_->write(kCoreB, kAssignment0 + 4 * 7, 0x00000004, 0);  // source 56: IVG 11
  interrupts_->set_line(kMdma2Stream1, true, 0);
  interrupts_->advance(15);
  EXPECT_EQ(changes_.back(), (Change{kCoreB, 1U << 11, false, 15}));
}

TEST_F(SystemInterruptsTest, UnmaskingShowsWhatIsPending) {
  interrupts_->set_line(kMdma1Stream1, true, 0);
  interrupts_->advance(50);
  EXPECT_TRUE(changes_.empty());
  interrupts_->write(kCoreA, kMask1, 0xFFFFFFFF, 60);
  EXPECT_EQ(changes_, (std::vector<Change>{{kCoreA, 1U << 8, false, 60}}));
  interrupts_->write(kCoreA, kMask1, 0, 70);
  EXPECT_EQ(changes_.back(), (Change{kCoreA, 0, false, 70}));
}

TEST_F(SystemInterruptsTest, WakeUpNeedsNoMask) {
  interrupts_->write(kCoreB, kWakeup1, second_word(kMdma1Stream0), 0);
  interrupts_->set_line(kMdma1Stream0, true, 0);
  interrupts_->advance(15);
  EXPECT_EQ(changes_, (std::vector<Change>{{kCoreB, 0, true, 15}}));
}

TEST_F(SystemInterruptsTest, CoresSignalEachOtherThroughSicbSyscr) {
  interrupts_->write(kCoreB, kMask1, second_word(kSupplemental0), 0);
  interrupts_->write(kCoreB, kSyscr, 1U << (6 + kCoreB), 1000);  // A raises supplemental 0 of B
  EXPECT_EQ(interrupts_->read(kCoreB, kStatus1), second_word(kSupplemental0));
  EXPECT_EQ(interrupts_->read(kCoreA, kStatus1), 0U);
  interrupts_->advance(1039);
  EXPECT_TRUE(changes_.empty());
  interrupts_->advance(1040);
  EXPECT_EQ(changes_, (std::vector<Change>{{kCoreB, 1U << 7, false, 1040}}));

  // Raising again while pending changes nothing; acknowledging clears it at once.
  interrupts_->write(kCoreB, kSyscr, 1U << (6 + kCoreB), 1050);
  EXPECT_EQ(interrupts_->next_event_time(), kNever);
  const std::uint32_t value = interrupts_->read(kCoreB, kSyscr);
  EXPECT_EQ(value, 0U);  // read, or, write must not raise it again
  interrupts_->write(kCoreB, kSyscr, value | 1U << (10 + kCoreB), 1060);
  EXPECT_EQ(changes_.back(), (Change{kCoreB, 0, false, 1060}));
  EXPECT_EQ(interrupts_->read(kCoreB, kStatus1), 0U);
}

TEST_F(SystemInterruptsTest, SupplementalOneAndCoreAHaveBitsOfTheirOwn) {
  interrupts_->write(kCoreA, kMask1, second_word(kSupplemental1), 0);
  interrupts_->write(kCoreB, kSyscr, 1U << (8 + kCoreA), 0);
  interrupts_->advance(40);
  EXPECT_EQ(changes_, (std::vector<Change>{{kCoreA, 1U << 7, false, 40}}));
  interrupts_->write(kCoreB, kSyscr, 1U << (10 + kCoreA), 50);  // acknowledges the other one
  EXPECT_EQ(changes_.size(), 1U);
  interrupts_->write(kCoreB, kSyscr, 1U << (12 + kCoreA), 60);
  EXPECT_EQ(changes_.back(), (Change{kCoreA, 0, false, 60}));
}

TEST_F(SystemInterruptsTest, AWriteThatAcknowledgesAndRaisesLeavesANewRequest) {
  interrupts_->write(kCoreA, kMask1, second_word(kSupplemental0), 0);
  interrupts_->write(kCoreB, kSyscr, 1U << 6, 0);
  interrupts_->advance(40);
  interrupts_->write(kCoreB, kSyscr, 1U << 6 | 1U << 10, 100);
  EXPECT_EQ(changes_.back(), (Change{kCoreA, 0, false, 100}));
  interrupts_->advance(140);
  EXPECT_EQ(changes_.back(), (Change{kCoreA, 1U << 7, false, 140}));
}

TEST_F(SystemInterruptsTest, AnAcknowledgedRequestThatIsStillOnItsWayIsGone) {
  interrupts_->write(kCoreA, kMask1, second_word(kSupplemental0), 0);
  interrupts_->write(kCoreB, kSyscr, 1U << 6, 0);
  interrupts_->write(kCoreB, kSyscr, 1U << 10, 10);
  EXPECT_EQ(interrupts_->next_event_time(), kNever);
  EXPECT_TRUE(changes_.empty());
}

TEST_F(SystemInterruptsTest, EventsOfDifferentLatencyKeepTheOrderOfTheirTimes) {
  interrupts_->write(kCoreA, kMask1, 0xFFFFFFFF, 0);
  interrupts_->write(kCoreB, kSyscr, 1U << 6, 0);  // visible at 40
  interrupts_->set_line(kMdma1Stream0, true, 10);  // visible at 25
  interrupts_->advance(100);
  EXPECT_EQ(changes_, (std::vector<Change>{{kCoreA, 1U << 8, false, 25},
                                           {kCoreA, 1U << 8 | 1U << 7, false, 40}}));
}

TEST_F(SystemInterruptsTest, CoreBIsReleasedOnce) {
  interrupts_->write(kCoreA, kSyscr, 0x20, 5);
  EXPECT_TRUE(released_.empty());
  interrupts_->write(kCoreA, kSyscr, 0, 10);
  interrupts_->write(kCoreA, kSyscr, 0, 20);
  EXPECT_THAT(released_, testing::ElementsAre(10));
}

TEST_F(SystemInterruptsTest, StatusIsReadOnly) {
  EXPECT_THAT([&] { interrupts_->write(kCoreB, kStatus1, 1, 0); },
              testing::ThrowsMessage<GuestFault>(testing::HasSubstr("SICB_ISR1 is read-only")));
}

}  // namespace
}  // namespace finback::machine
