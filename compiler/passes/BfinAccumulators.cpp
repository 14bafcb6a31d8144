// Sums of products of halves live in an accumulator while their loop runs: multiply and add are one
// instruction. Looks at loops of one block on a loop counter, with at most two such sums.
//
// The accumulators have 40 bits and saturate, C's sums have 32 and wrap: only sums that must not
// overflow (nsw) are taken. Handlers of interrupts do without: they would have to save them.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinMachineFunctionInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

/// The instructions of one accumulator.
struct Accumulator {
  unsigned clear;
  unsigned set;
  unsigned multiply_add;
  unsigned get;
};
constexpr Accumulator kAccumulators[] = {
    {Bfin::CLRA0, Bfin::SETA0, Bfin::MACIS0, Bfin::GETA0},
    {Bfin::CLRA1, Bfin::SETA1, Bfin::MACIS1, Bfin::GETA1},
};

/// sum = PHI(start, next); next = sum + product, both within one loop.
struct Sum {
  MachineInstr* phi = nullptr;
  MachineInstr* add = nullptr;
  MachineInstr* product = nullptr;
  Register start;
};

class BfinAccumulators : public MachineFunctionPass {
 public:
  static char ID;
  BfinAccumulators() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin accumulators"; }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  bool find_sum(MachineInstr& phi, Sum& sum) const;
  void convert(const Sum& sum, const Accumulator& accumulator, MachineBasicBlock& before,
               MachineBasicBlock& after);

  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
};

char BfinAccumulators::ID = 0;

/// Whether `reg` is used by `user` alone.
bool only_user(const MachineRegisterInfo& regs, Register reg, const MachineInstr& user) {
  return all_of(regs.use_nodbg_instructions(reg),
                [&](const MachineInstr& use) { return &use == &user; });
}

bool BfinAccumulators::find_sum(MachineInstr& phi, Sum& sum) const {
  MachineBasicBlock& block = *phi.getParent();
  if (phi.getNumOperands() != 5)
    return false;
  const unsigned own = phi.getOperand(2).getMBB() == &block ? 1 : 3;
  sum.phi = &phi;
  sum.start = phi.getOperand(own == 1 ? 3 : 1).getReg();
  const Register value = phi.getOperand(0).getReg();
  sum.add = regs_->getVRegDef(phi.getOperand(own).getReg());
  if (sum.add->getParent() != &block || sum.add->getOpcode() != Bfin::ADD_X ||
      !sum.add->getFlag(MachineInstr::NoSWrap) || !only_user(*regs_, value, *sum.add))
    return false;
  const Register left = sum.add->getOperand(1).getReg();
  const Register right = sum.add->getOperand(2).getReg();
  if ((left == value) == (right == value))
    return false;
  sum.product = regs_->getVRegDef(left == value ? right : left);
  return sum.product->getParent() == &block && sum.product->getOpcode() == Bfin::MULIS &&
         only_user(*regs_, sum.product->getOperand(0).getReg(), *sum.add) &&
         none_of(
             regs_->use_nodbg_instructions(sum.add->getOperand(0).getReg()),
             [&](const MachineInstr& use) { return &use != &phi && use.getParent() == &block; });
}

void BfinAccumulators::convert(const Sum& sum, const Accumulator& accumulator,
                               MachineBasicBlock& before, MachineBasicBlock& after) {
  const auto entry = before.getFirstTerminator();
  const DebugLoc& loc = sum.add->getDebugLoc();
  BuildMI(before, entry, loc, tii_->get(accumulator.clear));
  const MachineInstr* start = regs_->getVRegDef(sum.start);
  if (start->getOpcode() != Bfin::MOVI || start->getOperand(1).getImm() != 0) {
    const Register data = regs_->createVirtualRegister(&Bfin::DRegClass);
    BuildMI(before, entry, loc, tii_->get(TargetOpcode::COPY), data).addReg(sum.start);
    BuildMI(before, entry, loc, tii_->get(accumulator.set)).addReg(data);
  }
  BuildMI(*sum.product->getParent(), sum.product, loc, tii_->get(accumulator.multiply_add))
      .add(sum.product->getOperand(1))
      .add(sum.product->getOperand(2));
  const Register result = sum.add->getOperand(0).getReg();
  sum.phi->eraseFromParent();
  sum.add->eraseFromParent();
  sum.product->eraseFromParent();
  regs_->clearKillFlags(sum.start);
  regs_->setRegClass(result, &Bfin::DRegClass);
  BuildMI(after, after.getFirstNonPHI(), loc, tii_->get(accumulator.get), result);
}

bool BfinAccumulators::runOnMachineFunction(MachineFunction& function) {
  if (isInterruptHandler(function.getFunction()))
    return false;
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  bool changed = false;
  for (MachineBasicBlock& block : make_early_inc_range(function)) {
    const auto end = block.getFirstTerminator();
    if (end == block.end() || end->getOpcode() != Bfin::ENDLOOP ||
        end->getOperand(0).getMBB() != &block || block.succ_size() != 2 || block.pred_size() != 2)
      continue;
    MachineBasicBlock* before =
        *find_if(block.predecessors(), [&](MachineBasicBlock* other) { return other != &block; });
    MachineBasicBlock* after =
        *find_if(block.successors(), [&](MachineBasicBlock* other) { return other != &block; });
    std::vector<Sum> sums;
    for (MachineInstr& phi : block.phis()) {
      Sum sum;
      if (sums.size() < std::size(kAccumulators) && find_sum(phi, sum))
        sums.push_back(sum);
    }
    // The results are fetched where only this loop leads.
    if (!sums.empty() && after->pred_size() != 1)
      after = block.SplitCriticalEdge(after, *this);
    if (after == nullptr)
      continue;
    for (const auto& [sum, accumulator] : zip(sums, kAccumulators))
      convert(sum, accumulator, *before, *after);
    changed |= !sums.empty();
  }
  return changed;
}

}  // namespace

FunctionPass* createBfinAccumulators() { return new BfinAccumulators(); }

}  // namespace llvm
