// The numbers of the power model, each declared once. Source: hardware.md section 5; what comes
// from memory or is an estimate says so in its certainty.
#pragma once

#include <common/parameter.hpp>

namespace finback::power {

struct PowerParameters : ParameterGroup {
  // Core supply.
  RealParameter core_volts{
      this,
      {"power.core.volts", "V", 0, 0, 1.5, 'V', "hardware.md 5.1 (SBB600)",
       "core supply voltage; 0 takes the lowest that the core clock allows from the table"}};
  RealParameter junction_celsius{this,
                                 {"power.core.junction_celsius", "C", 50, -40, 125, 'E',
                                  "hardware.md 5.5", "junction temperature"}};
  RealParameter leakage_milliamperes{
      this,
      {"power.core.leakage_milliamperes", "mA", 130, 0, 1000, 'E', "hardware.md 5.2",
       "leakage of both cores at 25 C and 1.25 V; grows with exp(dT/50) and V^2"}};
  RealParameter core_dynamic{
      this,
      {"power.core.dynamic", "mA/(V MHz)", 0.30, 0, 10, 'D', "hardware.md 5.2",
       "dynamic current of one core at activity 1 (IDD-TYP)"}};
  RealParameter shared_dynamic{this,
                               {"power.core.shared_dynamic", "mA/(V MHz)", 0.12, 0, 10, 'D',
                                "hardware.md 5.2", "dynamic current of L2 and fabric, by CCLK"}};
  RealParameter system_dynamic{
      this,
      {"power.core.system_dynamic", "mA/(V MHz)", 0.55, 0, 10, 'E', "hardware.md 5.2 (DS518)",
       "dynamic current of the system clock's domain, by SCLK"}};
  RealParameter regulator_efficiency{
      this,
      {"power.core.regulator_efficiency", "", 0.80, 0.1, 1, 'E', "hardware.md 5.4",
       "efficiency of the internal switching regulator"}};

  // Activity scaling factors: what a cycle costs beside a cycle of IDD-TYP.
  RealParameter activity_idle{this,
                              {"power.activity.idle", "", 0.43, 0, 2, 'V',
                               "hardware.md 5.2 (EE-297)", "a cycle asleep in IDLE"}};
  RealParameter activity_nop{this,
                             {"power.activity.nop", "", 0.72, 0, 2, 'V', "hardware.md 5.2 (EE-297)",
                              "a cycle that issues nothing: a NOP or a stall"}};
  RealParameter activity_access{this,
                                {"power.activity.access", "", 0.88, 0, 2, 'E',
                                 "hardware.md 5.2 (EE-297, vector APP)", "a load or store"}};
  RealParameter activity_alu{this,
                             {"power.activity.alu", "", 1.00, 0, 2, 'E',
                              "hardware.md 5.2 (EE-297, vector TYP)", "an ALU or shift operation"}};
  RealParameter activity_mac{
      this,
      {"power.activity.mac", "", 1.00, 0, 2, 'D', "hardware.md 5.2 (EE-297, vectors TYP, APP)",
       "a multiply or multiply-accumulate on typical data"}};
  RealParameter activity_mac_toggling{
      this,
      {"power.activity.mac_toggling", "", 0.29, 0, 2, 'D',
       "hardware.md 5.2 (EE-297, vector HIGH beside TYP)",
       "what data of which every bit changes adds to a multiply or multiply-accumulate"}};
  RealParameter activity_toggle{
      this,
      {"power.activity.toggle", "", 0, 0, 1, 'E', "hardware.md 5.2 (EE-297, vector PEAK)",
       "the data that the multipliers work on: 0 typical, 1 every bit changes every time"}};

  // External bus and SDRAM.
  RealParameter io_volts{this,
                         {"power.io.volts", "V", 3.3, 1, 5, 'V', "stereo-system.md, the device",
                          "supply of the board and of the pins"}};
  RealParameter bus_pins{this,
                         {"power.io.bus_pins", "", 54, 0, 200, 'D', "hardware.md 5.3",
                          "pins of the 32-bit external bus that switch"}};
  RealParameter pin_picofarads{this,
                               {"power.io.pin_picofarads", "pF", 30, 0, 1000, 'V',
                                "hardware.md 5.3 (EE-297)", "load of a pin"}};
  RealParameter bus_toggle{this,
                           {"power.io.bus_toggle", "", 0.25, 0, 1, 'V', "hardware.md 5.3 (EE-297)",
                            "share of the pins that change at a transfer"}};
  RealParameter sdram_chips{this,
                            {"power.sdram.chips", "", 2, 0, 16, 'V', "hardware.md 2.4",
                             "16-bit SDRAM devices, each with a clock pin"}};
  RealParameter sdram_standby_milliamperes{
      this,
      {"power.sdram.standby_milliamperes", "mA", 40, 0, 1000, 'V', "hardware.md 5.4 (MT48, IDD3)",
       "maximum current of a device with an open row and no burst"}};
  RealParameter sdram_burst_milliamperes{
      this,
      {"power.sdram.burst_milliamperes", "mA", 135, 0, 1000, 'V', "hardware.md 5.4 (MT48, IDD4)",
       "maximum current of a device in a continuous burst at 133 MHz; scales with SCLK"}};
  RealParameter sdram_refresh_milliamperes{
      this,
      {"power.sdram.refresh_milliamperes", "mA", 3.5, 0, 1000, 'V', "hardware.md 5.4 (MT48, IDD6)",
       "maximum current of spread auto-refresh"}};
  RealParameter sdram_self_refresh_milliamperes{
      this,
      {"power.sdram.self_refresh_milliamperes", "mA", 2.5, 0, 1000, 'V',
       "hardware.md 5.4 (MT48, IDD7)",
       "maximum current of a device in self-refresh, which keeps its contents: in deep sleep and "
       "hibernation; 0 for a board that gives them up"}};
  RealParameter sdram_typical_share{this,
                                    {"power.sdram.typical_share", "", 0.75, 0, 1, 'E',
                                     "hardware.md 5.5", "typical current beside the maximum"}};

  // The rest of the board.
  RealParameter cameras{this,
                        {"power.board.cameras", "", 2, 0, 8, 'V', "stereo-system.md, the device",
                         "OV7660 cameras, active at VGA"}};
  RealParameter camera_watts{this,
                             {"power.board.camera_watts", "W", 0.085, 0, 5, 'E',
                              "hardware.md 5.4, 5.5", "one camera with its regulator's loss"}};
  RealParameter other_watts{this,
                            {"power.board.other_watts", "W", 0.16, 0, 10, 'E', "hardware.md 5.5",
                             "flash, oscillators, level shifters and LEDs"}};
};

}  // namespace finback::power
