#include "IndexForms.hpp"

#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>

#include "../target/BfinMachineFunctionInfo.hpp"
#include "../target/BfinSubtarget.hpp"
#include "LoopPhis.hpp"

namespace llvm {

unsigned index_form(unsigned opcode) {
  switch (opcode) {
    case Bfin::LDW:
      return Bfin::LDWI;
    case Bfin::LDWInc:
      return Bfin::LDWIInc;
    case Bfin::LDWDec:
      return Bfin::LDWIDec;
    case Bfin::LDHZ:
    case Bfin::LDHX:
      return Bfin::LDLI;
    case Bfin::LDHZInc:
    case Bfin::LDHXInc:
      return Bfin::LDLIInc;
    case Bfin::LDHZDec:
    case Bfin::LDHXDec:
      return Bfin::LDLIDec;
    case Bfin::STW:
      return Bfin::STWI;
    case Bfin::STWInc:
      return Bfin::STWIInc;
    case Bfin::STWDec:
      return Bfin::STWIDec;
    case Bfin::STH:
      return Bfin::STHI;
    case Bfin::STHInc:
      return Bfin::STHIInc;
    case Bfin::STHDec:
      return Bfin::STHIDec;
    default:
      return 0;
  }
}

bool is_half_load(unsigned index_opcode) {
  return index_opcode == Bfin::LDLI || index_opcode == Bfin::LDLIInc ||
         index_opcode == Bfin::LDLIDec;
}

bool is_ring_half_load(unsigned ring_opcode) {
  return ring_opcode == Bfin::LDLR || ring_opcode == Bfin::LDLRInc || ring_opcode == Bfin::LDLRDec;
}

bool reads_upper_half(const MachineInstr& inst, unsigned index) {
  switch (inst.getOpcode()) {
    case Bfin::MULIS:
    case Bfin::MULFU:
    case Bfin::MAC0:
    case Bfin::MAC1:
    case Bfin::MACGET0:
    case Bfin::MACGET1:
    case Bfin::MACMAC:
    case Bfin::MACGETS:
      return inst.getOperand(index + 1).getImm() != 0;
    case Bfin::PACKLO:
      return index == 1;
    case Bfin::PACKHI:
    case Bfin::LDHIStride:  // the old word
    case Bfin::ADDH_LL:
    case Bfin::SUBH_LL:
    case Bfin::MULT_LL:
    case Bfin::MULTR_LL:
    case Bfin::MULTW_LL:
    case Bfin::PACK_LL:
    case Bfin::SIGNBITSH_LL:
    case Bfin::EXPADJH_LL:
    case Bfin::ZXH:
    case Bfin::SXH:
    case Bfin::ZXB:
    case Bfin::SXB:
    case Bfin::STH:
    case Bfin::STHInc:
    case Bfin::STHDec:
    case Bfin::STHI:
    case Bfin::STHIInc:
    case Bfin::STHIDec:
    case Bfin::STHR:
    case Bfin::STHRInc:
    case Bfin::STHRDec:
    case Bfin::STB:
    case Bfin::STBInc:
    case Bfin::STBDec:
      return false;
    default:
      return true;
  }
}

namespace {

bool extends_with_zeros(const MachineInstr& inst) {
  return inst.getOpcode() == Bfin::LDHZ || inst.getOpcode() == Bfin::LDHZInc ||
         inst.getOpcode() == Bfin::LDHZDec;
}

/// Whether `inst` could have its pointer `reg` in an I register.
bool might_use_index(const MachineInstr& inst, Register reg, const MachineRegisterInfo& regs) {
  const unsigned form = index_form(inst.getOpcode());
  if (form == 0)
    return false;
  const bool steps = inst.getNumExplicitDefs() == (inst.mayLoad() ? 2U : 1U);
  const Register value = inst.getOperand(inst.mayStore() && steps ? 1 : 0).getReg();
  const MachineOperand& base = inst.getOperand(steps ? 2 : 1);
  return base.isReg() && base.getReg() == reg && value != reg &&
         (steps || inst.getOperand(2).getImm() == 0) &&
         !Bfin::PRegClass.hasSubClassEq(regs.getRegClass(value));
}

/// Whether the upper half of what `inst` loads can be left as it is, or must be zero, which is
/// added to the stream; false where it must be something else.
bool upper_half_can_be_had(MachineInstr& inst, IndexStream& stream,
                           const MachineRegisterInfo& regs) {
  if (!is_half_load(index_form(inst.getOpcode())) ||
      none_of(regs.use_nodbg_operands(inst.getOperand(0).getReg()), [](const MachineOperand& use) {
        return reads_upper_half(*use.getParent(), use.getOperandNo());
      }))
    return true;
  if (!extends_with_zeros(inst))
    return false;
  stream.zero_extended.push_back(&inst);
  return true;
}

/// Finds the accesses of the pointer that begins in the phi; false where a use of it wants a P
/// register.
bool find_accesses(IndexStream& stream, const MachineRegisterInfo& regs) {
  const MachineBasicBlock* block = stream.phi->getParent();
  Register reg = stream.phi->getOperand(0).getReg();
  while (reg.isValid()) {
    Register next;
    for (MachineInstr& use : regs.use_nodbg_instructions(reg)) {
      if (&use == stream.phi || use.getParent() != block)
        continue;
      if (!might_use_index(use, reg, regs) || !upper_half_can_be_had(use, stream, regs))
        return false;
      stream.accesses.push_back(&use);
      const unsigned stepped = use.mayLoad() ? 1 : 0;
      if (use.getNumExplicitDefs() > stepped)
        next = use.getOperand(stepped).getReg();
    }
    reg = next;
  }
  return !stream.accesses.empty();
}

/// The old value of a load into a low half: nothing, or a register with zero above that goes from
/// pass to pass.
MachineOperand old_value(MachineInstr& load, bool zero, MachineBasicBlock& before,
                         const BfinInstrInfo& tii) {
  MachineBasicBlock& block = *load.getParent();
  MachineRegisterInfo& regs = block.getParent()->getRegInfo();
  const Register kept = regs.createVirtualRegister(&Bfin::DRegClass);
  if (!zero)
    return MachineOperand::CreateReg(kept, false, false, false, false, /*isUndef=*/true);
  const Register start = regs.createVirtualRegister(&Bfin::DRegClass);
  BuildMI(before, before.getFirstTerminator(), load.getDebugLoc(), tii.get(Bfin::MOVI), start)
      .addImm(0);
  BuildMI(block, block.begin(), load.getDebugLoc(), tii.get(TargetOpcode::PHI), kept)
      .addReg(start)
      .addMBB(&before)
      .addReg(load.getOperand(0).getReg())
      .addMBB(&block);
  regs.clearKillFlags(load.getOperand(0).getReg());
  return MachineOperand::CreateReg(kept, false);
}

}  // namespace

std::vector<IndexStream> index_streams(MachineBasicBlock& block) {
  const MachineRegisterInfo& regs = block.getParent()->getRegInfo();
  std::vector<IndexStream> streams;
  if (isInterruptHandler(block.getParent()->getFunction()))
    return streams;
  const auto rings = static_cast<size_t>(count_if(block.phis(), [&](const MachineInstr& phi) {
    return regs.getRegClass(phi.getOperand(0).getReg()) == &Bfin::RINGRegClass;
  }));
  for (MachineInstr& phi : block.phis()) {
    IndexStream stream{&phi, {}, {}};
    if (rings + streams.size() + 1 < kIndexRegisterCount && find_accesses(stream, regs))
      streams.push_back(std::move(stream));
  }
  return streams;
}

void use_index_register(const IndexStream& stream, MachineBasicBlock& before,
                        const BfinInstrInfo& tii) {
  MachineFunction& function = *before.getParent();
  MachineRegisterInfo& regs = function.getRegInfo();
  MachineOperand& start = stream.phi->getOperand(incoming_operand(*stream.phi, before));
  const Register index = regs.createVirtualRegister(&Bfin::IRRegClass);
  BuildMI(before, before.getFirstTerminator(), stream.phi->getDebugLoc(),
          tii.get(TargetOpcode::COPY), index)
      .addReg(start.getReg());
  regs.clearKillFlags(start.getReg());
  start.setReg(index);
  regs.setRegClass(stream.phi->getOperand(0).getReg(), &Bfin::IRRegClass);
  for (MachineInstr* access : stream.accesses) {
    const bool loads = access->mayLoad();
    const unsigned stepped = loads ? 1 : 0;
    const bool steps = access->getNumExplicitDefs() > stepped;
    if (steps)
      regs.setRegClass(access->getOperand(stepped).getReg(), &Bfin::IRRegClass);
    regs.constrainRegClass(access->getOperand(steps && !loads ? 1 : 0).getReg(), &Bfin::DRegClass);
    access->setDesc(tii.get(index_form(access->getOpcode())));
    if (is_half_load(access->getOpcode()))
      access->addOperand(
          function, old_value(*access, is_contained(stream.zero_extended, access), before, tii));
  }
}

}  // namespace llvm
