// One function of a finished run, with what each of its instructions and lines cost.
#pragma once

#include <optional>
#include <string>

#include <report/annotation.hpp>
#include <runner/run_firmware.hpp>
#include <runner/source_text.hpp>

namespace finback::runner {

// `units`: what was run. `function`: its C name. `core`: where to look; of a function that both
// cores have, the one that spent more cycles in it is taken. Throws InputError when there is no
// such function, naming the nearest.
[[nodiscard]] report::Annotation annotate(const ir::FirmwareUnits& units, const RunOutcome& outcome,
                                          const std::string& function, std::optional<CoreId> core,
                                          SourceText& sources);

}  // namespace finback::runner
