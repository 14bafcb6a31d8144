// What the back end remembers about one function.
#pragma once

#include <llvm/CodeGen/MachineFunction.h>
#include <llvm/IR/Function.h>
#include <set>

namespace llvm {

/// The attribute that the driver puts on functions annotated "interrupt".
inline constexpr const char* kInterruptAttribute = "bfin-interrupt";

/// Calls whose arguments are all in registers: R0 to R3, P0, P1.
inline constexpr CallingConv::ID kInRegisters = 1000;

inline bool isInterruptHandler(const Function& function) {
  return function.hasFnAttribute(kInterruptAttribute);
}

class BfinMachineFunctionInfo : public MachineFunctionInfo {
 public:
  BfinMachineFunctionInfo(const Function&, const TargetSubtargetInfo*) {}

  MachineFunctionInfo* clone(
      BumpPtrAllocator& allocator, MachineFunction& destination,
      const DenseMap<MachineBasicBlock*, MachineBasicBlock*>&) const override {
    (void)allocator;
    return destination.cloneInfo<BfinMachineFunctionInfo>(*this);
  }

  /// Bytes that the multiple push takes.
  unsigned saved_bytes = 0;
  /// The home slot of the first argument that is not named, in a variadic function.
  int varargs_index = 0;
  /// The function uses LC0 or LC1.
  bool has_hardware_loops = false;
  /// Blocks whose instructions stand in the order that allocation shall find.
  std::set<const MachineBasicBlock*> ordered_blocks;
};

}  // namespace llvm
