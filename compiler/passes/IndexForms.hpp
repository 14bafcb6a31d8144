// Loads and stores through I registers, which may stand beside another access in a packet: which
// there are, and which of a loop's accesses might be.
#pragma once

#include <vector>

#include "../target/BfinInstrInfo.hpp"

namespace llvm {

constexpr size_t kIndexRegisterCount = 4;

/// The access through an I register that does the same, but for the upper half of what a load of 16
/// bits finds; 0 where there is none.
unsigned index_form(unsigned opcode);
/// Whether an access through an I register loads 16 bits.
bool is_half_load(unsigned index_opcode);
/// The same through a ring register.
bool is_ring_half_load(unsigned ring_opcode);
/// Whether operand `index` of `inst`, a data register, is read beyond its low half.
bool reads_upper_half(const MachineInstr& inst, unsigned index);
/// A pointer of a loop of one block, before allocation, that might be in an I register: its
/// accesses, and those of them whose upper half must be zero.
struct IndexStream {
  MachineInstr* phi = nullptr;
  std::vector<MachineInstr*> accesses;
  std::vector<MachineInstr*> zero_extended;
};
/// The pointers that might, as many as there are I registers but one, which is left to allocation.
std::vector<IndexStream> index_streams(MachineBasicBlock& block);
/// Moves the pointer to an I register. Outside of the loop it is in one, too.
void use_index_register(const IndexStream& stream, MachineBasicBlock& before,
                        const BfinInstrInfo& tii);

}  // namespace llvm
