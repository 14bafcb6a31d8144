// When each instruction of a loop of one block issues, so that passes begin as soon after each
// other as packets and dependences allow: a pass is at most two stages long, the second of which
// runs beside the first of the next pass. Does not move anything, and does not know the registers
// that allocation will find.
#pragma once

#include "IndexForms.hpp"
#include "LoopDependences.hpp"

namespace llvm {

struct ModuloSchedule {
  unsigned cycles = 0;          // from a pass to the next
  std::vector<unsigned> times;  // of each instruction, from the pass's beginning
  [[nodiscard]] bool in_first_stage(size_t i) const { return times[i] < cycles; }
};

/// The shortest schedule that `allowed` takes, with passes of at most `stages` (1 or 2) stages, of
/// at most `most` cycles, and the pointers of `streams` in I registers; cycles are 0 where there is
/// none.
ModuloSchedule schedule_loop(const LoopDependences& loop, const BfinInstrInfo& tii, unsigned stages,
                             unsigned most, const std::vector<IndexStream>& streams,
                             function_ref<bool(const ModuloSchedule&)> allowed);

/// The order of the instructions within the loop: by their cycle in it, what reads first in each.
std::vector<size_t> kernel_order(const LoopDependences& loop, const ModuloSchedule& schedule);

}  // namespace llvm
