// Short sums of products within another loop, on a loop counter, whose count is known, are written
// out: LSETUP, its count and its pointer register are spared in each round of the loop around, and
// the last pass meets what stands behind it. Of the pointers as many move to I registers as packets
// want for their second accesses. Works on SSA form before allocation, on loops of one block that
// store nothing. Other short loops LLVM has unrolled.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineLoopInfo.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/InitializePasses.h>
#include <map>
#include <optional>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"
#include "CountedLoop.hpp"
#include "IndexForms.hpp"
#include "LoopDependences.hpp"
#include "LoopPhis.hpp"
#include "PacketSlots.hpp"

namespace llvm {
namespace {

constexpr int64_t kMostPasses = 8;
constexpr size_t kMostUnrolled = 48;  // of all passes together

class BfinUnrollLoops : public MachineFunctionPass {
 public:
  static char ID;
  BfinUnrollLoops() : MachineFunctionPass(ID) {
    initializeMachineLoopInfoWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin unrolled loops"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<MachineLoopInfoWrapperPass>();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  struct Loop : CountedLoop {
    int64_t passes = 0;
  };
  using Registers = std::map<Register, Register>;

  bool find(MachineBasicBlock& block, Loop& loop) const;
  std::optional<int64_t> passes(const MachineInstr& setup) const;
  void use_index_registers(const Loop& loop);
  void write_out(const Loop& loop);
  void write_pass(const Loop& loop, Registers& values);
  void forget_addresses(MachineBasicBlock& block);
  void join(MachineBasicBlock& first, MachineBasicBlock& second);

  MachineFunction* function_ = nullptr;
  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
};

char BfinUnrollLoops::ID = 0;

std::optional<int64_t> BfinUnrollLoops::passes(const MachineInstr& setup) const {
  const MachineInstr* count = regs_->getVRegDef(setup.getOperand(1).getReg());
  while (count->isCopy() && count->getOperand(1).getReg().isVirtual())
    count = regs_->getVRegDef(count->getOperand(1).getReg());
  if (count->getOpcode() != Bfin::MOVI && count->getOpcode() != Bfin::MOVU)
    return std::nullopt;
  return count->getOperand(1).getImm();
}

bool is_product(const MachineInstr& inst) {
  return inst.getOpcode() == Bfin::MAC0 || inst.getOpcode() == Bfin::MAC1 ||
         inst.getOpcode() == Bfin::MACMAC;
}

bool BfinUnrollLoops::find(MachineBasicBlock& block, Loop& loop) const {
  if (!loop.find(block))
    return false;
  const std::optional<int64_t> known = passes(*loop.setup);
  const auto count = static_cast<size_t>(count_if(
      block, [](const MachineInstr& inst) { return !inst.isPHI() && !inst.isTerminator(); }));
  loop.passes = known.value_or(0);
  return loop.passes > 0 && loop.passes <= kMostPasses &&
         count * static_cast<size_t>(loop.passes) <= kMostUnrolled && any_of(block, is_product) &&
         none_of(block, [](const MachineInstr& inst) {
           return inst.isCall() || inst.isInlineAsm() || inst.isPosition() || inst.isDebugInstr() ||
                  (!inst.isTerminator() && (inst.mayStore() || inst.hasOrderedMemoryRef() ||
                                            inst.hasUnmodeledSideEffects()));
         });
}

/// Whether nothing behind the loop wants the pointer.
bool ends_with_loop(const IndexStream& stream, const MachineRegisterInfo& regs) {
  return all_of(stream.accesses, [&](const MachineInstr* access) {
    return all_of(access->defs(), [&](const MachineOperand& def) {
      return all_of(regs.use_nodbg_instructions(def.getReg()), [&](const MachineInstr& use) {
        return use.getParent() == access->getParent();
      });
    });
  });
}

/// Until there are no more accesses through P registers than other packets.
void BfinUnrollLoops::use_index_registers(const Loop& loop) {
  int accesses = 0;  // through P registers
  int operations = 0;
  for (const MachineInstr& inst : *loop.block) {
    if (inst.isPHI() || inst.isTerminator())
      continue;
    const unsigned slot = slot_of(inst, *tii_);
    accesses += slot == BfinII::kMemSlot ? 1 : 0;
    operations += slot == BfinII::kDspSlot ? 1 : 0;
  }
  for (const IndexStream& stream : index_streams(*loop.block)) {
    if (accesses <= operations || !stream.zero_extended.empty() || !ends_with_loop(stream, *regs_))
      continue;
    accesses -= static_cast<int>(stream.accesses.size());
    use_index_register(stream, *loop.before, *tii_);
  }
}

/// One pass at the end of `before`; the values of the body's registers go on to the next.
void BfinUnrollLoops::write_pass(const Loop& loop, Registers& values) {
  const auto value_of = [&](Register reg) {
    const auto found = values.find(reg);
    return found == values.end() ? reg : found->second;
  };
  for (const MachineInstr& inst : *loop.block) {
    if (inst.isPHI() || inst.isTerminator())
      continue;
    MachineInstr* copy = function_->CloneMachineInstr(&inst);
    loop.before->insert(loop.before->getFirstTerminator(), copy);
    for (MachineOperand& use : copy->all_uses())
      if (use.getReg().isVirtual()) {
        const Register value = value_of(use.getReg());
        regs_->constrainRegClass(value, regs_->getRegClass(use.getReg()));
        use.setReg(value);
        use.setIsKill(false);
      }
    for (MachineOperand& def : copy->defs())
      if (def.getReg().isVirtual()) {
        const Register own = regs_->createVirtualRegister(regs_->getRegClass(def.getReg()));
        values[def.getReg()] = own;
        def.setReg(own);
      }
  }
  Registers next = values;
  for (const MachineInstr& phi : loop.block->phis())
    next[phi.getOperand(0).getReg()] =
        value_of(phi.getOperand(incoming_operand(phi, *loop.block)).getReg());
  values = std::move(next);
}

/// What is known of an access's address is known of its own pass.
void BfinUnrollLoops::forget_addresses(MachineBasicBlock& block) {
  const LoopScopes scopes(block);
  for (MachineInstr& inst : block) {
    SmallVector<MachineMemOperand*, 1> places;
    for (const MachineMemOperand* place : inst.memoperands())
      places.push_back(in_any_pass(*function_, *place, scopes));
    inst.setMemRefs(*function_, places);
  }
}

/// One block of two, the second of which is reached from the first alone.
void BfinUnrollLoops::join(MachineBasicBlock& first, MachineBasicBlock& second) {
  MachineBasicBlock* next = second.getNextNode();
  const bool falls = second.canFallThrough();
  for (MachineInstr& phi : make_early_inc_range(second.phis())) {
    const Register reg = phi.getOperand(0).getReg();
    const Register value = phi.getOperand(1).getReg();
    phi.eraseFromParent();
    regs_->constrainRegClass(value, regs_->getRegClass(reg));
    regs_->clearKillFlags(value);
    regs_->replaceRegWith(reg, value);
  }
  first.splice(first.end(), &second, second.begin(), second.end());
  first.removeSuccessor(&second);
  first.transferSuccessorsAndUpdatePHIs(&second);
  second.eraseFromParent();
  if (falls && next != nullptr && !first.isLayoutSuccessor(next))
    BuildMI(&first, DebugLoc(), tii_->get(Bfin::JUMP)).addMBB(next);
}

void BfinUnrollLoops::write_out(const Loop& loop) {
  Registers values;
  for (const MachineInstr& phi : loop.block->phis())
    values[phi.getOperand(0).getReg()] =
        phi.getOperand(incoming_operand(phi, *loop.before)).getReg();
  Registers last;
  for (int64_t pass = 0; pass < loop.passes; ++pass) {
    last = values;  // what the phis are in it
    write_pass(loop, values);
  }
  for (const MachineInstr& inst : *loop.block)
    for (const MachineOperand& def : inst.defs()) {
      if (!def.getReg().isVirtual())
        continue;
      const Register value = inst.isPHI() ? last[def.getReg()] : values[def.getReg()];
      for (MachineOperand& use : make_early_inc_range(regs_->use_operands(def.getReg())))
        if (use.getParent()->getParent() != loop.block) {
          regs_->constrainRegClass(value, regs_->getRegClass(def.getReg()));
          use.setReg(value);
          use.setIsKill(false);
        }
    }
  for (const auto& [reg, value] : values)
    regs_->clearKillFlags(value);
  loop.before->replaceSuccessor(loop.block, loop.after);
  loop.after->replacePhiUsesWith(loop.block, loop.before);
  loop.block->removeSuccessor(loop.after);
  loop.block->removeSuccessor(loop.block);
  const DebugLoc loc = loop.setup->getDebugLoc();
  while (loop.before->getFirstTerminator() != loop.before->end())
    loop.before->back().eraseFromParent();
  loop.block->eraseFromParent();
  if (loop.after->pred_size() == 1 && !loop.after->hasAddressTaken())
    join(*loop.before, *loop.after);
  else if (!loop.before->isLayoutSuccessor(loop.after))
    BuildMI(loop.before, loc, tii_->get(Bfin::JUMP)).addMBB(loop.after);
}

bool BfinUnrollLoops::runOnMachineFunction(MachineFunction& function) {
  if (function.getFunction().hasOptSize())
    return false;
  function_ = &function;
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  const MachineLoopInfo& loops = getAnalysis<MachineLoopInfoWrapperPass>().getLI();
  std::vector<MachineBasicBlock*> within;
  for (MachineBasicBlock& block : function)
    if (block.isSuccessor(&block) && loops.getLoopDepth(&block) > 1)
      within.push_back(&block);
  bool changed = false;
  for (MachineBasicBlock* block : within) {
    Loop loop;  // found now: what lies before it may have become one block with others
    if (!find(*block, loop))
      continue;
    use_index_registers(loop);
    forget_addresses(*loop.block);
    write_out(loop);
    changed = true;
  }
  return changed;
}

}  // namespace

FunctionPass* createBfinUnrollLoops() { return new BfinUnrollLoops(); }

}  // namespace llvm
