// Circular buffers (middle/CircularBuffers says which) as the address generators have them: a value
// that goes from RINGBEGIN through phis and RINGNEXTs to RINGDONE moves to a ring register, the I,
// M, B and L registers of one number. Its accesses go through it, the last one before a step steps,
// and where the ring is done its length becomes 0 again.
// Works on what selection left, before all other passes: to these, rings are a class of their own.
// What no access through an I register does, on bytes or at a distance, goes through a copy of the
// index.
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/CodeGen/MachineDominators.h>
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/IR/Instructions.h>
#include <llvm/InitializePasses.h>
#include <optional>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinNamedInstructions.hpp"
#include "../target/BfinSubtarget.hpp"
#include "IndexForms.hpp"

namespace llvm {
namespace {

/// An access at a pointer, and its forms through a ring; 0 where there is none.
struct RingForms {
  unsigned plain;
  unsigned ring;
  unsigned up;       // steps by its size
  unsigned down;     // steps back by it
  unsigned by_step;  // steps by M
  unsigned extends;  // what makes the upper half of what a load of 16 bits finds
  int size;
};
constexpr RingForms kRingForms[] = {
    {Bfin::LDW, Bfin::LDWR, Bfin::LDWRInc, Bfin::LDWRDec, Bfin::LDWRStep, 0, 4},
    {Bfin::LDHZ, Bfin::LDLR, Bfin::LDLRInc, Bfin::LDLRDec, 0, Bfin::ZXH, 2},
    {Bfin::LDHX, Bfin::LDLR, Bfin::LDLRInc, Bfin::LDLRDec, 0, Bfin::SXH, 2},
    {Bfin::STW, Bfin::STWR, Bfin::STWRInc, Bfin::STWRDec, Bfin::STWRStep, 0, 4},
    {Bfin::STH, Bfin::STHR, Bfin::STHRInc, Bfin::STHRDec, 0, 0, 2},
};

class BfinRings : public MachineFunctionPass {
 public:
  static char ID;
  BfinRings() : MachineFunctionPass(ID) {
    initializeMachineDominatorTreeWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin circular buffers"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<MachineDominatorTreeWrapperPass>();
    usage.setPreservesCFG();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  struct Ring {
    MachineInstr* begin = nullptr;
    std::vector<Register> values;       // from the beginning through phis and steps
    std::vector<MachineInstr*> steps;   // RINGNEXT
    std::optional<int64_t> step_bytes;  // where they are known
    bool by_step = false;               // is M wanted?
  };

  Ring follow(MachineInstr& begin);
  void use_ring(Ring& ring, Register value);
  bool access(MachineInstr& inst, Register value);
  Register index_of(MachineBasicBlock& block, MachineBasicBlock::iterator at, Register value);
  void read_index(MachineOperand& use, Register index);
  void step(Ring& ring, MachineInstr& next);
  MachineInstr* last_access(const MachineInstr& next, Register value) const;
  void load(Ring& ring);
  void end(MachineInstr& done, Register value);
  Register copy(Register value, const TargetRegisterClass& rc, MachineInstr& at);
  std::optional<int64_t> number(Register value) const;

  MachineFunction* function_ = nullptr;
  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
  const MachineDominatorTree* dominators_ = nullptr;
};

char BfinRings::ID = 0;

/// The constant that a register holds.
std::optional<int64_t> BfinRings::number(Register value) const {
  const MachineInstr* def = regs_->getVRegDef(value);
  while (def != nullptr && def->isCopy() && def->getOperand(1).getReg().isVirtual())
    def = regs_->getVRegDef(def->getOperand(1).getReg());
  if (def == nullptr || (def->getOpcode() != Bfin::MOVI && def->getOpcode() != Bfin::MOVU))
    return std::nullopt;
  return def->getOperand(1).getImm();
}

/// The ring's values; copies between them are dropped.
BfinRings::Ring BfinRings::follow(MachineInstr& begin) {
  Ring ring;
  ring.begin = &begin;
  ring.values.push_back(begin.getOperand(0).getReg());
  ring.step_bytes = number(begin.getOperand(4).getReg());
  for (size_t i = 0; i < ring.values.size(); ++i) {
    const Register value = ring.values[i];
    for (MachineInstr& use : make_early_inc_range(regs_->use_nodbg_instructions(value)))
      if (use.isCopy() && use.getOperand(0).getReg().isVirtual() &&
          use.getOperand(0).getSubReg() == 0) {
        const Register other = use.getOperand(0).getReg();
        use.eraseFromParent();
        regs_->replaceRegWith(other, value);
      }
    regs_->clearKillFlags(value);
    for (MachineInstr& use : regs_->use_nodbg_instructions(value)) {
      if (!use.isPHI() && use.getOpcode() != Bfin::RINGNEXT)
        continue;
      if (!is_contained(ring.values, use.getOperand(0).getReg()))
        ring.values.push_back(use.getOperand(0).getReg());
      if (!use.isPHI())
        ring.steps.push_back(&use);
    }
  }
  for (const Register value : ring.values)
    regs_->setRegClass(value, &Bfin::RINGRegClass);
  return ring;
}

Register BfinRings::index_of(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                             Register value) {
  const Register pointer = regs_->createVirtualRegister(&Bfin::DPRegClass);
  BuildMI(block, at, DebugLoc(), tii_->get(TargetOpcode::COPY), pointer)
      .addReg(value, 0, Bfin::sub_i);
  return pointer;
}

/// Lets an operand read the index instead of the ring.
void BfinRings::read_index(MachineOperand& use, Register index) {
  const MachineInstr& inst = *use.getParent();
  const TargetRegisterClass* wanted =
      inst.getRegClassConstraint(use.getOperandNo(), tii_, regs_->getTargetRegisterInfo());
  use.setReg(wanted == nullptr || regs_->constrainRegClass(index, wanted) != nullptr
                 ? index
                 : copy(index, *wanted, *use.getParent()));
}

/// What a ring goes round in, from one of its values; null where that is none.
const Value* base_of(const Value* value, SmallPtrSetImpl<const Value*>& seen) {
  if (!seen.insert(value).second)
    return nullptr;
  if (const auto* phi = dyn_cast<PHINode>(value)) {
    for (const Value* way : phi->incoming_values())
      if (const Value* base = base_of(way, seen))
        return base;
    return nullptr;
  }
  const auto* call = dyn_cast<CallInst>(value);
  const BfinNamedInstruction* named =
      call == nullptr || call->getCalledFunction() == nullptr
          ? nullptr
          : findNamedInstruction(call->getCalledFunction()->getName());
  if (named == nullptr)
    return nullptr;
  return named->opcode == Bfin::RINGBEGIN  ? call->getArgOperand(1)
         : named->opcode == Bfin::RINGNEXT ? base_of(call->getArgOperand(0), seen)
                                           : nullptr;
}

/// The object that a ring's accesses go to: of their address nobody else could tell.
MachinePointerInfo object_of(const MachineMemOperand& place) {
  SmallPtrSet<const Value*, 4> seen;
  const Value* base = place.getValue() == nullptr ? nullptr : base_of(place.getValue(), seen);
  return base == nullptr ? MachinePointerInfo() : MachinePointerInfo(getUnderlyingObject(base));
}

/// Lets an access go through its ring; false where none does the like.
bool BfinRings::access(MachineInstr& inst, Register value) {
  const auto* forms =
      find_if(kRingForms, [&](const RingForms& one) { return one.plain == inst.getOpcode(); });
  if (forms == std::end(kRingForms) || inst.getOperand(1).getReg() != value ||
      inst.getOperand(0).getReg() == value || !inst.getOperand(2).isImm() ||
      inst.getOperand(2).getImm() != 0 || inst.hasOrderedMemoryRef())
    return false;
  MachineBasicBlock& block = *inst.getParent();
  const DebugLoc& loc = inst.getDebugLoc();
  const Register data = inst.getOperand(0).getReg();
  Register moved = data;
  const bool in_data = regs_->constrainRegClass(data, &Bfin::DRegClass) != nullptr;
  if (!in_data || forms->extends != 0)
    moved = regs_->createVirtualRegister(&Bfin::DRegClass);
  if (!in_data && inst.mayStore())
    BuildMI(block, inst, loc, tii_->get(TargetOpcode::COPY), moved).addReg(data);
  MachineInstrBuilder made = BuildMI(block, inst, loc, tii_->get(forms->ring));
  if (inst.mayLoad())
    made.addDef(moved).addReg(value);
  else
    made.addReg(moved).addReg(value);
  if (is_ring_half_load(forms->ring))
    made.addReg(regs_->createVirtualRegister(&Bfin::DRegClass), RegState::Undef);
  if (inst.mayLoad() && moved != data) {
    const bool whole = any_of(regs_->use_nodbg_operands(data), [](const MachineOperand& use) {
      return reads_upper_half(*use.getParent(), use.getOperandNo());
    });
    const unsigned then =
        forms->extends != 0 && whole ? forms->extends : unsigned{TargetOpcode::COPY};
    BuildMI(block, inst, loc, tii_->get(then), data).addReg(moved);
  }
  SmallVector<MachineMemOperand*, 1> places;
  for (const MachineMemOperand* place : inst.memoperands())
    places.push_back(function_->getMachineMemOperand(object_of(*place), place->getFlags(),
                                                     LocationSize::beforeOrAfterPointer(),
                                                     place->getBaseAlign(), place->getAAInfo()));
  made->setMemRefs(*function_, places);
  inst.eraseFromParent();
  return true;
}

/// All uses of one of the ring's values but its steps. Behind a step the value is gone: what reads
/// it there reads a copy from before.
void BfinRings::use_ring(Ring& ring, Register value) {
  MachineInstr* next = nullptr;
  for (MachineInstr* step : ring.steps)
    if (step->getOperand(1).getReg() == value)
      next = step;
  const auto is_behind = [&](const MachineInstr& use) {
    return next != nullptr && &use != next && dominators_->dominates(next, &use);
  };
  Register before;
  std::vector<MachineOperand*> uses;
  for (MachineOperand& use : regs_->use_nodbg_operands(value))
    uses.push_back(&use);
  for (MachineOperand* use : uses) {
    MachineInstr& inst = *use->getParent();
    const bool goes_on = (inst.isPHI() || inst.getOpcode() == Bfin::RINGNEXT) &&
                         is_contained(ring.values, inst.getOperand(0).getReg());
    if (goes_on || inst.getOpcode() == Bfin::RINGEND)
      continue;
    const bool behind = is_behind(inst);
    if (inst.getOpcode() == Bfin::RINGDONE) {
      end(inst, value);
    } else if (behind) {
      if (!before.isValid())
        before = index_of(*next->getParent(), next->getIterator(), value);
      read_index(*use, before);
    } else if (!access(inst, value)) {
      read_index(*use, index_of(*inst.getParent(), inst.getIterator(), value));
    }
  }
}

/// Where it ends: at the beginning of the block behind the loop, in front of all calls.
void BfinRings::end(MachineInstr& done, Register value) {
  MachineBasicBlock& block = *done.getParent();
  const auto at = block.getFirstNonPHI();
  BuildMI(block, at, done.getDebugLoc(), tii_->get(TargetOpcode::COPY), done.getOperand(0).getReg())
      .addReg(value, 0, Bfin::sub_i);
  BuildMI(block, at, done.getDebugLoc(), tii_->get(Bfin::RINGEND),
          regs_->createVirtualRegister(&Bfin::RINGRegClass))
      .addReg(value);
  done.eraseFromParent();
}

/// The last access through the ring in front of its step.
MachineInstr* BfinRings::last_access(const MachineInstr& next, Register value) const {
  MachineInstr* last = nullptr;
  for (MachineInstr& inst : *const_cast<MachineBasicBlock*>(next.getParent())) {
    if (&inst == &next)
      break;
    if (inst.readsVirtualRegister(value))
      last = &inst;
  }
  return last;
}

/// RINGNEXT becomes part of the last access, or a sum.
void BfinRings::step(Ring& ring, MachineInstr& next) {
  const Register stepped = next.getOperand(0).getReg();
  const Register value = next.getOperand(1).getReg();
  MachineInstr* last = last_access(next, value);
  const auto* forms = last == nullptr ? nullptr : find_if(kRingForms, [&](const RingForms& one) {
    return one.ring == last->getOpcode();
  });
  unsigned opcode = 0;
  if (forms != nullptr && forms != std::end(kRingForms))
    opcode = ring.step_bytes == forms->size    ? forms->up
             : ring.step_bytes == -forms->size ? forms->down
                                               : forms->by_step;
  ring.by_step |= opcode == 0 || opcode == forms->by_step;
  if (opcode == 0) {
    BuildMI(*next.getParent(), next, next.getDebugLoc(), tii_->get(Bfin::RINGADD), stepped)
        .addReg(value);
  } else {
    MachineInstrBuilder made =
        BuildMI(*last->getParent(), *last, last->getDebugLoc(), tii_->get(opcode));
    if (last->mayLoad())
      made.addDef(last->getOperand(0).getReg()).addDef(stepped).addReg(value);
    else
      made.addDef(stepped).addReg(last->getOperand(0).getReg()).addReg(value);
    if (is_ring_half_load(last->getOpcode()))
      made.addReg(last->getOperand(2).getReg(), RegState::Undef);
    made.cloneMemRefs(*last);
    last->eraseFromParent();
  }
  next.eraseFromParent();
}

Register BfinRings::copy(Register value, const TargetRegisterClass& rc, MachineInstr& at) {
  const Register to = regs_->createVirtualRegister(&rc);
  BuildMI(*at.getParent(), at, at.getDebugLoc(), tii_->get(TargetOpcode::COPY), to).addReg(value);
  return to;
}

/// Where the ring begins: its registers, at the end of the block in front of the loop. Divisions
/// that selection made calls of may stand behind RINGBEGIN.
void BfinRings::load(Ring& ring) {
  MachineInstr& begin = *ring.begin;
  const MachineInstr& phi = *regs_->use_instr_nodbg_begin(begin.getOperand(0).getReg());
  const bool first = phi.getOperand(1).getReg() == begin.getOperand(0).getReg();
  MachineBasicBlock& block = *phi.getOperand(first ? 2 : 4).getMBB();
  for (const unsigned operand : {1U, 2U, 3U, 4U})
    regs_->clearKillFlags(begin.getOperand(operand).getReg());
  auto made = BuildMI(block, block.getFirstTerminator(), begin.getDebugLoc(),
                      tii_->get(Bfin::RINGLOAD), begin.getOperand(0).getReg())
                  .add(begin.getOperand(1))
                  .add(begin.getOperand(2));
  const std::optional<int64_t> bytes = number(begin.getOperand(3).getReg());
  if (bytes && isUInt<16>(*bytes))
    made.addReg(0).addImm(*bytes);
  else
    made.add(begin.getOperand(3)).addImm(0);
  if (!ring.by_step)
    made.addReg(0).addImm(0);
  else if (ring.step_bytes && *ring.step_bytes != 0 && isInt<16>(*ring.step_bytes))
    made.addReg(0).addImm(*ring.step_bytes);
  else
    made.add(begin.getOperand(4)).addImm(0);
  begin.eraseFromParent();
}

bool BfinRings::runOnMachineFunction(MachineFunction& function) {
  function_ = &function;
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  dominators_ = &getAnalysis<MachineDominatorTreeWrapperPass>().getDomTree();
  std::vector<MachineInstr*> begins;
  for (MachineBasicBlock& block : function)
    for (MachineInstr& inst : block)
      if (inst.getOpcode() == Bfin::RINGBEGIN)
        begins.push_back(&inst);
  for (MachineInstr* begin : begins) {
    Ring ring = follow(*begin);
    for (const Register value : ring.values)
      use_ring(ring, value);
    for (MachineInstr* next : ring.steps)
      step(ring, *next);
    load(ring);
  }
  return !begins.empty();
}

}  // namespace

FunctionPass* createBfinRings() { return new BfinRings(); }

}  // namespace llvm
