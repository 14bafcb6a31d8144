// Accesses at fixed distances from a stepped pointer become accesses that step it themselves:
//
//   [p] = a; [p + 4] = b; p += 8      ->  [p++] = a; [p++] = b
//   x = [p]; y = [p + 512]; p += 4    ->  x = [p++]; y = [q++]      (q = p + 512 before the loop)
//
// The addition is saved, far accesses get their short form, and I registers can serve them
// (BfinIndexStreams). So do neighbours at a pointer that the loop loads or computes anew:
//
//   B[p] B[p + 1] B[p + 256] B[p + 257]  ->  q = p + 256; B[p++] B[p] B[q++] B[q]
//
// Looks at loops of one block, and, for one pointer at a time, at the other
// blocks, before allocation, and changes a pointer only where all of its accesses fit. Accesses
// change places where the steps want another order, if their addresses are known to be apart from
// what stands between.
#include <llvm/Analysis/AliasAnalysis.h>
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"
#include "LoopPhis.hpp"

namespace llvm {
namespace {

constexpr unsigned kMostPointers = 5;  // of a loop, each in a P register
constexpr int64_t kShortReach = 15;    // elements above the base that a short access reaches

/// An access with a displacement, and what does the same and steps its pointer upwards.
struct Form {
  unsigned displaced;
  unsigned stepping;
  int64_t size;
};
constexpr Form kForms[] = {
    {Bfin::LDW, Bfin::LDWInc, 4},   {Bfin::STW, Bfin::STWInc, 4}, {Bfin::LDHZ, Bfin::LDHZInc, 2},
    {Bfin::LDHX, Bfin::LDHXInc, 2}, {Bfin::STH, Bfin::STHInc, 2}, {Bfin::LDBZ, Bfin::LDBZInc, 1},
    {Bfin::LDBX, Bfin::LDBXInc, 1}, {Bfin::STB, Bfin::STBInc, 1},
};

const Form* form_of(const MachineInstr& inst) {
  const auto* form =
      find_if(kForms, [&](const Form& one) { return one.displaced == inst.getOpcode(); });
  return form == std::end(kForms) ? nullptr : form;
}

int64_t displacement(const MachineInstr& access) { return access.getOperand(2).getImm(); }

/// Accesses that together cover what the pointer steps over, from the lowest address up.
using Run = std::vector<MachineInstr*>;

/// A pointer of a loop: phi(start, next), next = phi + step.
struct Pointer {
  MachineInstr* phi = nullptr;
  MachineInstr* step = nullptr;
  std::vector<Run> runs;
};

class BfinSteps : public MachineFunctionPass {
 public:
  static char ID;
  BfinSteps() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin steps"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<AAResultsWrapperPass>();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  bool run_on_loop(MachineBasicBlock& block, MachineBasicBlock& before);
  bool step_in_straight_code(MachineBasicBlock& block);
  bool step_new_pointers(MachineBasicBlock& block, MachineBasicBlock& before);
  bool find_runs(Register pointer, const MachineBasicBlock& block, std::vector<Run>& runs) const;
  Register pointer_at(Register pointer, int64_t distance, MachineInstr& at,
                      MachineBasicBlock& before);
  bool find(MachineInstr& phi, Pointer& pointer) const;
  bool find_accesses(Pointer& pointer) const;
  static bool split(std::vector<MachineInstr*> accesses, int64_t step, std::vector<Run>& runs);
  bool put_in_order(const Run& run) const;
  bool may_pass(const MachineInstr& moved, const MachineInstr& other) const;
  MachineInstr& another_pointer(const Pointer& pointer, MachineBasicBlock& before,
                                int64_t distance);
  bool pays(const Pointer& pointer, size_t registers) const;
  void rewrite(const Pointer& pointer, MachineBasicBlock& before);
  void step(const Run& run, Register from, Register next);
  void step(const Run& run, Register from);

  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
  AAResults* aliases_ = nullptr;
};

char BfinSteps::ID = 0;

bool BfinSteps::find(MachineInstr& phi, Pointer& pointer) const {
  const MachineBasicBlock& block = *phi.getParent();
  pointer.phi = &phi;
  pointer.step = regs_->getVRegDef(phi.getOperand(incoming_operand(phi, block)).getReg());
  return pointer.step->getParent() == &block && pointer.step->getOpcode() == Bfin::ADDI &&
         pointer.step->getOperand(1).getReg() == phi.getOperand(0).getReg() &&
         pointer.step->getOperand(2).getImm() > 0 && find_accesses(pointer);
}

/// The runs of the pointer that is stepped, in the block of its step.
bool BfinSteps::find_accesses(Pointer& pointer) const {
  const MachineBasicBlock& block = *pointer.step->getParent();
  const Register value = pointer.step->getOperand(1).getReg();
  std::vector<MachineInstr*> accesses;
  for (MachineInstr& use : regs_->use_nodbg_instructions(value)) {
    if (&use == pointer.step)
      continue;
    const bool is_access = form_of(use) != nullptr && use.getParent() == &block &&
                           use.getOperand(1).isReg() && use.getOperand(1).getReg() == value &&
                           use.getOperand(0).getReg() != value && !use.hasOrderedMemoryRef();
    if (!is_access)
      return false;
    accesses.push_back(&use);
  }
  // Behind the loop the stepped pointer may be of use; within it only for the next pass.
  for (const MachineInstr& use :
       regs_->use_nodbg_instructions(pointer.step->getOperand(0).getReg()))
    if (use.getParent() == &block && &use != pointer.phi)
      return false;
  for (const Register reg : {value, pointer.step->getOperand(0).getReg()})
    if (regs_->getRegClass(reg) == &Bfin::DRegClass)
      return false;
  return split(std::move(accesses), pointer.step->getOperand(2).getImm(), pointer.runs);
}

/// False: some access is not part of a run that covers the step.
bool BfinSteps::split(std::vector<MachineInstr*> accesses, int64_t step, std::vector<Run>& runs) {
  llvm::sort(accesses, [](const MachineInstr* a, const MachineInstr* b) {
    return displacement(*a) < displacement(*b);
  });
  int64_t covered = step;  // of the run so far
  for (MachineInstr* access : accesses) {
    const int64_t size = form_of(*access)->size;
    if (covered == step) {
      runs.emplace_back();
      covered = 0;
    }
    Run& run = runs.back();
    const bool fits = run.empty() || displacement(*access) ==
                                         displacement(*run.back()) + form_of(*run.back())->size;
    if (!fits || covered + size > step)
      return false;
    run.push_back(access);
    covered += size;
  }
  return covered == step && !runs.empty();
}

bool BfinSteps::may_pass(const MachineInstr& moved, const MachineInstr& other) const {
  if (other.isCall() || other.isPosition() || other.hasUnmodeledSideEffects())
    return false;
  return !other.mayLoadOrStore() || (!moved.mayStore() && !other.mayStore()) ||
         !moved.mayAlias(aliases_, other, /*UseTBAA=*/false);
}

/// Brings the accesses into the order of their addresses: loads up to the first of them, stores
/// down to the last.
bool BfinSteps::put_in_order(const Run& run) const {
  MachineBasicBlock& block = *run.front()->getParent();
  const auto in_run = [&](const MachineInstr& inst) { return is_contained(run, &inst); };
  const auto first = find_if(block, in_run);
  auto end = first;  // behind the last of them
  std::vector<const MachineInstr*> order;
  for (auto it = first; it != block.end(); ++it)
    if (in_run(*it)) {
      order.push_back(&*it);
      end = std::next(it);
    }
  if (llvm::equal(order, run))
    return true;
  const bool stores = run.front()->mayStore();
  for (MachineInstr* access : run) {
    const auto passed = stores ? make_range(access->getIterator(), end->getIterator())
                               : make_range(first->getIterator(), access->getIterator());
    if (access->mayStore() != stores || any_of(passed, [&](const MachineInstr& other) {
          return !in_run(other) && !may_pass(*access, other);
        }))
      return false;
  }
  const auto at = stores ? end : std::find_if_not(first, block.end(), in_run);
  for (MachineInstr* access : run)
    block.splice(at, &block, access);
  return true;
}

/// A pointer that runs along at a distance: its phi.
MachineInstr& BfinSteps::another_pointer(const Pointer& pointer, MachineBasicBlock& before,
                                         int64_t distance) {
  MachineBasicBlock& block = *pointer.phi->getParent();
  Register start = pointer.phi->getOperand(incoming_operand(*pointer.phi, before)).getReg();
  const MachineInstr* from = start.isVirtual() ? regs_->getVRegDef(start) : nullptr;
  if (from != nullptr && from->getOpcode() == Bfin::ADDI) {
    start = from->getOperand(1).getReg();
    distance += from->getOperand(2).getImm();
  }
  const DebugLoc& loc = pointer.step->getDebugLoc();
  const auto of_class = [&](const TargetRegisterClass& rc) {
    return regs_->createVirtualRegister(&rc);
  };
  const auto at = before.getFirstTerminator();
  const Register first = distance == 0 ? start : of_class(Bfin::DPRegClass);
  if (distance == 0) {
    // The pointer came to the loop at a distance.
  } else if (isInt<7>(distance)) {
    BuildMI(before, at, loc, tii_->get(Bfin::ADDI), first).addReg(start).addImm(distance);
  } else {
    const Register amount = of_class(Bfin::DPRegClass);
    tii_->buildConstant(before, at, loc, amount, distance);
    BuildMI(before, at, loc, tii_->get(Bfin::ADD_X), first).addReg(start).addReg(amount);
  }
  regs_->clearKillFlags(start);
  return *BuildMI(block, block.begin(), loc, tii_->get(TargetOpcode::PHI),
                  of_class(Bfin::PRegClass))
              .addReg(first)
              .addMBB(&before)
              .addReg(of_class(Bfin::PRegClass))
              .addMBB(&block);
}

void BfinSteps::step(const Run& run, Register from, Register next) {
  for (const Register reg : {from, next})
    regs_->constrainRegClass(reg, &Bfin::PRegClass);
  for (MachineInstr* access : run) {
    const Form& form = *form_of(*access);
    const Register to =
        access == run.back() ? next : regs_->createVirtualRegister(&Bfin::PRegClass);
    MachineOperand& value = access->getOperand(0);
    auto stepping =
        BuildMI(*access->getParent(), access, access->getDebugLoc(), tii_->get(form.stepping));
    if (access->mayLoad())
      stepping.addDef(value.getReg());
    stepping.addDef(to);
    if (access->mayStore())
      stepping.addReg(value.getReg());
    stepping.addReg(from).cloneMemRefs(*access);
    if (access->mayStore())
      regs_->clearKillFlags(value.getReg());
    from = to;
    access->eraseFromParent();
  }
}

/// The run that steps the pointer itself; null when another pointer takes its place.
const Run* own_run(const Pointer& pointer) {
  const auto own =
      find_if(pointer.runs, [](const Run& run) { return displacement(*run.front()) == 0; });
  return own == pointer.runs.end() ? nullptr : &*own;
}

/// Whether the pointer is worth its registers: every run but the first needs one more, and is left
/// alone where short accesses reach it.
bool BfinSteps::pays(const Pointer& pointer, size_t registers) const {
  if (own_run(pointer) == nullptr && !regs_->hasOneNonDBGUse(pointer.step->getOperand(0).getReg()))
    return false;
  const bool near = all_of(pointer.runs, [](const Run& run) {
    return displacement(*run.front()) >= 0 &&
           displacement(*run.back()) <= kShortReach * form_of(*run.back())->size;
  });
  return pointer.runs.size() == 1 || (!near && registers <= kMostPointers);
}

void BfinSteps::rewrite(const Pointer& pointer, MachineBasicBlock& before) {
  const MachineBasicBlock& block = *pointer.phi->getParent();
  const Run* own = own_run(pointer);
  for (const Run& run : pointer.runs) {
    if (&run == own)
      continue;
    const MachineInstr& phi = another_pointer(pointer, before, displacement(*run.front()));
    step(run, phi.getOperand(0).getReg(), phi.getOperand(incoming_operand(phi, block)).getReg());
  }
  const Register next = pointer.step->getOperand(0).getReg();
  pointer.step->eraseFromParent();
  if (own == nullptr)
    pointer.phi->eraseFromParent();
  else
    step(*own, pointer.phi->getOperand(0).getReg(), next);
}

/// As above, but for the last access, behind which nothing wants the pointer.
void BfinSteps::step(const Run& run, Register from) {
  Run stepping = run;
  MachineInstr* last = stepping.back();
  stepping.pop_back();
  const Register next = regs_->createVirtualRegister(&Bfin::PRegClass);
  step(stepping, from, next);
  last->getOperand(1).setReg(next);
  last->getOperand(1).setIsKill(false);
  last->getOperand(2).setImm(0);
}

bool BfinSteps::run_on_loop(MachineBasicBlock& block, MachineBasicBlock& before) {
  std::vector<Pointer> pointers;
  size_t registers = 0;
  for (MachineInstr& phi : block.phis()) {
    Pointer pointer;
    if (find(phi, pointer))
      pointers.push_back(std::move(pointer));
    registers += any_of(regs_->use_nodbg_instructions(phi.getOperand(0).getReg()),
                        [](const MachineInstr& use) { return use.mayLoadOrStore(); });
  }
  bool changed = false;
  for (const Pointer& pointer : pointers) {
    const size_t more = pointer.runs.size() - 1;
    if (!pays(pointer, registers + more) ||
        !all_of(pointer.runs, [&](const Run& run) { return put_in_order(run); }))
      continue;
    registers += more;
    rewrite(pointer, before);
    changed = true;
  }
  return changed;
}

/// Accesses of neighbours through a pointer that is new in each pass, where a step would make long
/// ones short: B[p + 1] does not fit packets, B[p++] and B[p] do. False: something else wants it.
bool BfinSteps::find_runs(Register pointer, const MachineBasicBlock& block,
                          std::vector<Run>& runs) const {
  if (regs_->getRegClass(pointer) == &Bfin::DRegClass)
    return false;
  Run accesses;
  for (MachineInstr& use : regs_->use_nodbg_instructions(pointer)) {
    if (form_of(use) == nullptr || use.getParent() != &block || !use.mayLoad() ||
        !use.getOperand(1).isReg() || use.getOperand(1).getReg() != pointer ||
        use.hasOrderedMemoryRef())
      return false;
    accesses.push_back(&use);
  }
  llvm::sort(accesses, [](const MachineInstr* a, const MachineInstr* b) {
    return displacement(*a) < displacement(*b);
  });
  for (MachineInstr* access : accesses) {
    const bool continues =
        !runs.empty() && displacement(*access) ==
                             displacement(*runs.back().back()) + form_of(*runs.back().back())->size;
    if (!continues)
      runs.emplace_back();
    runs.back().push_back(access);
  }
  return all_of(runs, [&](const Run& run) {
    return run.size() > 1 && any_of(run, [&](const MachineInstr* access) {
             return tii_->getInstSizeInBytes(*access) > 2;
           });
  });
}

/// The pointer, further on by a constant.
Register BfinSteps::pointer_at(Register pointer, int64_t distance, MachineInstr& at,
                               MachineBasicBlock& before) {
  if (distance == 0)
    return pointer;
  const DebugLoc& loc = at.getDebugLoc();
  const Register amount = regs_->createVirtualRegister(&Bfin::DPRegClass);
  const Register further = regs_->createVirtualRegister(&Bfin::DPRegClass);
  tii_->buildConstant(before, before.getFirstTerminator(), loc, amount, distance);
  BuildMI(*at.getParent(), at, loc, tii_->get(Bfin::ADD_X), further).addReg(pointer).addReg(amount);
  regs_->clearKillFlags(pointer);
  return further;
}

/// Pointers that a loop computes or loads in each pass.
bool BfinSteps::step_new_pointers(MachineBasicBlock& block, MachineBasicBlock& before) {
  std::vector<std::pair<Register, std::vector<Run>>> found;
  size_t others = 0;  // what long accesses could have shared packets with
  for (MachineInstr& inst : block) {
    others += !inst.isPHI() && !inst.mayLoadOrStore() ? 1 : 0;
    if (inst.isPHI() || inst.getNumExplicitDefs() == 0 || !inst.getOperand(0).getReg().isVirtual())
      continue;
    std::vector<Run> runs;
    if (find_runs(inst.getOperand(0).getReg(), block, runs) && !runs.empty())
      found.emplace_back(inst.getOperand(0).getReg(), std::move(runs));
  }
  bool changed = false;
  for (auto& [pointer, runs] : found) {
    size_t accesses = 0;
    for (const Run& run : runs)
      accesses += run.size();
    if (others < accesses || !all_of(runs, [&](const Run& run) { return put_in_order(run); }))
      continue;
    MachineInstr* def = regs_->getVRegDef(pointer);
    MachineInstr& behind = *std::next(def->getIterator());
    std::vector<Register> starts;
    for (const Run& run : runs)
      starts.push_back(pointer_at(pointer, displacement(*run.front()), behind, before));
    for (const auto& [run, start] : zip(runs, starts))
      step(run, start);
    changed = true;
  }
  return changed;
}

/// Where a pointer of an outer loop is stepped, behind all of its accesses.
bool BfinSteps::step_in_straight_code(MachineBasicBlock& block) {
  std::vector<MachineInstr*> steps;
  for (MachineInstr& inst : block)
    if (inst.getOpcode() == Bfin::ADDI && inst.getOperand(2).getImm() > 0 &&
        inst.getOperand(1).getReg().isVirtual())
      steps.push_back(&inst);
  bool changed = false;
  for (MachineInstr* inst : steps) {
    Pointer pointer;
    pointer.step = inst;
    if (!find_accesses(pointer) || pointer.runs.size() != 1 || own_run(pointer) == nullptr ||
        !put_in_order(pointer.runs.front()))
      continue;
    const Register from = inst->getOperand(1).getReg();
    const Register next = inst->getOperand(0).getReg();
    inst->eraseFromParent();
    step(pointer.runs.front(), from, next);
    changed = true;
  }
  return changed;
}

bool BfinSteps::runOnMachineFunction(MachineFunction& function) {
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  aliases_ = &getAnalysis<AAResultsWrapperPass>().getAAResults();
  bool changed = false;
  for (MachineBasicBlock& block : function) {
    if (!block.isSuccessor(&block) || block.pred_size() != 2) {
      changed |= step_in_straight_code(block);
      continue;
    }
    MachineBasicBlock& before = **find_if(
        block.predecessors(), [&](const MachineBasicBlock* other) { return other != &block; });
    changed |= run_on_loop(block, before);
    changed |= step_new_pointers(block, before);
  }
  return changed;
}

}  // namespace

FunctionPass* createBfinSteps() { return new BfinSteps(); }

}  // namespace llvm
