// A placed function as it was written: with symbols and labels instead of numbers.
#pragma once

#include <vector>

#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/image.hpp>
#include <isa_sim/ir/program.hpp>

namespace finback::runner {

// `units`: those of the core whose image `placed` is in. Several of them may have a local function
// of one name; the one with these instructions is taken.
[[nodiscard]] ir::Function written_function(const std::vector<ir::Unit>& units,
                                            const ir::PlacedFunction& placed,
                                            const ir::CoreImage& image);

}  // namespace finback::runner
