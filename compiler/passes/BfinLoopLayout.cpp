// After allocation and block placement: every hardware loop becomes LSETUP and its two labels.
// LSETUP stands right before the loop's top and the latch comes last; a loop that has grown beyond
// LSETUP's reach (4..2046 bytes to the last instruction, hardware.md 1.4) counts down in software,
// with the count still in LC.
#include <llvm/CodeGen/LivePhysRegs.h>
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/MC/MCContext.h>
#include <map>
#include <set>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

// Less than the field holds: branch relaxation, which follows, may still add a few jumps.
constexpr unsigned kFarthestEnd = 1900;

class BfinLoopLayout : public MachineFunctionPass {
 public:
  static char ID;
  BfinLoopLayout() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin loop layout"; }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  struct HardwareLoop {
    MachineBasicBlock* top;
    MachineBasicBlock* latch;
    MachineInstr* end;
    MachineInstr* setup = nullptr;
    std::set<MachineBasicBlock*> blocks;
  };

  void collect(MachineFunction& function);
  void order_blocks(MachineFunction& function);
  void place_setup(HardwareLoop& loop);
  bool reaches(const HardwareLoop& loop) const;
  void write_setup(HardwareLoop& loop);
  void count_in_software(HardwareLoop& loop);

  const BfinInstrInfo* tii_ = nullptr;
  std::vector<HardwareLoop> loops_;
};

char BfinLoopLayout::ID = 0;

std::set<MachineBasicBlock*> natural_loop(MachineBasicBlock* top, MachineBasicBlock* latch) {
  std::set<MachineBasicBlock*> blocks = {top};
  std::vector<MachineBasicBlock*> worklist = {latch};
  while (!worklist.empty()) {
    MachineBasicBlock* block = worklist.back();
    worklist.pop_back();
    if (blocks.insert(block).second)
      worklist.insert(worklist.end(), block->pred_begin(), block->pred_end());
  }
  return blocks;
}

void BfinLoopLayout::collect(MachineFunction& function) {
  loops_.clear();
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : block.terminators())
      if (inst.getOpcode() == Bfin::ENDLOOP) {
        MachineBasicBlock* top = inst.getOperand(0).getMBB();
        loops_.push_back({top, &block, &inst, nullptr, natural_loop(top, &block)});
      }
  for (HardwareLoop& loop : loops_)
    for (MachineBasicBlock* before : loop.top->predecessors())
      if (before != loop.latch)
        for (MachineInstr& inst : before->terminators())
          if (inst.getOpcode() == Bfin::LOOPSETUP)
            loop.setup = &inst;
  for (const HardwareLoop& loop : loops_)
    if (loop.setup == nullptr)
      report_fatal_error("a hardware loop lost its LSETUP");
  // Outer loops first: ordering an inner one then keeps within its outer one's place.
  stable_sort(loops_, [](const HardwareLoop& a, const HardwareLoop& b) {
    return a.blocks.size() > b.blocks.size();
  });
}

/// Brings each loop's blocks together, top first and latch last; others keep their order.
void BfinLoopLayout::order_blocks(MachineFunction& function) {
  std::map<MachineBasicBlock*, MachineBasicBlock*> follower;
  for (MachineBasicBlock& block : function) {
    auto next = std::next(block.getIterator());
    follower[&block] = next == function.end() ? nullptr : &*next;
  }
  for (HardwareLoop& loop : loops_) {
    std::vector<MachineBasicBlock*> order;
    for (MachineBasicBlock& block : function)
      if (loop.blocks.count(&block) != 0 && &block != loop.top && &block != loop.latch)
        order.push_back(&block);
    order.insert(order.begin(), loop.top);
    if (loop.latch != loop.top)
      order.push_back(loop.latch);
    MachineBasicBlock* first = &*find_if(
        function, [&](MachineBasicBlock& block) { return loop.blocks.count(&block) != 0; });
    if (first != loop.top)
      loop.top->moveBefore(first);
    for (size_t i = 1; i < order.size(); ++i)
      if (&*std::next(order[i - 1]->getIterator()) != order[i])
        order[i]->moveAfter(order[i - 1]);
  }
  for (MachineBasicBlock& block : function) {
    SmallVector<MachineOperand, 2> condition;
    MachineBasicBlock* taken = nullptr;
    MachineBasicBlock* not_taken = nullptr;
    if (!tii_->analyzeBranch(block, taken, not_taken, condition, false) && !block.succ_empty())
      block.updateTerminator(follower[&block]);
  }
}

/// LSETUP ends the block in front of the top: its own block, or a new one that the other jumps to.
void BfinLoopLayout::place_setup(HardwareLoop& loop) {
  MachineBasicBlock& before = *loop.setup->getParent();
  MachineFunction& function = *before.getParent();
  if (before.isLayoutSuccessor(loop.top))
    return;
  MachineBasicBlock* block = function.CreateMachineBasicBlock();
  function.insert(loop.top->getIterator(), block);
  MachineInstr* setup = loop.setup->removeFromParent();
  before.replaceSuccessor(loop.top, block);
  block->addSuccessor(loop.top);
  for (MachineInstr& inst : before.terminators())
    if (inst.getOpcode() == Bfin::JUMP)
      inst.getOperand(0).setMBB(block);
  block->push_back(setup);
  for (const MachineBasicBlock::RegisterMaskPair& live : loop.top->liveins())
    block->addLiveIn(live);
  auto count = static_cast<MCPhysReg>(setup->getOperand(1).getReg().id());
  if (!block->isLiveIn(count))
    block->addLiveIn(count);
  for (HardwareLoop& outer : loops_)
    if (outer.blocks.count(&before) != 0)
      outer.blocks.insert(block);
}

/// Not what changes the flow, synchronises, or writes a loop register.
bool may_end_loop(const MachineInstr& inst) {
  if (inst.getOpcode() == Bfin::MOV)
    return Bfin::DPRegClass.contains(inst.getOperand(0).getReg());
  return !inst.isMetaInstruction() && !inst.isCall() && !inst.isBranch() &&
         !inst.hasUnmodeledSideEffects();
}

/// The last instruction of the latch; a NOP where there is none that may end a loop.
MachineInstr& last_instruction(MachineBasicBlock& latch, MachineInstr& end,
                               const BfinInstrInfo& tii) {
  auto at = end.getIterator();
  while (at != latch.instr_begin() &&
         (std::prev(at)->isMetaInstruction() || std::prev(at)->isInsideBundle()))
    --at;
  if (at != latch.instr_begin() && may_end_loop(*std::prev(at)))
    return *std::prev(at);
  return *BuildMI(latch, end, end.getDebugLoc(), tii.get(Bfin::NOP));
}

bool BfinLoopLayout::reaches(const HardwareLoop& loop) const {
  unsigned bytes = 0;
  for (auto it = loop.top->getIterator();; ++it) {
    if (it == loop.top->getParent()->end())
      return false;
    for (const MachineInstr& inst : *it)
      bytes += tii_->getInstSizeInBytes(inst);
    if (&*it == loop.latch)
      return bytes <= kFarthestEnd;
  }
}

void BfinLoopLayout::write_setup(HardwareLoop& loop) {
  MachineFunction& function = *loop.top->getParent();
  MachineInstr& last = last_instruction(*loop.latch, *loop.end, *tii_);
  MCSymbol* symbol = last.getPreInstrSymbol();
  if (symbol == nullptr) {
    symbol = function.getContext().createNamedTempSymbol("loop_end");
    last.setPreInstrSymbol(function, symbol);
  }
  MachineInstr& setup = *loop.setup;
  loop.top->setLabelMustBeEmitted();
  BuildMI(*setup.getParent(), setup, setup.getDebugLoc(), tii_->get(Bfin::LSETUP))
      .addMBB(loop.top)
      .addSym(symbol)
      .addReg(setup.getOperand(0).getImm() == 0 ? Bfin::LC0 : Bfin::LC1)
      .addReg(setup.getOperand(1).getReg());
  setup.eraseFromParent();
}

/// The count stays in LC, which is no loop without LSETUP; a data register is borrowed to step it.
void BfinLoopLayout::count_in_software(HardwareLoop& loop) {
  MCPhysReg lc = loop.setup->getOperand(0).getImm() == 0 ? Bfin::LC0 : Bfin::LC1;
  BuildMI(*loop.setup->getParent(), *loop.setup, loop.setup->getDebugLoc(), tii_->get(Bfin::MOV),
          lc)
      .addReg(loop.setup->getOperand(1).getReg());
  loop.setup->eraseFromParent();
  MachineBasicBlock& latch = *loop.latch;
  MachineInstr& end = *loop.end;
  const DebugLoc& loc = end.getDebugLoc();
  BuildMI(latch, end, loc, tii_->get(Bfin::PUSH)).addReg(Bfin::R0, RegState::Undef);
  BuildMI(latch, end, loc, tii_->get(Bfin::MOV), Bfin::R0).addReg(lc);
  BuildMI(latch, end, loc, tii_->get(Bfin::ADDI), Bfin::R0).addReg(Bfin::R0).addImm(-1);
  BuildMI(latch, end, loc, tii_->get(Bfin::MOV), lc).addReg(Bfin::R0);
  BuildMI(latch, end, loc, tii_->get(Bfin::CMPEQI)).addReg(Bfin::R0).addImm(0);
  BuildMI(latch, end, loc, tii_->get(Bfin::POP), Bfin::R0);
  BuildMI(latch, end, loc, tii_->get(Bfin::JNCC)).addMBB(loop.top).addImm(1);
  end.eraseFromParent();
}

bool BfinLoopLayout::runOnMachineFunction(MachineFunction& function) {
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  collect(function);
  if (loops_.empty())
    return false;
  order_blocks(function);
  for (HardwareLoop& loop : loops_)
    place_setup(loop);
  for (HardwareLoop& loop : loops_)
    if (reaches(loop))
      write_setup(loop);
    else
      count_in_software(loop);
  return true;
}

}  // namespace

FunctionPass* createBfinLoopLayout() { return new BfinLoopLayout(); }

}  // namespace llvm
