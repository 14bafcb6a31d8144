// A small result made by hand, with something of everything.
#pragma once

#include <report/run_result.hpp>

namespace finback::report {

inline constexpr double kCoreHertz = 600e6;

[[nodiscard]] inline RunResult small_result() {
  RunResult r;
  r.provenance = {"0.1.0",
                  {"mesvs2", content_hash("firmware")},
                  {"default", content_hash("placement")},
                  {"bf561", content_hash("machine")},
                  {"default", content_hash("power")},
                  {"aloe", content_hash("scene")}};
  r.core_hertz = kCoreHertz;
  r.system_hertz = 120e6;
  r.cycles = 100'000'000;
  r.frames = {{0, 1'000'000, 40'000'000}, {1, 25'000'000, 65'000'000}, {2, 50'000'000, 90'000'000}};
  r.cores = {{"core_a",
              true,
              100,
              60,
              50,
              {{"issue", 50}, {"idle", 30}, {"l3_read", 20}},
              {},
              90,
              4096,
              64},
             {"core_b", false, 0, 0, 0, {{"issue", 0}, {"idle", 0}, {"l3_read", 0}}, {}, 0, 0, 0}};
  r.cores[0].operations = {{"alu", 40}, {"mac", 20}};
  r.stages = {{"rectification", "core_a", "rectify", 3'000'000, 1e6}};
  r.functions = {{"core_a",
                  "rectify",
                  3,
                  50,
                  90,
                  60,
                  {{"issue", 40}, {"idle", 0}, {"l3_read", 20}},
                  80,
                  {{"l1", 8}, {"l3", 44}}},
                 {"core_a",
                  "never_called",
                  0,
                  0,
                  0,
                  0,
                  {{"issue", 0}, {"idle", 0}, {"l3_read", 0}},
                  10,
                  {{"l1", 0}, {"l3", 0}}}};
  r.lines = {{"core_a",
              "rectify",
              "rectify.c",
              12,
              3,
              30,
              50,
              {{"issue", 30}, {"l3_read", 20}},
              {{"l3", 44}}},
             {"core_a", "rectify", "", 0, 10, 10, 10, {{"issue", 10}}, {{"l1", 8}}}};
  r.traffic = {{"l3", "core_a", 3'000'000, 600}, {"l3", "mdma1_0", 0, 0}};
  r.objects = {{"rows", "core_a", "l3", "l3", 1200, {{"core_a", 5, 6, 20, 24, 400}}}};
  r.regions = {{"core_a", "l1.data.a", "l1", 0, 32768}, {"", "l3", "l3", 1200, 67108864}};
  power::Activity activity;
  activity.cycles = r.cycles;
  r.power = power::estimate_power(power::PowerParameters(), activity);
  r.targets = {{"frames_per_second", ">=", 20, frames_per_second(r.frames, kCoreHertz), "fps"},
               {"power_watts", "<=", 2.3, r.power.watts, "W"}};
  r.accuracy = Accuracy{0, 1.0, 8, 14000, 80, 25, 6.25};
  r.counters = {{"core_a.instructions", 60}, {"traffic.l3.core_a.read.bytes", 3'000'000}};
  return r;
}

}  // namespace finback::report
