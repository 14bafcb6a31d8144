#include "PacketSlots.hpp"

#include <llvm/CodeGen/MachineRegisterInfo.h>

namespace llvm {
namespace {

bool stores_pointer(const MachineInstr& inst) {
  if (inst.getOpcode() != Bfin::STW && inst.getOpcode() != Bfin::STWInc &&
      inst.getOpcode() != Bfin::STWDec)
    return false;
  const Register value = inst.getOperand(inst.getOpcode() == Bfin::STW ? 0 : 1).getReg();
  return value.isVirtual()
             ? !Bfin::DRegClass.hasSubClassEq(inst.getMF()->getRegInfo().getRegClass(value))
             : Bfin::PRegClass.contains(value);
}

}  // namespace

unsigned dsp_form(unsigned opcode) {
  switch (opcode) {
    case Bfin::ADD:
      return Bfin::ADDNS;
    case Bfin::SUB:
      return Bfin::SUBNS;
    default:
      return 0;
  }
}

unsigned slot_of(const MachineInstr& inst, const BfinInstrInfo& tii) {
  const unsigned slot = BfinII::getSlot(inst.getDesc());
  if (slot == BfinII::kMemSlot && tii.getInstSizeInBytes(inst) != 2)
    return BfinII::kAlone;
  return dsp_form(inst.getOpcode()) != 0 ? unsigned{BfinII::kDspSlot} : slot;
}

bool PacketSlots::add(const MachineInstr& inst, unsigned slot) {
  const bool alone = slot == BfinII::kAlone;
  const bool dsp = slot == BfinII::kDspSlot;
  const bool pointer_access = slot == BfinII::kMemSlot;
  const bool access = pointer_access || slot == BfinII::kIndexSlot;
  // Anomaly 05000074: no immediate shift beside a store of a pointer register.
  const bool shift = BfinII::shiftsByNumber(inst.getDesc());
  const bool pointer_store = stores_pointer(inst);
  if ((alone && members_ != 0) || alone_ || (dsp && dsp_) || (access && accesses_ == 2) ||
      (pointer_access && pointer_accesses_ == 1) || (inst.mayStore() && store_) ||
      (shift && pointer_store_) || (pointer_store && shift_))
    return false;
  ++members_;
  alone_ |= alone;
  dsp_ |= dsp;
  shift_ |= shift;
  store_ |= inst.mayStore();
  pointer_store_ |= pointer_store;
  accesses_ += access ? 1 : 0;
  pointer_accesses_ += pointer_access ? 1 : 0;
  return true;
}

}  // namespace llvm
