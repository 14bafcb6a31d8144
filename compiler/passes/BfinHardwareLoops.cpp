// Which loops run on the loop counters. The middle end has marked every loop whose count is known
// on entry, counting in a register; here, on machine code, calls that selection introduced are
// seen, too. Innermost loops get a counter, and one loop around them the other one: LC1 inside, LC0
// outside, as the hardware wants where both end together. What is left counts down in its register.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineLoopInfo.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/InitializePasses.h>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinMachineFunctionInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

constexpr unsigned kMostBytes = 1600;  // of a body, before allocation adds its own

class BfinHardwareLoops : public MachineFunctionPass {
 public:
  static char ID;
  BfinHardwareLoops() : MachineFunctionPass(ID) {
    initializeMachineLoopInfoWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin hardware loops"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<MachineLoopInfoWrapperPass>();
    usage.setPreservesCFG();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  /// The instructions that count one loop.
  struct Counting {
    MachineInstr* start = nullptr;
    MachineInstr* phi = nullptr;
    MachineInstr* decrement = nullptr;
    MachineInstr* compare = nullptr;
    MachineInstr* branch = nullptr;
  };

  int visit(MachineLoop& loop);
  bool find_counting(MachineLoop& loop, Counting& counting) const;
  bool body_allows(const MachineLoop& loop) const;
  void convert(MachineLoop& loop, const Counting& counting);
  void give_counters(MachineFunction& function);
  void count_in_registers(MachineFunction& function);

  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
  /// Converted loops: setup, end, and whether a converted loop lies around them.
  struct Converted {
    MachineLoop* loop;
    MachineInstr* setup;
    MachineInstr* end;
  };
  std::vector<Converted> converted_;
};

char BfinHardwareLoops::ID = 0;

bool BfinHardwareLoops::find_counting(MachineLoop& loop, Counting& counting) const {
  MachineBasicBlock* latch = loop.getLoopLatch();
  MachineBasicBlock* header = loop.getHeader();
  if (latch == nullptr)
    return false;
  for (MachineInstr& inst : *latch)
    if (inst.getOpcode() == Bfin::LOOPDEC)
      counting.decrement = &inst;
  if (counting.decrement == nullptr)
    return false;
  Register count = counting.decrement->getOperand(1).getReg();
  Register next = counting.decrement->getOperand(0).getReg();
  counting.phi = regs_->getVRegDef(count);
  if (!counting.phi->isPHI() || counting.phi->getParent() != header ||
      counting.phi->getNumOperands() != 5 || !regs_->hasOneNonDBGUse(count))
    return false;
  for (MachineInstr& use : regs_->use_nodbg_instructions(next))
    if (use.getOpcode() == Bfin::CMPEQI && use.getParent() == latch &&
        use.getOperand(1).getImm() == 0 && counting.compare == nullptr)
      counting.compare = &use;
    else if (&use != counting.phi)
      return false;
  for (unsigned i : {1U, 3U})
    if (counting.phi->getOperand(i + 1).getMBB() != latch)
      counting.start = regs_->getVRegDef(counting.phi->getOperand(i).getReg());
  auto branch = latch->getFirstTerminator();
  if (counting.compare == nullptr || counting.start == nullptr || branch == latch->end())
    return false;
  counting.branch = &*branch;
  return counting.start->getOpcode() == Bfin::LOOPSTART &&
         regs_->hasOneNonDBGUse(counting.start->getOperand(0).getReg()) &&
         counting.start->getParent()->succ_size() == 1 &&
         counting.start->getParent()->isSuccessor(header) && branch->getOpcode() == Bfin::JNCC &&
         branch->getOperand(0).getMBB() == header;
}

bool BfinHardwareLoops::body_allows(const MachineLoop& loop) const {
  unsigned bytes = 0;
  for (const MachineBasicBlock* block : loop.blocks())
    for (const MachineInstr& inst : *block) {
      if (inst.isCall() || inst.isInlineAsm())
        return false;
      bytes +=
          inst.isMetaInstruction() || inst.isPHI() ? 0 : std::max(4U, inst.getDesc().getSize());
    }
  return bytes <= kMostBytes;
}

void BfinHardwareLoops::convert(MachineLoop& loop, const Counting& counting) {
  MachineBasicBlock* before = counting.start->getParent();
  MachineBasicBlock* latch = loop.getLoopLatch();
  Register count = regs_->createVirtualRegister(&Bfin::PRegClass);
  const MachineInstr* counted = regs_->getVRegDef(counting.start->getOperand(1).getReg());
  while (counted->isCopy() && counted->getOperand(1).getReg().isVirtual())
    counted = regs_->getVRegDef(counted->getOperand(1).getReg());
  regs_->clearKillFlags(counting.start->getOperand(1).getReg());
  BuildMI(*before, before->getFirstTerminator(), counting.start->getDebugLoc(),
          tii_->get(TargetOpcode::COPY), count)
      .addReg(counting.start->getOperand(1).getReg());
  // The counter's number is settled once it is known what lies around this loop.
  MachineInstr* setup = BuildMI(*before, before->getFirstTerminator(),
                                counting.start->getDebugLoc(), tii_->get(Bfin::LOOPSETUP))
                            .addImm(0)
                            .addReg(count)
                            .addImm(counted->getOpcode() == Bfin::ATLEASTTWO ? 2 : 1);
  MachineInstr* end =
      BuildMI(*latch, counting.branch, counting.branch->getDebugLoc(), tii_->get(Bfin::ENDLOOP))
          .addMBB(loop.getHeader())
          .addImm(0);
  counting.branch->eraseFromParent();
  counting.compare->eraseFromParent();
  counting.phi->eraseFromParent();
  counting.decrement->eraseFromParent();
  counting.start->eraseFromParent();
  converted_.push_back({&loop, setup, end});
}

/// Converts what it can within the loop and the loop itself; how deep counters nest there.
int BfinHardwareLoops::visit(MachineLoop& loop) {
  int depth = 0;
  for (MachineLoop* inner : loop)
    depth = std::max(depth, visit(*inner));
  Counting counting;
  if (depth >= 2 || !find_counting(loop, counting) || !body_allows(loop))
    return depth;
  convert(loop, counting);
  return depth + 1;
}

void BfinHardwareLoops::give_counters(MachineFunction& function) {
  for (const Converted& inner : converted_) {
    bool enclosed = any_of(converted_, [&](const Converted& outer) {
      return outer.loop != inner.loop && outer.loop->contains(inner.loop);
    });
    inner.setup->getOperand(0).setImm(enclosed ? 1 : 0);
    inner.end->getOperand(1).setImm(enclosed ? 1 : 0);
  }
  function.getInfo<BfinMachineFunctionInfo>()->has_hardware_loops = !converted_.empty();
}

void BfinHardwareLoops::count_in_registers(MachineFunction& function) {
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : make_early_inc_range(block)) {
      Register to = inst.getNumOperands() > 0 && inst.getOperand(0).isReg()
                        ? inst.getOperand(0).getReg()
                        : Register();
      if (inst.getOpcode() == Bfin::LOOPSTART || inst.getOpcode() == Bfin::ATLEASTTWO)
        BuildMI(block, inst, inst.getDebugLoc(), tii_->get(TargetOpcode::COPY), to)
            .addReg(inst.getOperand(1).getReg());
      else if (inst.getOpcode() == Bfin::LOOPDEC)
        BuildMI(block, inst, inst.getDebugLoc(), tii_->get(Bfin::ADDI), to)
            .addReg(inst.getOperand(1).getReg())
            .addImm(-1);
      else
        continue;
      inst.eraseFromParent();
    }
}

bool BfinHardwareLoops::runOnMachineFunction(MachineFunction& function) {
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  converted_.clear();
  for (MachineLoop* loop : getAnalysis<MachineLoopInfoWrapperPass>().getLI())
    visit(*loop);
  give_counters(function);
  count_in_registers(function);
  return true;
}

}  // namespace

FunctionPass* createBfinHardwareLoops() { return new BfinHardwareLoops(); }

}  // namespace llvm
