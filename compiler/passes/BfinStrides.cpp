// Pointers that go through memory in even strides, in loops of one block:
// - loads a stride apart, [P], [P + 32] and then P += 64, step by a register: [P ++ P1]. These are
// two
//   bytes long and may share packets, and the sum is spared;
// - a 16-bit load that becomes one half of a word (PACKLO, PACKHI) is loaded into that half;
// - a step of one element joins the access at the pointer: those behind it count from the next one.
// Works before allocation. Looks at pointers that only the loop's own accesses and the step read.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <map>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"
#include "LoopPhis.hpp"

namespace llvm {
namespace {

constexpr int64_t kReachOfPointer = 15;  // elements above the pointer that a short access reaches

/// An access with base and displacement, and its forms: stepping by its size, by a register.
struct StridingForms {
  unsigned plain;
  unsigned next;
  unsigned stride;  // 0: none
  int size;
};
constexpr StridingForms kStridingForms[] = {
    {Bfin::LDW, Bfin::LDWInc, Bfin::LDWStride, 4},
    {Bfin::LDHZ, Bfin::LDHZInc, Bfin::LDHZStride, 2},
    {Bfin::LDHX, Bfin::LDHXInc, Bfin::LDHXStride, 2},
    {Bfin::LDBZ, Bfin::LDBZInc, 0, 1},
    {Bfin::LDBX, Bfin::LDBXInc, 0, 1},
    {Bfin::STW, Bfin::STWInc, 0, 4},
    {Bfin::STH, Bfin::STHInc, 0, 2},
    {Bfin::STB, Bfin::STBInc, 0, 1},
};

const StridingForms* forms_of(const MachineInstr& inst) {
  const StridingForms* found = find_if(
      kStridingForms, [&](const StridingForms& forms) { return forms.plain == inst.getOpcode(); });
  return found == std::end(kStridingForms) ? nullptr : found;
}

/// A pointer's way through a round: its accesses in their order, and its step.
struct Walk {
  MachineInstr* phi = nullptr;
  MachineInstr* step = nullptr;
  std::vector<MachineInstr*> accesses;
  std::optional<int64_t> bytes;  // of the step, where it is known
  Register by;                   // the register that it is in, where it is in one
  bool lives_on = false;         // is the pointer wanted behind the loop?
};

class BfinStrides : public MachineFunctionPass {
 public:
  static char ID;
  BfinStrides() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin strides"; }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  std::optional<Walk> walk_of(MachineInstr& phi) const;
  MachineInstr* half_of(const MachineInstr& load) const;
  std::optional<int64_t> stride_of(const Walk& walk) const;
  bool in_order(const Walk& walk) const;
  bool use_strides(const Walk& walk);
  bool join_step(const Walk& walk);
  void move_start(const Walk& walk, int64_t bytes);
  Register stride_register(const Walk& walk, int64_t bytes);
  Register in_pointer(const Walk& walk);
  void load_by_stride(MachineInstr& load, Register& pointer, Register next, Register stride);

  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
  bool stores_ = false;                       // does the loop store?
  std::map<int64_t, Register> strides_;       // of the loop at hand
  std::map<const MachineInstr*, int> order_;  // of its instructions
};

char BfinStrides::ID = 0;

unsigned own_operand(const MachineInstr& phi) { return incoming_operand(phi, *phi.getParent()); }

MachineBasicBlock& entry_of(const MachineInstr& phi) {
  return *phi.getOperand(5 - own_operand(phi)).getMBB();
}

std::optional<Walk> BfinStrides::walk_of(MachineInstr& phi) const {
  if (phi.getNumOperands() != 5)
    return std::nullopt;
  const Register pointer = phi.getOperand(0).getReg();
  const Register next = phi.getOperand(own_operand(phi)).getReg();
  Walk walk;
  walk.phi = &phi;
  walk.step = next.isVirtual() ? regs_->getVRegDef(next) : nullptr;
  if (walk.step == nullptr || walk.step->getParent() != phi.getParent() ||
      !regs_->constrainRegClass(pointer, &Bfin::PRegClass))
    return std::nullopt;
  for (const MachineInstr& use : regs_->use_nodbg_instructions(next)) {
    if (&use != &phi && use.getParent() == phi.getParent())
      return std::nullopt;
    walk.lives_on |= &use != &phi;
  }
  if (walk.step->getOpcode() == Bfin::ADDI && walk.step->getOperand(1).getReg() == pointer) {
    walk.bytes = walk.step->getOperand(2).getImm();
  } else if (walk.step->getOpcode() == Bfin::ADD_X) {
    const bool first = walk.step->getOperand(1).getReg() == pointer;
    walk.by = walk.step->getOperand(first ? 2 : 1).getReg();
    const MachineInstr* def = walk.by.isVirtual() ? regs_->getVRegDef(walk.by) : nullptr;
    while (def != nullptr && def->isCopy() && def->getOperand(1).getReg().isVirtual())
      def = regs_->getVRegDef(def->getOperand(1).getReg());
    if (walk.step->getOperand(first ? 1 : 2).getReg() != pointer || def == nullptr)
      return std::nullopt;
    if (def->getOpcode() == Bfin::MOVI)
      walk.bytes = def->getOperand(1).getImm();
    else if (def->getParent() == phi.getParent())
      return std::nullopt;
  } else {
    return std::nullopt;
  }
  for (MachineInstr& inst : *phi.getParent()) {
    const auto reads = count_if(inst.all_uses(),
                                [&](const MachineOperand& use) { return use.getReg() == pointer; });
    if (reads == 0 || &inst == walk.step)
      continue;
    if (reads != 1 || forms_of(inst) == nullptr || inst.getOperand(0).getReg() == pointer ||
        inst.hasOrderedMemoryRef())
      return std::nullopt;
    walk.accesses.push_back(&inst);
  }
  const bool only_here =
      all_of(regs_->use_nodbg_instructions(pointer),
             [&](const MachineInstr& use) { return use.getParent() == phi.getParent(); });
  if (walk.accesses.empty() || !only_here)
    return std::nullopt;
  return walk;
}

/// Which instruction makes a loaded half one of a word's, if that is all that becomes of it.
MachineInstr* BfinStrides::half_of(const MachineInstr& load) const {
  const Register half = load.getOperand(0).getReg();
  const auto* forms = forms_of(load);
  if (stores_ || forms == nullptr || forms->size != 2 || !regs_->hasOneNonDBGUse(half))
    return nullptr;
  MachineInstr& user = *regs_->use_instr_nodbg_begin(half);
  const bool packs = user.getOpcode() == Bfin::PACKLO || user.getOpcode() == Bfin::PACKHI;
  return packs && user.getParent() == load.getParent() && user.getOperand(2).getReg() == half
             ? &user
             : nullptr;
}

/// Where the loads of a round, and the first of the next round, are all the same number of bytes
/// apart: that number.
std::optional<int64_t> BfinStrides::stride_of(const Walk& walk) const {
  const auto count = static_cast<int64_t>(walk.accesses.size());
  if (!walk.bytes || *walk.bytes % count != 0)
    return std::nullopt;
  const int64_t stride = *walk.bytes / count;
  int64_t at = walk.accesses.front()->getOperand(2).getImm();
  for (const MachineInstr* access : walk.accesses) {
    if (access->getOperand(2).getImm() != at)
      return std::nullopt;
    at += stride;
  }
  return stride;
}

/// Do the loads still come one after the other where their words are made?
bool BfinStrides::in_order(const Walk& walk) const {
  int last = -1;
  for (const MachineInstr* load : walk.accesses) {
    const MachineInstr* user = half_of(*load);
    const int place = order_.at(user == nullptr ? load : user);
    if (place < last)
      return false;
    last = place;
  }
  return true;
}

/// The pointer comes into the loop `bytes` further on.
void BfinStrides::move_start(const Walk& walk, int64_t bytes) {
  if (bytes == 0)
    return;
  MachineBasicBlock& before = entry_of(*walk.phi);
  MachineOperand& from = walk.phi->getOperand(4 - own_operand(*walk.phi));
  const Register start = regs_->createVirtualRegister(&Bfin::DPRegClass);
  const auto at = before.getFirstTerminator();
  const DebugLoc& loc = walk.step->getDebugLoc();
  if (isInt<7>(bytes)) {
    BuildMI(before, at, loc, tii_->get(Bfin::ADDI), start).addReg(from.getReg()).addImm(bytes);
  } else {
    const Register number = regs_->createVirtualRegister(&Bfin::DPRegClass);
    tii_->buildConstant(before, at, loc, number, bytes);
    BuildMI(before, at, loc, tii_->get(Bfin::ADD_X), start).addReg(from.getReg()).addReg(number);
  }
  regs_->clearKillFlags(from.getReg());
  from.setReg(start);
}

Register BfinStrides::stride_register(const Walk& walk, int64_t bytes) {
  auto [entry, added] = strides_.try_emplace(bytes);
  if (added) {
    MachineBasicBlock& before = entry_of(*walk.phi);
    entry->second = regs_->createVirtualRegister(&Bfin::PRegClass);
    tii_->buildConstant(before, before.getFirstTerminator(), walk.step->getDebugLoc(),
                        entry->second, bytes);
  }
  return entry->second;
}

/// A step that is only known when the loop begins, in a pointer register.
Register BfinStrides::in_pointer(const Walk& walk) {
  MachineBasicBlock& before = entry_of(*walk.phi);
  const Register step = regs_->createVirtualRegister(&Bfin::PRegClass);
  BuildMI(before, before.getFirstTerminator(), walk.step->getDebugLoc(),
          tii_->get(TargetOpcode::COPY), step)
      .addReg(walk.by);
  regs_->clearKillFlags(walk.by);
  return step;
}

/// One load, which leaves `next` as the pointer.
void BfinStrides::load_by_stride(MachineInstr& load, Register& pointer, Register next,
                                 Register stride) {
  MachineInstr* user = half_of(load);
  MachineInstr& at = user == nullptr ? load : *user;
  unsigned opcode = forms_of(load)->stride;
  if (user != nullptr)
    opcode = user->getOpcode() == Bfin::PACKLO ? Bfin::LDLOStride : Bfin::LDHIStride;
  auto inst = BuildMI(*load.getParent(), at, load.getDebugLoc(), tii_->get(opcode),
                      at.getOperand(0).getReg())
                  .addDef(next)
                  .addReg(pointer)
                  .addReg(stride)
                  .cloneMemRefs(load);
  if (user != nullptr) {
    inst.addReg(user->getOperand(1).getReg());
    regs_->clearKillFlags(user->getOperand(1).getReg());
    user->eraseFromParent();
  }
  load.eraseFromParent();
  pointer = next;
}

bool BfinStrides::use_strides(const Walk& walk) {
  const bool loads = all_of(walk.accesses, [&](const MachineInstr* access) {
    return access->mayLoad() && forms_of(*access)->stride != 0 &&
           regs_->constrainRegClass(access->getOperand(0).getReg(), &Bfin::DRegClass) != nullptr;
  });
  const std::optional<int64_t> stride = stride_of(walk);
  const bool unknown = !walk.bytes && walk.accesses.size() == 1;
  const int64_t first = walk.accesses.front()->getOperand(2).getImm();
  if (!loads || (walk.lives_on && first != 0) || (!stride && !unknown) ||
      (stride && !isInt<16>(*stride)) || !in_order(walk))
    return false;
  // Without a half to be made, steps of the size need no register.
  const bool halves =
      all_of(walk.accesses, [&](const MachineInstr* load) { return half_of(*load) != nullptr; });
  if (stride && !halves && std::abs(*stride) == forms_of(*walk.accesses.front())->size)
    return false;
  move_start(walk, first);
  const Register by = stride ? stride_register(walk, *stride) : in_pointer(walk);
  Register pointer = walk.phi->getOperand(0).getReg();
  const Register last = walk.step->getOperand(0).getReg();
  regs_->clearKillFlags(by);
  regs_->clearKillFlags(pointer);
  regs_->constrainRegClass(last, &Bfin::PRegClass);
  walk.step->eraseFromParent();
  for (MachineInstr* load : walk.accesses)
    load_by_stride(
        *load, pointer,
        load == walk.accesses.back() ? last : regs_->createVirtualRegister(&Bfin::PRegClass), by);
  return true;
}

/// The step of one element with the access at the pointer itself. The others come before it, or
/// count from the next element.
bool BfinStrides::join_step(const Walk& walk) {
  const auto joins = [&](const MachineInstr* access) {
    return access->getOperand(2).getImm() == 0 && forms_of(*access)->size == walk.bytes;
  };
  const auto found = find_if(walk.accesses, joins);
  // Those further off are better served by a pointer of their own (BfinSteps).
  const bool near = all_of(walk.accesses, [](const MachineInstr* access) {
    const int64_t distance = access->getOperand(2).getImm();
    return distance >= 0 && distance <= kReachOfPointer * forms_of(*access)->size;
  });
  if (walk.accesses.size() < 2 || found == walk.accesses.end() || !near)
    return false;
  const auto behind = make_range(std::next(found), walk.accesses.end());
  if (stores_ && !all_of(behind, [&](const MachineInstr* access) {
        return tii_->isLegalDisplacement(access->getOpcode(),
                                         access->getOperand(2).getImm() - *walk.bytes);
      }))
    return false;
  MachineInstr& access = **found;
  MachineBasicBlock& block = *access.getParent();
  const Register next = walk.step->getOperand(0).getReg();
  regs_->constrainRegClass(next, &Bfin::PRegClass);
  walk.step->eraseFromParent();
  for (MachineInstr* other : behind) {
    if (!stores_) {
      block.splice(access, &block, other);
      continue;
    }
    other->getOperand(1).setReg(next);
    other->getOperand(2).setImm(other->getOperand(2).getImm() - *walk.bytes);
  }
  const auto stepping =
      BuildMI(block, access, access.getDebugLoc(), tii_->get(forms_of(access)->next));
  if (access.mayStore())
    stepping.addDef(next).addReg(access.getOperand(0).getReg());
  else
    stepping.addDef(access.getOperand(0).getReg()).addDef(next);
  stepping.addReg(walk.phi->getOperand(0).getReg()).cloneMemRefs(access);
  regs_->clearKillFlags(walk.phi->getOperand(0).getReg());
  access.eraseFromParent();
  return true;
}

bool BfinStrides::runOnMachineFunction(MachineFunction& function) {
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  bool changed = false;
  for (MachineBasicBlock& block : function) {
    const auto end = block.getFirstTerminator();
    if (end == block.end() || end->getOpcode() != Bfin::ENDLOOP ||
        end->getOperand(0).getMBB() != &block)
      continue;
    strides_.clear();
    order_.clear();
    stores_ = false;
    for (MachineInstr& inst : block) {
      stores_ |= inst.mayStore() && !inst.isTerminator();
      order_[&inst] = static_cast<int>(order_.size());
    }
    SmallVector<MachineInstr*, 8> phis;
    for (MachineInstr& phi : block.phis())
      phis.push_back(&phi);
    for (MachineInstr* phi : phis)
      if (const std::optional<Walk> walk = walk_of(*phi))
        changed |= use_strides(*walk) || join_step(*walk);
  }
  return changed;
}

}  // namespace

FunctionPass* createBfinStrides() { return new BfinStrides(); }

}  // namespace llvm
