#include "BfinRegisterInfo.hpp"

#include <llvm/CodeGen/MachineFrameInfo.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/CodeGen/RegisterScavenging.h>

#include "BfinInstrInfo.hpp"
#include "BfinMachineFunctionInfo.hpp"
#include "BfinSubtarget.hpp"

#define GET_REGINFO_TARGET_DESC
#include "BfinGenRegisterInfo.inc"

namespace llvm {

BfinRegisterInfo::BfinRegisterInfo() : BfinGenRegisterInfo(Bfin::RETS) {}

const MCPhysReg* BfinRegisterInfo::getCalleeSavedRegs(const MachineFunction* function) const {
  return isInterruptHandler(function->getFunction()) ? CSR_BfinInterrupt_SaveList
                                                     : CSR_Bfin_SaveList;
}

const uint32_t* BfinRegisterInfo::getCallPreservedMask(const MachineFunction&,
                                                       CallingConv::ID) const {
  return CSR_BfinCall_RegMask;
}

BitVector BfinRegisterInfo::getReservedRegs(const MachineFunction&) const {
  BitVector reserved(getNumRegs());
  reserved.set();
  for (const TargetRegisterClass* rc :
       {&Bfin::DRegClass, &Bfin::PRegClass, &Bfin::IRRegClass, &Bfin::MRRegClass, &Bfin::BRRegClass,
        &Bfin::LRRegClass, &Bfin::RINGRegClass})
    for (MCPhysReg reg : *rc)
      reserved.reset(reg);
  reserved.set(Bfin::SP);
  reserved.set(Bfin::FP);
  return reserved;
}

Register BfinRegisterInfo::getFrameRegister(const MachineFunction&) const { return Bfin::FP; }

const TargetRegisterClass* BfinRegisterInfo::getLargestLegalSuperClass(
    const TargetRegisterClass* rc, const MachineFunction&) const {
  if (rc == &Bfin::DRegClass || rc == &Bfin::PRegClass)
    return &Bfin::DPRegClass;
  return rc;
}

const TargetRegisterClass* BfinRegisterInfo::getPointerRegClass(const MachineFunction&,
                                                                unsigned) const {
  return &Bfin::PRegClass;
}

bool BfinRegisterInfo::eliminateFrameIndex(MachineBasicBlock::iterator inst, int, unsigned operand,
                                           RegScavenger*) const {
  MachineBasicBlock& block = *inst->getParent();
  MachineFunction& function = *block.getParent();
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  Register base;
  int index = inst->getOperand(operand).getIndex();
  int64_t offset = function.getSubtarget()
                       .getFrameLowering()
                       ->getFrameIndexReference(function, index, base)
                       .getFixed() +
                   inst->getOperand(operand + 1).getImm();
  if (inst->getOpcode() == Bfin::LEA) {
    tii.buildAddress(block, inst, inst->getDebugLoc(), inst->getOperand(0).getReg(), base, offset);
    inst->eraseFromParent();
    return true;
  }
  if (tii.isLegalDisplacement(inst->getOpcode(), offset)) {
    inst->getOperand(operand).ChangeToRegister(base, false);
    inst->getOperand(operand + 1).ChangeToImmediate(offset);
    return false;
  }
  // A frame so big that the displacement does not fit: one more register, found by the scavenger.
  Register address = function.getRegInfo().createVirtualRegister(&Bfin::PRegClass);
  tii.buildAddress(block, inst, inst->getDebugLoc(), address, base, offset);
  inst->getOperand(operand).ChangeToRegister(address, false, false, true);
  inst->getOperand(operand + 1).ChangeToImmediate(0);
  return false;
}

bool BfinRegisterInfo::getRegAllocationHints(Register value, ArrayRef<MCPhysReg> order,
                                             SmallVectorImpl<MCPhysReg>& hints,
                                             const MachineFunction& function, const VirtRegMap* map,
                                             const LiveRegMatrix* matrix) const {
  const bool exclusive =
      BfinGenRegisterInfo::getRegAllocationHints(value, order, hints, function, map, matrix);
  const MachineRegisterInfo& regs = function.getRegInfo();
  if (regs.getRegClass(value) != &Bfin::DPRegClass)
    return exclusive;
  const bool to_address = any_of(regs.use_nodbg_instructions(value), [&](const MachineInstr& use) {
    if (!use.isCopy() || !use.getOperand(0).getReg().isVirtual())
      return false;
    const TargetRegisterClass* to = regs.getRegClass(use.getOperand(0).getReg());
    return to == &Bfin::PRegClass || to == &Bfin::IRRegClass;
  });
  if (to_address)
    for (const MCPhysReg reg : order)
      if (Bfin::PRegClass.contains(reg) && !is_contained(hints, reg))
        hints.push_back(reg);
  return exclusive;
}

}  // namespace llvm
