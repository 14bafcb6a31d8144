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

unsigned BfinSubtarget::issueCycles(const MachineInstr& inst) {
  constexpr unsigned kWordProduct = 3;
  constexpr unsigned kPartSize = 4;
  if (inst.getOpcode() == Bfin::MUL)
    return kWordProduct;
  // A sequence is one part after the other.
  const bool parts = inst.isPseudo() && BfinII::getSlot(inst.getDesc()) == BfinII::kDspSlot;
  return parts ? inst.getDesc().getSize() / kPartSize : 1;
}

unsigned BfinSubtarget::latency(const MachineInstr& def, unsigned def_operand,
                                const MachineInstr& use) {
  const MachineRegisterInfo& regs = def.getMF()->getRegInfo();
  const MachineOperand& result = def.getOperand(def_operand);
  const bool pointer = in_class(result, Bfin::PRegClass, regs);
  if (pointer && def_operand == 0 && def.mayLoad())
    return kPointerLoadLatency;
  const bool address = pointer || in_class(result, Bfin::IRRegClass, regs) ||
                       in_class(result, Bfin::MRRegClass, regs) ||
                       in_class(result, Bfin::BRRegClass, regs) ||
                       in_class(result, Bfin::LRRegClass, regs);
  if (address && (def.isCopy() || def.getOpcode() == Bfin::MOV) &&
      in_class(def.getOperand(1), Bfin::DRegClass, regs))
    return kDataToPointerLatency;
  // The accumulators are read where they are written, behind the multipliers.
  const bool accumulator =
      result.isReg() && (result.getReg() == Bfin::A0 || result.getReg() == Bfin::A1);
  const bool early = BfinII::readsEarly(use.getDesc()) && !def.mayLoad() && !accumulator;
  const unsigned after = early ? kEarlyReadLatency : 1;
  return issueCycles(def) - 1 + after;
}

void BfinSubtarget::adjustSchedDependency(SUnit* producer, int def_operand, SUnit* consumer,
                                          int use_operand, SDep& dependency,
                                          const TargetSchedModel*) const {
  // What a region ends with reads its registers, too: LSETUP a count that was moved to its
  // register.
  if (consumer->isBoundaryNode()) {
    const MachineInstr* end = consumer->getInstr();
    if (end != nullptr && producer->isInstr() && def_operand >= 0) {
      const auto operand = static_cast<unsigned>(def_operand);
      const MachineOperand& result = producer->getInstr()->getOperand(operand);
      if (end->readsRegister(result.getReg(), nullptr))
        dependency.setLatency(latency(*producer->getInstr(), operand, *end));
    }
    return;
  }
  if (!producer->isInstr() || !consumer->isInstr() || dependency.getKind() != SDep::Data ||
      def_operand < 0 || use_operand < 0)
    return;
  dependency.setLatency(
      latency(*producer->getInstr(), static_cast<unsigned>(def_operand), *consumer->getInstr()));
}

}  // namespace llvm
