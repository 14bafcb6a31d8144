// What the packets of a program cost, summed by core, function, stage and source line.
#pragma once

#include <vector>

#include <isa_sim/core/profile.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/image.hpp>
#include <report/run_result.hpp>

namespace finback::runner {

// Adds a core, its functions and its lines to `result`. The cycles over the functions, over the
// lines and over the causes each sum to the core's.
void gather_program(CoreId core, const ir::CoreImage& image, const core::CoreProfile& profile,
                    report::RunResult& result);

// Adds the stages; `result` must have its functions and frames.
void gather_stages(const std::vector<ir::Stage>& stages, report::RunResult& result);

// Without those that are 0.
[[nodiscard]] report::CyclesByCause nonzero_causes(const core::CauseCycles& cycles);
[[nodiscard]] report::BytesByLevel nonzero_levels(const core::LevelBytes& bytes);

}  // namespace finback::runner
