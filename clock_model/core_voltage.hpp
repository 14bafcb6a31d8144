// How fast the core may be clocked at which voltage: the vendor's table of the speed grade SBB600.
//
// Source: ADI's own driver table (hardware.md 5.1). The power model and the PLL's checks read it.
#pragma once

#include <array>

namespace finback::clock {

struct SpeedGrade {
  double megahertz = 0;
  double volts = 0;
};

// Ascending; VLEV of VR_CTL counts them from kFirstVoltageLevel.
inline constexpr std::array<SpeedGrade, 10> kSpeedGrades = {{{250, 0.85},
                                                             {300, 0.90},
                                                             {313, 0.95},
                                                             {350, 1.00},
                                                             {400, 1.05},
                                                             {444, 1.10},
                                                             {450, 1.15},
                                                             {475, 1.20},
                                                             {500, 1.25},
                                                             {600, 1.30}}};
inline constexpr unsigned kFirstVoltageLevel = 6;

// The first at which the core may be clocked at `megahertz`; nullptr when there is none.
[[nodiscard]] constexpr const SpeedGrade* grade_for(double megahertz) {
  for (const SpeedGrade& grade : kSpeedGrades) {
    if (megahertz <= grade.megahertz) {
      return &grade;
    }
  }
  return nullptr;
}

}  // namespace finback::clock
