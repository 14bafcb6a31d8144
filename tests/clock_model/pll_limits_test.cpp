// Which clocks and voltages the chip bears, by table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clock_model/pll_limits.hpp>

namespace finback::clock {
namespace {

using testing::HasSubstr;

// CLKIN 25 MHz.
struct Case {
  unsigned multiplier;
  std::uint32_t more_control;
  std::uint32_t divider;
  std::uint32_t regulator;
  const char* refusal;  // "": legal
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << "MSEL " << c.multiplier << " CTL " << c.more_control << " DIV " << c.divider << " VR "
       << c.regulator;
}

class Limits : public testing::TestWithParam<Case> {};

TEST_P(Limits, AreTheChips) {
  const PllParameters parameters;
  const PllLimits limits(parameters, 600, 120, 5);
  const Case& c = GetParam();
  const std::string why = limits.refusal({.control = c.multiplier << 9U | c.more_control,
                                          .divider = c.divider,
                                          .regulator = c.regulator});
  if (*c.refusal == 0) {
    EXPECT_EQ(why, "");
  } else {
    EXPECT_THAT(why, HasSubstr(c.refusal));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Settings, Limits,
    testing::Values(Case{24, 0, 0x05, 0xFB, ""},                            // 600 / 120 at 1.30 V
                    Case{24, 0, 0x15, 0xCB, ""},                            // 300 / 120 at 1.15 V
                    Case{24, 0, 0x15, 0xBB, "SCLK would be 120 MHz"},       // at 1.10 V: 100 MHz
                    Case{24, 0, 0x16, 0x7B, ""},                            // 300 / 100 at 0.90 V
                    Case{24, 0, 0x16, 0x6B, "0.85 V bear 250 MHz"},         //
                    Case{24, 0, 0x36, 0x6B, "slower than SCLK = VCO / 6"},  // CSEL 8
                    Case{24, 0, 0x38, 0x6B, ""},                            // 75 / 75
                    Case{24, 0, 0x04, 0xFB, "SCLK would be 150 MHz"},       //
                    Case{24, 0, 0x00, 0xFB, "SSEL 0 is reserved"},          //
                    Case{24, 0, 0x05, 0x5B, "VLEV 5 is reserved"},          //
                    Case{24, 0, 0x05, 0xEB, "1.25 V bear 500 MHz"},         //
                    Case{20, 0, 0x04, 0xEB, ""},                            // 500 / 125 at 1.25 V
                    Case{16, 0, 0x03, 0xFB, ""},                            // 400 / 133.33
                    Case{25, 0, 0x05, 0xFB, "50 to 600 MHz is its range"},  // 625 MHz
                    Case{0, 0, 0x0F, 0xFB, "VCO would run at 1600 MHz"},    // MSEL 0 is 64
                    Case{48, kDivideInput, 0x05, 0xFB, ""},                 // 12.5 x 48
                    Case{3, kDivideInput, 0x01, 0xFB, "run at 37.5 MHz"},   //
                    Case{3, kDivideInput | kBypass, 0x01, 0xFB, ""}));      // nobody uses the VCO

TEST(PllLimits, StartAsABootLoaderLeavesTheChip) {
  const PllParameters parameters;
  const PllLimits limits(parameters, 600, 120, 5);
  EXPECT_EQ(limits.start().control, 24U << 9U);
  EXPECT_EQ(limits.start().divider, 5U);
  EXPECT_EQ(limits.start().volts(), 1.30);
  EXPECT_EQ(limits.refusal(limits.start()), "");
  const PllLimits half(parameters, 312.5, 62.5, 5);
  EXPECT_EQ(half.start().control, 25U << 9U | kDivideInput);
  EXPECT_EQ(half.start().volts(), 0.95);
}

TEST(PllLimits, AMachineBeyondTheTableKeepsItsClocks) {
  const PllParameters parameters;
  const PllLimits limits(parameters, 750, 150, 5);
  EXPECT_EQ(limits.refusal(limits.start()), "");
  EXPECT_NE(limits.refusal({.control = 31U << 9U, .divider = 6, .regulator = 0xFB}), "");
}

TEST(PllLimits, AClockThatNoMultiplierGivesIsSaid) {
  const PllParameters parameters;
  EXPECT_THAT(PllLimits(parameters, 480, 120, 4).trouble(),
              HasSubstr("clock.cclk_mhz = 480 is no whole multiple of clock.clkin_mhz = 25"));
  EXPECT_EQ(PllLimits(parameters, 600, 120, 5).trouble(), "");
}

}  // namespace
}  // namespace finback::clock
