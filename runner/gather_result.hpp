// From what a machine counted to a report: the joint between the simulator's rooms and the report.
#pragma once

#include <isa_sim/ir/image.hpp>
#include <isa_sim/machine/machine.hpp>
#include <runner/run_firmware.hpp>

namespace finback::runner {

// Fills everything from a machine that ran to `end`, and what its cores then told.
[[nodiscard]] report::RunResult gather_result(
    const RunInputs& inputs, const ir::Image& image, machine::Machine& machine,
    const std::array<core::CoreProfile, kCoreCount>& profiles, Cycles end);

}  // namespace finback::runner
