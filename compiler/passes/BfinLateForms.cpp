// The last forms: two-byte shifts where source and destination met in one register, and the
// predicted direction of each conditional branch (static: the (BP) bit; a predicted branch costs 5
// cycles, a mispredicted one 9, one that falls through as predicted 1: hardware.md 1.4).
#include <llvm/CodeGen/MachineBranchProbabilityInfo.h>
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/InitializePasses.h>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

class BfinLateForms : public MachineFunctionPass {
 public:
  static char ID;
  BfinLateForms() : MachineFunctionPass(ID) {
    initializeMachineBranchProbabilityInfoWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin late forms"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<MachineBranchProbabilityInfoWrapperPass>();
    usage.setPreservesCFG();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override;
};

char BfinLateForms::ID = 0;

unsigned short_form(const MachineInstr& inst) {
  switch (inst.getOpcode()) {
    case Bfin::SHLI:
      return Bfin::SHLI2;
    case Bfin::SRLI:
      return Bfin::SRLI2;
    case Bfin::SRAI:
      return Bfin::SRAI2;
    default:
      return 0;
  }
}

bool BfinLateForms::runOnMachineFunction(MachineFunction& function) {
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  const auto& probabilities = getAnalysis<MachineBranchProbabilityInfoWrapperPass>().getMBPI();
  bool changed = false;
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : block) {
      unsigned form = short_form(inst);
      if (form != 0 && !inst.isBundled() &&
          inst.getOperand(0).getReg() == inst.getOperand(1).getReg()) {
        inst.setDesc(tii.get(form));
        inst.tieOperands(0, 1);
        changed = true;
      }
      if (inst.getOpcode() != Bfin::JCC && inst.getOpcode() != Bfin::JNCC)
        continue;
      // With p the share of taken ones: 5p + 9(1-p) predicted, 9p + (1-p) not; equal at two thirds.
      BranchProbability taken =
          probabilities.getEdgeProbability(&block, inst.getOperand(0).getMBB());
      inst.getOperand(1).setImm(taken > BranchProbability(2, 3) ? 1 : 0);
      changed = true;
    }
  return changed;
}

}  // namespace

FunctionPass* createBfinLateForms() { return new BfinLateForms(); }

}  // namespace llvm
