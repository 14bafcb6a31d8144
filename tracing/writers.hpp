// A recorded window as people read it: lines of text, or a log for the Konata pipeline viewer.
#pragma once

#include <span>
#include <string>
#include <tracing/code.hpp>
#include <tracing/recorder.hpp>

#include <report/page.hpp>

namespace finback::tracing {

// A line for each packet: core, cycle, cycles, place, source line, code, and why it took more than
// one cycle; at the end, for each core, what the window's cycles went on.
[[nodiscard]] std::string to_text(std::span<const Recorded> records, Code& code,
                                  const report::Style& style);

// Konata's log, version 4. The ten stages are hardware.md 1.1's; a packet that waits does so in a
// stage named after the cause (profile.hpp), and a change of flow leaves a gap before the first
// stage of the next packet. Waits stand where the model has them, at issue; on the chip some of
// them hold a packet in a later stage.
[[nodiscard]] std::string to_konata(std::span<const Recorded> records, Code& code);

// "40 l3_read of left_image+0x40": one cost in words.
[[nodiscard]] std::string describe(const core::TraceCost& cost, CoreId core, const Code& code);

}  // namespace finback::tracing
