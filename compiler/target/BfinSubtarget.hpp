// One processor, and which pairs of instructions stall.
#pragma once

#include <llvm/CodeGen/SelectionDAGTargetInfo.h>
#include <llvm/CodeGen/TargetSubtargetInfo.h>

#include "BfinFrameLowering.hpp"
#include "BfinISelLowering.hpp"
#include "BfinInstrInfo.hpp"

#define GET_SUBTARGETINFO_HEADER
#include "BfinGenSubtargetInfo.inc"

namespace llvm {

class BfinSubtarget : public BfinGenSubtargetInfo {
 public:
  BfinSubtarget(const Triple& triple, StringRef cpu, StringRef features,
                const TargetMachine& machine);

  void ParseSubtargetFeatures(StringRef cpu, StringRef tune, StringRef features);

  const BfinInstrInfo* getInstrInfo() const override { return &instrs_; }
  const BfinRegisterInfo* getRegisterInfo() const override { return &instrs_.getRegisterInfo(); }
  const BfinFrameLowering* getFrameLowering() const override { return &frame_; }
  const BfinTargetLowering* getTargetLowering() const override { return &lowering_; }
  const SelectionDAGTargetInfo* getSelectionDAGInfo() const override { return &dag_info_; }

  /// Cycles in which nothing else with a 32-bit operation issues.
  static unsigned issueCycles(const MachineInstr& inst);

  /// Cycles from `def`, whose operand `def_operand` is the result, until `use` can issue.
  static unsigned latency(const MachineInstr& def, unsigned def_operand, const MachineInstr& use);

  bool enableMachineScheduler() const override { return true; }
  /// Stalls between producer and consumer (hardware.md 1.5), as latencies.
  void adjustSchedDependency(SUnit* producer, int def_operand, SUnit* consumer, int use_operand,
                             SDep& dependency, const TargetSchedModel* model) const override;

 private:
  BfinInstrInfo instrs_;
  BfinFrameLowering frame_;
  BfinTargetLowering lowering_;
  SelectionDAGTargetInfo dag_info_;
};

}  // namespace llvm
