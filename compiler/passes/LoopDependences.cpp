#include "LoopDependences.hpp"

#include <llvm/Analysis/ValueTracking.h>
#include <llvm/CodeGen/MachineFunction.h>

#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

/// The bytes of a load or store, and by how much it steps its pointer.
struct Width {
  int64_t bytes = 0;
  int64_t step = 0;
};

Width width_of(const MachineInstr& access) {
  switch (access.getOpcode()) {
    case Bfin::LDW:
    case Bfin::STW:
      return {4, 0};
    case Bfin::LDWInc:
    case Bfin::STWInc:
      return {4, 4};
    case Bfin::LDWDec:
    case Bfin::STWDec:
      return {4, -4};
    case Bfin::LDHZ:
    case Bfin::LDHX:
    case Bfin::STH:
      return {2, 0};
    case Bfin::LDHZInc:
    case Bfin::LDHXInc:
    case Bfin::STHInc:
      return {2, 2};
    case Bfin::LDHZDec:
    case Bfin::LDHXDec:
    case Bfin::STHDec:
      return {2, -2};
    case Bfin::LDBZ:
    case Bfin::LDBX:
    case Bfin::STB:
      return {1, 0};
    case Bfin::LDBZInc:
    case Bfin::LDBXInc:
    case Bfin::STBInc:
      return {1, 1};
    case Bfin::LDBZDec:
    case Bfin::LDBXDec:
    case Bfin::STBDec:
      return {1, -1};
    default:
      return {};
  }
}

Register incoming(const MachineInstr& phi, const MachineBasicBlock& from) {
  return phi.getOperand(phi.getOperand(2).getMBB() == &from ? 1 : 3).getReg();
}

}  // namespace

LoopDependences::LoopDependences(MachineBasicBlock& block, AAResults& aliases)
    : block_(block), regs_(block.getParent()->getRegInfo()), aliases_(aliases), scopes_(block) {
  for (MachineInstr& inst : block) {
    if (inst.isPHI() || inst.isTerminator() || inst.isDebugInstr())
      continue;
    // Between passes nothing but CC, the accumulators and the two sums that are fetched at once is
    // in a register of its own yet.
    for (const MachineOperand& operand : inst.operands())
      complete_ &=
          !operand.isReg() || !operand.getReg().isPhysical() ||
          is_contained({Bfin::CC, Bfin::A0, Bfin::A1, Bfin::R2, Bfin::R3}, operand.getReg().id()) ||
          regs_.isConstantPhysReg(operand.getReg());
    complete_ &= !inst.isCall() && !inst.isInlineAsm() && !inst.isPosition() &&
                 !inst.hasUnmodeledSideEffects() && !inst.hasOrderedMemoryRef();
    numbers_[&inst] = instructions_.size();
    instructions_.push_back(&inst);
  }
  for (size_t i = 0; i < instructions_.size() && complete_; ++i) {
    add_values(i);
    for (size_t j = i; j < instructions_.size(); ++j) {
      add_physical(i, j);
      add_memory(i, j);
    }
  }
}

/// A use waits for its value; the next pass's value waits for this pass's last use, since both have
/// one register.
void LoopDependences::add_values(size_t user) {
  for (const MachineOperand& use : instructions_[user]->all_uses()) {
    if (!use.getReg().isVirtual() || use.isUndef())
      continue;
    int distance = 0;
    Register value = use.getReg();
    const MachineInstr* def = regs_.getVRegDef(value);
    if (def->isPHI() && def->getParent() == &block_) {
      distance = 1;
      value = incoming(*def, block_);
      def = regs_.getVRegDef(value);
      if (def->isPHI() && def->getParent() == &block_)
        complete_ = false;
    }
    const auto found = numbers_.find(def);
    if (found == numbers_.end())
      continue;
    const auto operand = static_cast<unsigned>(def->findRegisterDefOperandIdx(value, nullptr));
    const unsigned latency = BfinSubtarget::latency(*def, operand, *instructions_[user]);
    add(found->second, user, static_cast<int>(latency), distance);
    // A sequence reads until its last part.
    const int reads = static_cast<int>(BfinSubtarget::issueCycles(*instructions_[user])) - 1;
    if (found->second != user)
      add(user, found->second, reads, 1 - distance);
  }
}

void LoopDependences::add_physical(size_t first, size_t second) {
  const TargetRegisterInfo& tri = *regs_.getTargetRegisterInfo();
  for (const MachineOperand& a : instructions_[first]->operands()) {
    if (!a.isReg() || !a.getReg().isPhysical() || regs_.isConstantPhysReg(a.getReg()))
      continue;
    for (const MachineOperand& b : instructions_[second]->operands()) {
      if (!b.isReg() || !b.getReg().isPhysical() || !tri.regsOverlap(a.getReg(), b.getReg()) ||
          (a.isUse() && b.isUse()))
        continue;
      // Within a pass, then from a pass to the next. What is read and then written may share a
      // packet.
      if (first != second)
        add(first, second, a.isDef() ? 1 : 0, 0);
      add(second, first, b.isDef() ? 1 : 0, 1);
      if (a.getReg() != Bfin::A0 && a.getReg() != Bfin::A1)
        same_stage_.emplace_back(first, second);
    }
  }
}

/// Follows a pointer back to a phi of the block through what steps it.
bool LoopDependences::follow(Register reg, Register& phi, int64_t& offset) const {
  while (reg.isVirtual()) {
    const MachineInstr& def = *regs_.getVRegDef(reg);
    if (def.isPHI() || def.getParent() != &block_) {
      phi = reg;
      return true;
    }
    const Width width = width_of(def);
    if (width.step != 0 && def.getOperand(def.mayLoad() ? 1 : 0).getReg() == reg) {
      offset += width.step;
      reg = def.getOperand(2).getReg();
    } else if (def.getOpcode() == Bfin::ADDI) {
      offset += def.getOperand(2).getImm();
      reg = def.getOperand(1).getReg();
    } else {
      return false;
    }
  }
  return false;
}

bool LoopDependences::place_of(const MachineInstr& access, Place& place) const {
  const Width width = width_of(access);
  if (width.bytes == 0)
    return false;
  const MachineOperand& base = access.getOperand(width.step != 0 ? 2 : 1);
  if (!base.isReg() || !follow(base.getReg(), place.phi, place.offset))
    return false;
  if (width.step == 0)
    place.offset += access.getOperand(2).getImm();
  const MachineInstr& phi = *regs_.getVRegDef(place.phi);
  if (!phi.isPHI() || phi.getParent() != &block_)
    return true;  // the same in every pass
  Register start;
  return follow(incoming(phi, block_), start, place.step) && start == place.phi;
}

/// Whether `first` and `second`, which is of the same pass or of the next, may touch the same
/// bytes.
bool LoopDependences::may_meet(size_t first, size_t second, bool next_pass) const {
  const MachineInstr& a = *instructions_[first];
  const MachineInstr& b = *instructions_[second];
  Place at_a;
  Place at_b;
  if (place_of(a, at_a) && place_of(b, at_b) && at_a.phi == at_b.phi) {
    const int64_t from_b = at_b.offset + (next_pass ? at_b.step : 0);
    return at_a.offset < from_b + width_of(b).bytes && from_b < at_a.offset + width_of(a).bytes;
  }
  if (!next_pass)
    return a.mayAlias(&aliases_, b, /*UseTBAA=*/true);
  // Objects are the same in every pass, places within them are not.
  if (block_.getParent()->getSubtarget().getInstrInfo()->areMemAccessesTriviallyDisjoint(a, b))
    return false;
  const auto promises = [&](const MachineInstr& access) {
    return access.hasOneMemOperand()
               ? scopes_.in_every_pass((*access.memoperands_begin())->getAAInfo())
               : AAMDNodes();
  };
  return !lie_apart(promises(a), promises(b));
}

void LoopDependences::add_memory(size_t first, size_t second) {
  const MachineInstr& a = *instructions_[first];
  const MachineInstr& b = *instructions_[second];
  if (!a.mayLoadOrStore() || !b.mayLoadOrStore() || (!a.mayStore() && !b.mayStore()))
    return;
  // A load and the store behind it may share a packet.
  const int latency = a.mayStore() ? 1 : 0;
  const int back = b.mayStore() ? 1 : 0;
  if (first != second && may_meet(first, second, false))
    add(first, second, latency, 0);
  if (may_meet(second, first, true))
    add(second, first, back, 1);
  if (first != second && may_meet(first, second, true))
    add(first, second, latency, 1);
}

MachineMemOperand* in_any_pass(MachineFunction& function, const MachineMemOperand& access,
                               const LoopScopes& scopes) {
  MachinePointerInfo object;
  const AAMDNodes promises = scopes.in_every_pass(access.getAAInfo());
  if (const Value* value = access.getValue()) {
    SmallVector<const Value*, 4> objects;
    getUnderlyingObjects(value, objects);
    const Value* one = objects.size() == 1 ? objects.front() : nullptr;
    if (isa_and_nonnull<Argument>(one) || isa_and_nonnull<GlobalValue>(one) ||
        isa_and_nonnull<AllocaInst>(one))
      object = MachinePointerInfo(one);
  }
  return function.getMachineMemOperand(object, access.getFlags(),
                                       LocationSize::beforeOrAfterPointer(), access.getBaseAlign(),
                                       promises);
}

}  // namespace llvm
