// Pointers that go on from one run of an inner loop to the next stay in their I registers:
//
//   outer: x = phi(start, y)          outer: i = phi(start, j)
//          i = x; inner loop; y = j          inner loop
//
// The moves are spared, and what a move to an I register waits for. Works on SSA form before
// allocation, behind the passes that give inner loops I registers, and only where one inner loop of
// the outer one has any and nothing is called: an I register cannot be spilled.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineLoopInfo.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/InitializePasses.h>
#include <set>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"
#include "IndexForms.hpp"

namespace llvm {
namespace {

class BfinKeptIndices : public MachineFunctionPass {
 public:
  static char ID;
  BfinKeptIndices() : MachineFunctionPass(ID) {
    initializeMachineLoopInfoWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin kept indices"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<MachineLoopInfoWrapperPass>();
    usage.setPreservesCFG();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  [[nodiscard]] bool is_index(Register reg) const {
    return reg.isVirtual() && Bfin::IRRegClass.hasSubClassEq(regs_->getRegClass(reg));
  }
  [[nodiscard]] bool is_ring(Register reg) const {
    return reg.isVirtual() && regs_->getRegClass(reg) == &Bfin::RINGRegClass;
  }
  [[nodiscard]] bool uses_index(const MachineInstr& inst) const;
  [[nodiscard]] bool may_keep(const MachineLoop& outer) const;
  bool keep(MachineInstr& copy);
  size_t values_in(const MachineLoop& loop, const TargetRegisterClass& bank) const;
  bool keep_in_data(MachineInstr& copy);

  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
  const MachineLoopInfo* loops_ = nullptr;
};

char BfinKeptIndices::ID = 0;

bool BfinKeptIndices::uses_index(const MachineInstr& inst) const {
  return any_of(inst.operands(), [&](const MachineOperand& operand) {
    return operand.isReg() &&
           (is_index(operand.getReg()) || is_ring(operand.getReg()) ||
            (operand.getReg().isPhysical() && Bfin::IRRegClass.contains(operand.getReg())));
  });
}

/// One inner loop with I registers, nothing that would want more of them than there are: but one,
/// which is left to allocation.
bool BfinKeptIndices::may_keep(const MachineLoop& outer) const {
  unsigned inner = 0;
  size_t pointers = 0;
  for (const MachineBasicBlock* block : outer.blocks()) {
    for (const MachineInstr& inst : *block) {
      const bool begins = inst.isCopy() ? !is_index(inst.getOperand(1).getReg())
                                        : inst.isPHI() && block == outer.getHeader();
      pointers += begins && is_index(inst.getOperand(0).getReg()) ? 1 : 0;
      if (inst.isCall() || inst.isInlineAsm() ||
          any_of(inst.operands(), [&](const MachineOperand& operand) {
            return operand.isReg() &&
                   (is_ring(operand.getReg()) ||
                    (operand.getReg().isPhysical() && Bfin::IRRegClass.contains(operand.getReg())));
          }))
        return false;
    }
    if (loops_->getLoopFor(block) != &outer &&
        any_of(*block, [&](const MachineInstr& inst) { return uses_index(inst); }))
      ++inner;
  }
  return inner == 1 && pointers < kIndexRegisterCount;
}

/// From where the outer loop begins: `copy` moves its pointer to an I register.
bool BfinKeptIndices::keep(MachineInstr& copy) {
  const Register pointer = copy.getOperand(1).getReg();
  if (!pointer.isVirtual() || copy.getOperand(1).getSubReg() != 0)
    return false;
  MachineInstr& phi = *regs_->getVRegDef(pointer);
  const MachineLoop* outer = loops_->getLoopFor(copy.getParent());
  if (!phi.isPHI() || phi.getNumOperands() != 5 || outer == nullptr ||
      outer->getHeader() != phi.getParent() || !regs_->hasOneNonDBGUse(pointer) ||
      !may_keep(*outer))
    return false;
  const unsigned own = outer->contains(phi.getOperand(2).getMBB()) ? 1 : 3;
  MachineOperand& around = phi.getOperand(own);
  MachineOperand& start = phi.getOperand(4 - own);
  MachineBasicBlock& before = *phi.getOperand(5 - own).getMBB();
  MachineInstr* back = around.getReg().isVirtual() ? regs_->getVRegDef(around.getReg()) : nullptr;
  if (outer->contains(&before) || back == nullptr || !back->isCopy() ||
      !is_index(back->getOperand(1).getReg()) || !start.getReg().isVirtual() ||
      is_index(start.getReg()))
    return false;
  const Register first = regs_->createVirtualRegister(&Bfin::IRRegClass);
  BuildMI(before, before.getFirstTerminator(), copy.getDebugLoc(), tii_->get(TargetOpcode::COPY),
          first)
      .addReg(start.getReg());
  regs_->clearKillFlags(start.getReg());
  start.setReg(first);
  around.setReg(back->getOperand(1).getReg());
  regs_->clearKillFlags(around.getReg());
  if (regs_->use_nodbg_empty(back->getOperand(0).getReg()))
    back->eraseFromParent();
  const Register index = copy.getOperand(0).getReg();
  copy.eraseFromParent();
  regs_->setRegClass(pointer, &Bfin::IRRegClass);
  regs_->replaceRegWith(index, pointer);
  regs_->clearKillFlags(pointer);
  return true;
}

/// How many values of the bank each pass of the loop needs at least: what goes round, and what
/// comes from outside.
size_t BfinKeptIndices::values_in(const MachineLoop& loop, const TargetRegisterClass& bank) const {
  std::set<Register> values;
  const auto add = [&](Register reg) {
    if (reg.isVirtual() && bank.hasSubClassEq(regs_->getRegClass(reg)))
      values.insert(reg);
  };
  for (const MachineBasicBlock* block : loop.blocks())
    for (const MachineInstr& inst : *block) {
      if (inst.isPHI())
        add(inst.getOperand(0).getReg());
      else
        for (const MachineOperand& use : inst.all_uses())
          if (use.getReg().isVirtual() && !use.isUndef() &&
              !loop.contains(regs_->getVRegDef(use.getReg())->getParent()))
            add(use.getReg());
    }
  return values.size();
}

/// Where P registers are short, what an I register begins with in each pass waits in a D register.
bool BfinKeptIndices::keep_in_data(MachineInstr& copy) {
  constexpr size_t kManyPointers = 6;
  constexpr size_t kFewWords = 6;
  const Register pointer = copy.getOperand(1).getReg();
  const MachineLoop* loop = loops_->getLoopFor(copy.getParent());
  if (!pointer.isVirtual() || loop == nullptr || loop->getLoopPreheader() == nullptr ||
      !Bfin::PRegClass.hasSubClassEq(regs_->getRegClass(pointer)) ||
      loop->contains(regs_->getVRegDef(pointer)->getParent()) ||
      values_in(*loop, Bfin::PRegClass) < kManyPointers ||
      values_in(*loop, Bfin::DRegClass) > kFewWords ||
      any_of(regs_->use_nodbg_instructions(pointer), [&](const MachineInstr& use) {
        return &use != &copy && loop->contains(use.getParent());
      }))
    return false;
  MachineBasicBlock& before = *loop->getLoopPreheader();
  const Register kept = regs_->createVirtualRegister(&Bfin::DRegClass);
  BuildMI(before, before.getFirstTerminator(), copy.getDebugLoc(), tii_->get(TargetOpcode::COPY),
          kept)
      .addReg(pointer);
  regs_->clearKillFlags(pointer);
  copy.getOperand(1).setReg(kept);
  return true;
}

bool BfinKeptIndices::runOnMachineFunction(MachineFunction& function) {
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  loops_ = &getAnalysis<MachineLoopInfoWrapperPass>().getLI();
  bool changed = false;
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : make_early_inc_range(block))
      if (inst.isCopy() && is_index(inst.getOperand(0).getReg()) &&
          !is_index(inst.getOperand(1).getReg()))
        changed |= keep(inst) || keep_in_data(inst);
  return changed;
}

}  // namespace

FunctionPass* createBfinKeptIndices() { return new BfinKeptIndices(); }

}  // namespace llvm
