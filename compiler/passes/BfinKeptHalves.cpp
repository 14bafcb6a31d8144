// ONES writes the low half of a register and leaves the high one, which must be zero: a zero made
// before each count. In a loop of one block one zero made before the loop does: the counter's own
// register carries its high half from round to round.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

class BfinKeptHalves : public MachineFunctionPass {
 public:
  static char ID;
  BfinKeptHalves() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin kept halves"; }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  void carry(MachineInstr& ones, MachineBasicBlock& before);
};

char BfinKeptHalves::ID = 0;

/// The only block from which a loop of one block is entered; none for other blocks.
MachineBasicBlock* entered_from(const MachineBasicBlock& block) {
  if (!block.isSuccessor(&block) || block.pred_size() != 2)
    return nullptr;
  MachineBasicBlock* first = *block.pred_begin();
  MachineBasicBlock* before = first == &block ? *std::next(block.pred_begin()) : first;
  return before->succ_size() == 1 ? before : nullptr;
}

void BfinKeptHalves::carry(MachineInstr& ones, MachineBasicBlock& before) {
  MachineBasicBlock& block = *ones.getParent();
  MachineRegisterInfo& regs = block.getParent()->getRegInfo();
  const auto& tii = *block.getParent()->getSubtarget<BfinSubtarget>().getInstrInfo();
  Register zero = regs.createVirtualRegister(&Bfin::DRegClass);
  Register kept = regs.createVirtualRegister(&Bfin::DRegClass);
  BuildMI(before, before.getFirstTerminator(), ones.getDebugLoc(), tii.get(Bfin::MOVI), zero)
      .addImm(0);
  BuildMI(block, block.begin(), ones.getDebugLoc(), tii.get(TargetOpcode::PHI), kept)
      .addReg(zero)
      .addMBB(&before)
      .addReg(ones.getOperand(0).getReg())
      .addMBB(&block);
  ones.getOperand(1).setReg(kept);
  regs.clearKillFlags(ones.getOperand(0).getReg());
}

bool BfinKeptHalves::runOnMachineFunction(MachineFunction& function) {
  const MachineRegisterInfo& regs = function.getRegInfo();
  bool changed = false;
  for (MachineBasicBlock& block : function) {
    MachineBasicBlock* before = entered_from(block);
    if (before == nullptr)
      continue;
    for (MachineInstr& inst : block) {
      if (inst.getOpcode() != Bfin::ONES)
        continue;
      const MachineInstr* old = regs.getVRegDef(inst.getOperand(1).getReg());
      if (old->getOpcode() != Bfin::MOVI || old->getOperand(1).getImm() != 0)
        continue;
      carry(inst, *before);
      changed = true;
    }
  }
  return changed;
}

}  // namespace

FunctionPass* createBfinKeptHalves() { return new BfinKeptHalves(); }

}  // namespace llvm
