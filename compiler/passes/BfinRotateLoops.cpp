// Loads for the next pass of a small loop move to the end of the present one, where a packet has
// room for them beside the arithmetic: a loop that loads and then multiplies need not wait for its
// own loads.
//
//   loop: L; R            L
//                         if only one pass: jump last
//                   loop: R; L            (one pass less)
//                   last: R
//
// Looks at loops of one block on a loop counter that store nothing, before allocation. L are the
// loads through what the pass begins with; nothing is loaded that was not before.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <map>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

constexpr size_t kMostInstructions = 12;  // of a body: it stands twice afterwards

using Registers = std::map<Register, Register>;

class BfinRotateLoops : public MachineFunctionPass {
 public:
  static char ID;
  BfinRotateLoops() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin loop rotation"; }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  struct Loop {
    MachineBasicBlock* block = nullptr;
    MachineBasicBlock* before = nullptr;
    MachineBasicBlock* after = nullptr;
    MachineInstr* setup = nullptr;
    std::vector<MachineInstr*> loads;
    std::vector<MachineInstr*> rest;
  };

  bool find(MachineBasicBlock& block, Loop& loop) const;
  bool sort_body(Loop& loop) const;
  void rotate(Loop& loop);
  Registers load_before(const Loop& loop);
  bool runs_twice(const Loop& loop) const;
  void count_one_less(Loop& loop, MachineBasicBlock* last);
  MachineBasicBlock* make_last(const Loop& loop, const Registers& first, const Registers& next,
                               const Registers& found);
  void forget_address(MachineInstr& load);
  void replace(MachineOperand& use, Register value);
  void clone(const MachineInstr& inst, MachineBasicBlock& block, Registers& values);
  Register incoming(const MachineInstr& phi, const MachineBasicBlock& from) const;
  Register alike(Register reg) { return regs_->createVirtualRegister(regs_->getRegClass(reg)); }

  MachineFunction* function_ = nullptr;
  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
};

char BfinRotateLoops::ID = 0;

Register value_of(const Registers& values, Register reg) {
  const auto found = values.find(reg);
  return found == values.end() ? reg : found->second;
}

Register BfinRotateLoops::incoming(const MachineInstr& phi, const MachineBasicBlock& from) const {
  return phi.getOperand(phi.getOperand(2).getMBB() == &from ? 1 : 3).getReg();
}

bool BfinRotateLoops::find(MachineBasicBlock& block, Loop& loop) const {
  const auto end = block.getFirstTerminator();
  if (end == block.end() || end->getOpcode() != Bfin::ENDLOOP ||
      end->getOperand(0).getMBB() != &block || block.succ_size() != 2 || block.pred_size() != 2)
    return false;
  const auto is_other = [&](const MachineBasicBlock* other) { return other != &block; };
  loop.block = &block;
  loop.before = *find_if(block.predecessors(), is_other);
  loop.after = *find_if(block.successors(), is_other);
  for (MachineInstr& inst : loop.before->terminators())
    if (inst.getOpcode() == Bfin::LOOPSETUP)
      loop.setup = &inst;
  return loop.setup != nullptr && loop.before->succ_size() == 1 && sort_body(loop);
}

/// Into loads and the rest. False: nothing would be won.
bool BfinRotateLoops::sort_body(Loop& loop) const {
  bool has_partner = false;
  for (MachineInstr& inst : *loop.block) {
    if (inst.isPHI() || inst.isTerminator())
      continue;
    // A load that went past a store could not go back beside it: nobody knows then that they are
    // apart.
    if (inst.isCall() || inst.isInlineAsm() || inst.hasUnmodeledSideEffects() || inst.mayStore())
      return false;
    const bool ready = all_of(inst.all_uses(), [&](const MachineOperand& use) {
      if (!use.getReg().isVirtual())
        return false;
      const MachineInstr* def = regs_->getVRegDef(use.getReg());
      return def->isPHI() || def->getParent() != loop.block;
    });
    if (inst.mayLoad() && !inst.hasOrderedMemoryRef() && ready) {
      loop.loads.push_back(&inst);
    } else {
      loop.rest.push_back(&inst);
      has_partner |= BfinII::getSlot(inst.getDesc()) == BfinII::kDspSlot;
    }
  }
  return has_partner && !loop.loads.empty() &&
         loop.loads.size() + loop.rest.size() <= kMostInstructions;
}

/// Lets an instruction read `value` instead, which may be of the other bank.
void BfinRotateLoops::replace(MachineOperand& use, Register value) {
  const TargetRegisterClass* wanted = regs_->getRegClass(use.getReg());
  MachineInstr& user = *use.getParent();
  if (!wanted->hasSubClassEq(regs_->getRegClass(value))) {
    const Register copy = regs_->createVirtualRegister(wanted);
    BuildMI(*user.getParent(), user, user.getDebugLoc(), tii_->get(TargetOpcode::COPY), copy)
        .addReg(value);
    value = copy;
  }
  use.setReg(value);
  use.setIsKill(false);
}

/// Appends `inst` with its values replaced; what it defines gets new registers, noted in `values`.
void BfinRotateLoops::clone(const MachineInstr& inst, MachineBasicBlock& block, Registers& values) {
  MachineInstr* copy = function_->CloneMachineInstr(&inst);
  block.insert(block.getFirstTerminator(), copy);
  for (MachineOperand& operand : copy->operands()) {
    if (!operand.isReg() || !operand.getReg().isVirtual())
      continue;
    if (operand.isUse())
      replace(operand, value_of(values, operand.getReg()));
  }
  for (MachineOperand& operand : copy->defs())
    if (operand.getReg().isVirtual()) {
      const Register reg = alike(operand.getReg());
      values[operand.getReg()] = reg;
      operand.setReg(reg);
    }
}

/// The first pass's loads, in front of the loop. What each register of the body then is.
Registers BfinRotateLoops::load_before(const Loop& loop) {
  Registers values;
  for (const MachineInstr& phi : loop.block->phis())
    values[phi.getOperand(0).getReg()] = incoming(phi, *loop.before);
  for (const MachineInstr* load : loop.loads)
    clone(*load, *loop.before, values);
  return values;
}

bool BfinRotateLoops::runs_twice(const Loop& loop) const {
  const MachineInstr* count = regs_->getVRegDef(loop.setup->getOperand(1).getReg());
  while (count->isCopy() && count->getOperand(1).getReg().isVirtual())
    count = regs_->getVRegDef(count->getOperand(1).getReg());
  return (count->getOpcode() == Bfin::MOVI || count->getOpcode() == Bfin::MOVU) &&
         count->getOperand(1).getImm() > 1;
}

/// The loop makes one pass less; where that is none, control goes to the last one.
void BfinRotateLoops::count_one_less(Loop& loop, MachineBasicBlock* last) {
  MachineBasicBlock& before = *loop.before;
  const DebugLoc& loc = loop.setup->getDebugLoc();
  MachineOperand& count = loop.setup->getOperand(1);
  const Register less = regs_->createVirtualRegister(&Bfin::PRegClass);
  const bool twice = runs_twice(loop);
  BuildMI(before, loop.setup, loc, tii_->get(Bfin::ADDI), less).addReg(count.getReg()).addImm(-1);
  regs_->clearKillFlags(count.getReg());
  count.setReg(less);
  count.setIsKill(false);
  if (twice)
    return;
  MachineBasicBlock* enter = function_->CreateMachineBasicBlock(loop.block->getBasicBlock());
  function_->insert(std::next(before.getIterator()), enter);
  enter->splice(enter->end(), &before, loop.setup->getIterator(), before.end());
  before.replaceSuccessor(loop.block, enter);
  enter->addSuccessor(loop.block);
  loop.block->replacePhiUsesWith(&before, enter);
  before.addSuccessor(last, BranchProbability(1, 16));
  before.normalizeSuccProbs();
  BuildMI(&before, loc, tii_->get(Bfin::CMPEQI)).addReg(less).addImm(0);
  BuildMI(&before, loc, tii_->get(Bfin::JCC)).addMBB(last).addImm(0);
}

/// The last pass, behind the loop, and where the only one begins. `first` and `next`: what the
/// registers of the body are on the way from before the loop and from the loop; `found`: by what
/// name the rest reads what the loads found.
MachineBasicBlock* BfinRotateLoops::make_last(const Loop& loop, const Registers& first,
                                              const Registers& next, const Registers& found) {
  MachineBasicBlock* last = function_->CreateMachineBasicBlock(loop.block->getBasicBlock());
  function_->insert(std::next(loop.block->getIterator()), last);
  const bool only = !runs_twice(loop);
  Registers values;
  for (const auto& [reg, from_loop] : next) {
    if (!only) {
      values[reg] = from_loop;
      continue;
    }
    values[reg] = alike(reg);
    BuildMI(*last, last->begin(), DebugLoc(), tii_->get(TargetOpcode::PHI), values[reg])
        .addReg(value_of(first, reg))
        .addMBB(loop.before)
        .addReg(from_loop)
        .addMBB(loop.block);
  }
  for (const auto& [reg, phi] : found)
    values[phi] = values[reg];
  for (const MachineInstr* inst : loop.rest)
    clone(*inst, *last, values);
  // Whoever is outside sees the last pass.
  for (MachineInstr& inst : *loop.block)
    for (const MachineOperand& def : inst.defs()) {
      if (!def.getReg().isVirtual())
        continue;
      for (MachineOperand& use : make_early_inc_range(regs_->use_operands(def.getReg()))) {
        const MachineBasicBlock* user = use.getParent()->getParent();
        if (user != loop.block && user != last)
          use.setReg(value_of(values, def.getReg()));
      }
    }
  last->addSuccessor(loop.after);
  if (!last->isLayoutSuccessor(loop.after))
    BuildMI(last, loop.rest.back()->getDebugLoc(), tii_->get(Bfin::JUMP)).addMBB(loop.after);
  loop.block->replaceSuccessor(loop.after, last);
  loop.after->replacePhiUsesWith(loop.block, last);
  return last;
}

/// What is known of a load's address is known of the pass that it was in, not of the next.
void BfinRotateLoops::forget_address(MachineInstr& load) {
  SmallVector<MachineMemOperand*, 1> accesses;
  for (const MachineMemOperand* access : load.memoperands())
    accesses.push_back(function_->getMachineMemOperand(
        MachinePointerInfo(), access->getFlags(), access->getMemoryType(), access->getBaseAlign()));
  load.setMemRefs(*function_, accesses);
}

void BfinRotateLoops::rotate(Loop& loop) {
  MachineBasicBlock& block = *loop.block;
  for (MachineInstr* load : loop.loads)
    forget_address(*load);
  const Registers first = load_before(loop);

  // What the loads found lives from one pass to the next.
  Registers found;
  for (const MachineInstr* load : loop.loads)
    for (const MachineOperand& def : load->defs())
      found[def.getReg()] = alike(def.getReg());
  for (MachineInstr* inst : loop.rest)
    for (MachineOperand& use : inst->all_uses())
      if (found.count(use.getReg()) != 0) {
        use.setReg(found[use.getReg()]);
        use.setIsKill(false);
      }
  // What the registers of the body are when the next pass begins: by the pass's own end, but for
  // the loads, which then are already made.
  Registers next;
  for (MachineInstr& phi : block.phis()) {
    MachineOperand& own = phi.getOperand(phi.getOperand(2).getMBB() == &block ? 1 : 3);
    if (found.count(own.getReg()) != 0)
      own.setReg(found[own.getReg()]);
    next[phi.getOperand(0).getReg()] = own.getReg();
  }
  Registers at_end = next;
  for (MachineInstr* load : loop.loads) {
    block.remove(load);
    block.insert(block.getFirstTerminator(), load);
    for (MachineOperand& use : load->all_uses())
      replace(use, value_of(at_end, use.getReg()));
    for (const MachineOperand& def : load->defs())
      next[def.getReg()] = def.getReg();
  }
  for (const auto& [reg, phi] : found)
    BuildMI(block, block.begin(), DebugLoc(), tii_->get(TargetOpcode::PHI), phi)
        .addReg(value_of(first, reg))
        .addMBB(loop.before)
        .addReg(reg)
        .addMBB(&block);
  for (const auto& [reg, value] : next)
    regs_->clearKillFlags(value);

  MachineBasicBlock* last = make_last(loop, first, next, found);
  for (MachineInstr& inst : make_early_inc_range(block.terminators()))
    if (inst.getOpcode() == Bfin::JUMP)
      inst.getOperand(0).setMBB(last);
  count_one_less(loop, last);
}

bool BfinRotateLoops::runOnMachineFunction(MachineFunction& function) {
  if (function.getFunction().hasOptSize())
    return false;
  function_ = &function;
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  std::vector<Loop> loops;
  for (MachineBasicBlock& block : function) {
    Loop loop;
    if (find(block, loop))
      loops.push_back(std::move(loop));
  }
  for (Loop& loop : loops)
    rotate(loop);
  return !loops.empty();
}

}  // namespace

FunctionPass* createBfinRotateLoops() { return new BfinRotateLoops(); }

}  // namespace llvm
