#include "BfinSubtarget.hpp"

#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/CodeGen/ScheduleDAG.h>

#define GET_SUBTARGETINFO_TARGET_DESC
#define GET_SUBTARGETINFO_CTOR
#include "BfinGenSubtargetInfo.inc"

namespace llvm {

BfinSubtarget::BfinSubtarget(const Triple& triple, StringRef cpu, StringRef features,
                             const TargetMachine& machine)
    : BfinGenSubtargetInfo(triple, cpu, cpu, features), lowering_(machine, *this) {}

namespace {

constexpr unsigned kPointerLoadLatency = 4;    // three stalls before use as an address
constexpr unsigned kDataToPointerLatency = 5;  // four stalls before use as an address
constexpr unsigned kEarlyReadLatency = 2;      // one stall from an ALU result to EX1

bool in_class(const MachineOperand& operand, const TargetRegisterClass& rc,
              const MachineRegisterInfo& regs) {
  if (!operand.isReg())
    return false;
  Register reg = operand.getReg();
  return reg.isVirtual() ? rc.hasSubClassEq(regs.getRegClass(reg)) : rc.contains(reg);
}

}  // namespace

void BfinSubtarget::adjustSchedDependency(SUnit* producer, int def_operand, SUnit* consumer,
                                          int use_operand, SDep& dependency,
                                          const TargetSchedModel*) const {
  if (!producer->isInstr() || !consumer->isInstr() || dependency.getKind() != SDep::Data ||
      def_operand < 0 || use_operand < 0)
    return;
  const MachineInstr& def = *producer->getInstr();
  const MachineInstr& use = *consumer->getInstr();
  const MachineRegisterInfo& regs = def.getMF()->getRegInfo();
  const MachineOperand& result = def.getOperand(static_cast<unsigned>(def_operand));
  bool pointer = in_class(result, Bfin::PRegClass, regs);
  unsigned latency = 1;
  if (pointer && def_operand == 0 && def.mayLoad()) {
    latency = kPointerLoadLatency;
  } else if (pointer && (def.isCopy() || def.getOpcode() == Bfin::MOV) &&
             in_class(def.getOperand(1), Bfin::DRegClass, regs)) {
    latency = kDataToPointerLatency;
  } else if (BfinII::readsEarly(use.getDesc()) && !def.mayLoad()) {
    latency = kEarlyReadLatency;
  }
  dependency.setLatency(latency);
}

}  // namespace llvm
