// Watchdogs, timers, flags and the UART as programs meet them: at their addresses, by their
// interrupts, on a whole machine.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guest_program.hpp"
#include <common/error.hpp>
#include <isa_sim/machine/peripherals.hpp>

namespace finback::machine {
namespace {

using peripheral::PinChange;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

// The handler of an event: an address in EVTn.
std::string attach(int event, const char* handler) {
  return fmt::format("P0.L = {:#x}; P0.H = 0xFFE0; R0.L = {}; R0.H = {}; [P0] = R0;\n",
                     0x2000 + 4 * event, handler, handler);
}

// Lets `events` in (bits) and sleeps until R7 is 3.
std::string wait_for_three(std::uint32_t events) {
  return fmt::format(
      "R7 = 0; R0 = {:#x} (X); STI R0;\n"
      ".Lwait: IDLE; CC = R7 == 3; IF !CC JUMP .Lwait;\nHLT;\n",
      events);
}

class PeripheralsTest : public GuestProgramTest {};

TEST_F(PeripheralsTest, AWatchdogThatNobodyServesEndsTheRun) {
  load(store(0xFFC00204, 1000) + store(0xFFC00200, 0, 2) + ".Lwait: JUMP .Lwait;");
  const StopInfo stop = run();
  EXPECT_EQ(stop.reason, Stop::exited);
  EXPECT_EQ(stop.message, "watchdog A reset the chip: nothing wrote WDOGA_STAT in time");
  EXPECT_NE(stop.exit_status, 0U);
  EXPECT_GE(stop.time, 5000U);
  EXPECT_LT(stop.time, 5100U);
}

TEST_F(PeripheralsTest, AWatchdogsNmiComesThroughEveryMask) {
  load(attach(2, "_bitten") + store(0xFFC00204, 100) + "CLI R6; R7 = 0;\n" +
           store(0xFFC00200, 2, 2) + ".Lwait: CC = R7 == 1; IF !CC JUMP .Lwait;\nHLT;\n",
       function("_bitten", "R7 = 1; RTN;"));
  EXPECT_EQ(run().message, "");
  EXPECT_EQ(machine_->state(CoreId::a).reg[isa::R7], 1U);
}

TEST_F(PeripheralsTest, AWatchdogInterruptsItsOwnCore) {
  // Source 59 goes to IVG13 after reset; only core A's watchdog reaches core A.
  load(attach(13, "_tick") + store(0xFFC00110, 1U << 27) + store(0xFFC00204, 100) +
           store(0xFFC01204, 50) + store(0xFFC01200, 4, 2) + store(0xFFC00200, 4, 2) +
           wait_for_three(1U << 13),
       function("_tick", "[--SP] = ASTAT; [--SP] = R0; [--SP] = P0;\n" +
                             store(0xFFC00200, 0x8004, 2) + store(0xFFC00208, 0) +
                             "R7 += 1; P0 = [SP++]; R0 = [SP++]; ASTAT = [SP++]; RTI;"));
  EXPECT_EQ(run().message, "");
  EXPECT_EQ(machine_->state(CoreId::a).reg[isa::R7], 3U);
}

TEST_F(PeripheralsTest, ATimerInterruptsOnceAPeriod) {
  // TIMER0 is source 35, bit 3 of IMASK1, and goes to IVG10.
  load(attach(10, "_tick") + store(0xFFC00110, 1U << 3) + store(0xFFC00600, 0x59, 2) +
           store(0xFFC00608, 2000) + store(0xFFC0060C, 1) + store(0xFFC00680, 1, 2) +
           wait_for_three(1U << 10),
       function("_tick", "[--SP] = ASTAT; [--SP] = R0; [--SP] = P0;\n" + store(0xFFC00688, 1) +
                             "R7 += 1; P0 = [SP++]; R0 = [SP++]; ASTAT = [SP++]; RTI;"));
  const StopInfo stop = run();
  EXPECT_EQ(stop.message, "");
  EXPECT_GE(stop.time, 3U * 2000 * 5);
  EXPECT_LT(stop.time, 3U * 2000 * 5 + 1000);
}

TEST_F(PeripheralsTest, AFlagThatIsDrivenInterruptsAndAnOutputIsSeen) {
  // FIO0's A is source 47, bit 15 of IMASK1, and goes to IVG11. The handler answers on PF1.
  load(attach(11, "_edge") + store(0xFFC00110, 1U << 15) + store(0xFFC00730, 2, 2) +
           store(0xFFC00738, 1, 2) + store(0xFFC0073C, 1, 2) + store(0xFFC00740, 1, 2) +
           store(0xFFC00710, 1, 2) + wait_for_three(1U << 11),
       function("_edge", "[--SP] = ASTAT; [--SP] = R0; [--SP] = P0;\n" + store(0xFFC00704, 1, 2) +
                             store(0xFFC0070C, 2, 2) +
                             "R7 += 1; P0 = [SP++]; R0 = [SP++]; ASTAT = [SP++]; RTI;"));
  std::vector<PinChange> answers;
  machine_->peripherals().drive_flags({{20'000, 0, true}, {30'000, 0, false}, {40'000, 0, true}});
  machine_->peripherals().set_flag_listener(
      [&](const PinChange& change) { answers.push_back(change); });
  EXPECT_EQ(run().message, "");
  ASSERT_EQ(answers.size(), 3U);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i].pin, 1);
    EXPECT_EQ(answers[i].level, i % 2 == 0);
    EXPECT_GT(answers[i].at, 20'000 + 10'000 * i);
    EXPECT_LT(answers[i].at, 20'200 + 10'000 * i);
  }
  EXPECT_THAT(
      [&] {
        machine_->peripherals().drive_flags({{0, 48, true}});
      },
      ThrowsMessage<InputError>("flag 48: the flags are PF0 to PF47"));
}

TEST_F(PeripheralsTest, TheUartEchoesWhatItGets) {
  // 8N1, divisor 1: 800 cycles a character. Each is read by polling DR and sent back, plus 1.
  load(store(0xFFC0040C, 0x83, 2) + store(0xFFC00400, 1, 2) + store(0xFFC0040C, 3, 2) +
       store(0xFFC00424, 1, 2) +
       "P1.L = 0x0414; P1.H = 0xFFC0; P0.L = 0x0400; P0.H = 0xFFC0; R7 = 0;\n"
       ".Lnext: R0 = W[P1] (Z); CC = BITTST(R0, 0); IF !CC JUMP .Lnext;\n"
       "R0 = W[P0] (Z); R0 += 1; W[P0] = R0; R7 += 1; CC = R7 == 3; IF !CC JUMP .Lnext;\n"
       ".Ldrain: R0 = W[P1] (Z); CC = BITTST(R0, 6); IF !CC JUMP .Ldrain;\nHLT;");
  std::string out;
  machine_->peripherals().uart().set_input({'H', 'A', 'L'});
  machine_->peripherals().uart().set_output(
      [&](std::uint8_t character) { out += static_cast<char>(character); });
  EXPECT_EQ(run().message, "");
  EXPECT_EQ(out, "IBM");
}

TEST_F(PeripheralsTest, AFaultOfADeviceNamesTheInstruction) {
  load(store(0xFFC00600, 2, 2) + "HLT;");
  EXPECT_THAT([&] { run(); },
              ThrowsMessage<GuestFault>(testing::AllOf(HasSubstr("TIMER0_CONFIG = 0x2: WDTH_CAP"),
                                                       HasSubstr("core_a in start"))));
}

}  // namespace
}  // namespace finback::machine
