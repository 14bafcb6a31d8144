#include "BfinInstrInfo.hpp"

#include <llvm/Analysis/AliasAnalysis.h>
#include <llvm/Analysis/CaptureTracking.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/CodeGen/MachineFrameInfo.h>
#include <llvm/CodeGen/MachineFunction.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineMemOperand.h>
#include <llvm/MC/MCAsmInfo.h>
#include <llvm/Support/ErrorHandling.h>
#include <llvm/Target/TargetMachine.h>
#include <optional>

#include "BfinMachineFunctionInfo.hpp"
#include "BfinSubtarget.hpp"

#define GET_INSTRINFO_CTOR_DTOR
#include "BfinGenInstrInfo.inc"

namespace llvm {

BfinInstrInfo::BfinInstrInfo()
    : BfinGenInstrInfo(Bfin::ADJCALLSTACKDOWN, Bfin::ADJCALLSTACKUP, ~0U, Bfin::RTS) {}

void BfinInstrInfo::copyPhysReg(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                                const DebugLoc& loc, MCRegister to, MCRegister from,
                                bool kill) const {
  if (!Bfin::RINGRegClass.contains(to)) {
    BuildMI(block, at, loc, get(Bfin::MOV), to).addReg(from, getKillRegState(kill));
    return;
  }
  // A ring goes on in one register only (BfinRings): the other's length is 0 again.
  const TargetRegisterInfo& tri = *block.getParent()->getSubtarget().getRegisterInfo();
  for (const unsigned part : {Bfin::sub_i, Bfin::sub_m, Bfin::sub_b, Bfin::sub_l})
    BuildMI(block, at, loc, get(Bfin::MOV), tri.getSubReg(to, part))
        .addReg(tri.getSubReg(from, part), RegState::Undef)
        .addReg(from, RegState::Implicit);
  BuildMI(block, at, loc, get(Bfin::SETLENGTH), tri.getSubReg(from, Bfin::sub_l)).addImm(0);
}

static MachineMemOperand* stack_access(MachineBasicBlock& block, int index,
                                       MachineMemOperand::Flags flags) {
  MachineFunction& function = *block.getParent();
  const MachineFrameInfo& frame = function.getFrameInfo();
  return function.getMachineMemOperand(MachinePointerInfo::getFixedStack(function, index), flags,
                                       frame.getObjectSize(index), frame.getObjectAlign(index));
}

static DebugLoc location_at(MachineBasicBlock& block, MachineBasicBlock::iterator at) {
  return at == block.end() ? DebugLoc() : at->getDebugLoc();
}

void BfinInstrInfo::storeRegToStackSlot(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                                        Register reg, bool kill, int index,
                                        const TargetRegisterClass*, const TargetRegisterInfo*,
                                        Register) const {
  BuildMI(block, at, location_at(block, at), get(Bfin::STW))
      .addReg(reg, getKillRegState(kill))
      .addFrameIndex(index)
      .addImm(0)
      .addMemOperand(stack_access(block, index, MachineMemOperand::MOStore));
}

void BfinInstrInfo::loadRegFromStackSlot(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                                         Register reg, int index, const TargetRegisterClass*,
                                         const TargetRegisterInfo*, Register) const {
  BuildMI(block, at, location_at(block, at), get(Bfin::LDW), reg)
      .addFrameIndex(index)
      .addImm(0)
      .addMemOperand(stack_access(block, index, MachineMemOperand::MOLoad));
}

static Register stack_slot_register(const MachineInstr& inst, unsigned opcode, int& index) {
  if (inst.getOpcode() != opcode || !inst.getOperand(1).isFI() || inst.getOperand(2).getImm() != 0)
    return Register();
  index = inst.getOperand(1).getIndex();
  return inst.getOperand(0).getReg();
}

Register BfinInstrInfo::isLoadFromStackSlot(const MachineInstr& inst, int& index) const {
  return stack_slot_register(inst, Bfin::LDW, index);
}

Register BfinInstrInfo::isStoreToStackSlot(const MachineInstr& inst, int& index) const {
  return stack_slot_register(inst, Bfin::STW, index);
}

void BfinInstrInfo::buildConstant(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                                  const DebugLoc& loc, Register to, int64_t value) const {
  if (isInt<16>(value))
    BuildMI(block, at, loc, get(Bfin::MOVI), to).addImm(value);
  else if (isUInt<16>(value))
    BuildMI(block, at, loc, get(Bfin::MOVU), to).addImm(value);
  else
    BuildMI(block, at, loc, get(Bfin::LI32), to).addImm(value);
}

void BfinInstrInfo::buildAddress(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                                 const DebugLoc& loc, Register to, Register base,
                                 int64_t offset) const {
  if (isInt<7>(offset)) {
    BuildMI(block, at, loc, get(Bfin::MOV), to).addReg(base);
    if (offset != 0)
      BuildMI(block, at, loc, get(Bfin::ADDI), to).addReg(to).addImm(offset);
    return;
  }
  buildConstant(block, at, loc, to, offset);
  BuildMI(block, at, loc, get(Bfin::ADDP), to).addReg(to).addReg(base);
}

/// RINGLOAD: a move to each register of the ring, the index last.
static void load_ring(MachineInstr& inst, const BfinInstrInfo& tii, const TargetRegisterInfo& tri) {
  MachineBasicBlock& block = *inst.getParent();
  const auto part = [&](unsigned index) {
    return tri.getSubReg(inst.getOperand(0).getReg(), index);
  };
  const auto set = [&](unsigned opcode, unsigned operand, MCRegister to) {
    const MachineOperand& from = inst.getOperand(operand);
    if (from.getReg().isValid())
      BuildMI(block, inst, inst.getDebugLoc(), tii.get(Bfin::MOV), to).addReg(from.getReg());
    else
      BuildMI(block, inst, inst.getDebugLoc(), tii.get(opcode), to)
          .addImm(inst.getOperand(operand + 1).getImm());
  };
  set(Bfin::SETLENGTH, 3, part(Bfin::sub_l));
  if (inst.getOperand(5).getReg().isValid() || inst.getOperand(6).getImm() != 0)
    set(Bfin::SETSTEP, 5, part(Bfin::sub_m));
  set(Bfin::MOV, 2, part(Bfin::sub_b));
  set(Bfin::MOV, 1, part(Bfin::sub_i));
  inst.eraseFromParent();
}

bool BfinInstrInfo::expandPostRAPseudo(MachineInstr& inst) const {
  if (inst.getOpcode() == Bfin::RINGLOAD) {
    load_ring(inst, *this, *inst.getMF()->getSubtarget().getRegisterInfo());
    return true;
  }
  if (inst.getOpcode() != Bfin::LI32 && inst.getOpcode() != Bfin::LDSYM)
    return expandSequence(inst);
  MachineBasicBlock& block = *inst.getParent();
  Register to = inst.getOperand(0).getReg();
  const MachineOperand& value = inst.getOperand(1);
  auto low = BuildMI(block, inst, inst.getDebugLoc(), get(Bfin::LO16), to);
  auto high = BuildMI(block, inst, inst.getDebugLoc(), get(Bfin::HI16), to).addReg(to);
  if (value.isImm()) {
    low.addImm(value.getImm() & 0xffff);
    high.addImm((value.getImm() >> 16) & 0xffff);
  } else {
    low.add(value);
    high.add(value);
  }
  inst.eraseFromParent();
  return true;
}

bool BfinInstrInfo::leavesAccumulators(const MachineInstr& inst) {
  return !inst.modifiesRegister(Bfin::A0, nullptr) && !inst.modifiesRegister(Bfin::A1, nullptr);
}

static bool is_conditional(const MachineInstr& inst) {
  return inst.getOpcode() == Bfin::JCC || inst.getOpcode() == Bfin::JNCC ||
         inst.getOpcode() == Bfin::ENDLOOP;
}

static void read_condition(const MachineInstr& branch, SmallVectorImpl<MachineOperand>& condition) {
  if (branch.getOpcode() == Bfin::ENDLOOP) {
    condition.push_back(MachineOperand::CreateImm(2));
    condition.push_back(branch.getOperand(1));
  } else {
    condition.push_back(MachineOperand::CreateImm(branch.getOpcode() == Bfin::JCC));
  }
}

bool BfinInstrInfo::analyzeBranch(MachineBasicBlock& block, MachineBasicBlock*& taken,
                                  MachineBasicBlock*& not_taken,
                                  SmallVectorImpl<MachineOperand>& condition,
                                  bool allow_modify) const {
  MachineInstr* conditional = nullptr;
  MachineInstr* jump = nullptr;
  for (auto it = block.getFirstTerminator(); it != block.end();) {
    MachineInstr& inst = *it++;
    if (inst.isDebugInstr() || inst.getOpcode() == Bfin::LOOPSETUP)
      continue;
    if (jump != nullptr) {
      // Nothing is reached behind an unconditional jump.
      if (!allow_modify)
        return true;
      inst.eraseFromParent();
    } else if (inst.getOpcode() == Bfin::JUMP) {
      jump = &inst;
    } else if (is_conditional(inst) && conditional == nullptr) {
      conditional = &inst;
    } else {
      return true;
    }
  }
  if (conditional != nullptr) {
    taken = conditional->getOperand(0).getMBB();
    read_condition(*conditional, condition);
    if (jump != nullptr)
      not_taken = jump->getOperand(0).getMBB();
  } else if (jump != nullptr) {
    taken = jump->getOperand(0).getMBB();
    if (allow_modify && block.isLayoutSuccessor(taken)) {
      jump->eraseFromParent();
      taken = nullptr;
    }
  }
  return false;
}

unsigned BfinInstrInfo::removeBranch(MachineBasicBlock& block, int* bytes) const {
  unsigned count = 0;
  int size = 0;
  while (!block.empty()) {
    MachineInstr& last = block.back();
    if (last.getOpcode() != Bfin::JUMP && !is_conditional(last))
      break;
    size += static_cast<int>(getInstSizeInBytes(last));
    last.eraseFromParent();
    ++count;
  }
  if (bytes != nullptr)
    *bytes = size;
  return count;
}

unsigned BfinInstrInfo::insertBranch(MachineBasicBlock& block, MachineBasicBlock* taken,
                                     MachineBasicBlock* not_taken,
                                     ArrayRef<MachineOperand> condition, const DebugLoc& loc,
                                     int* bytes) const {
  unsigned count = 0;
  int size = 0;
  auto added = [&](MachineInstr* inst) {
    ++count;
    size += static_cast<int>(getInstSizeInBytes(*inst));
  };
  if (condition.empty()) {
    added(BuildMI(&block, loc, get(Bfin::JUMP)).addMBB(taken));
  } else {
    if (condition[0].getImm() == 2)
      added(BuildMI(&block, loc, get(Bfin::ENDLOOP)).addMBB(taken).add(condition[1]));
    else
      added(BuildMI(&block, loc, get(condition[0].getImm() != 0 ? Bfin::JCC : Bfin::JNCC))
                .addMBB(taken)
                .addImm(0));
    if (not_taken != nullptr)
      added(BuildMI(&block, loc, get(Bfin::JUMP)).addMBB(not_taken));
  }
  if (bytes != nullptr)
    *bytes = size;
  return count;
}

bool BfinInstrInfo::reverseBranchCondition(SmallVectorImpl<MachineOperand>& condition) const {
  if (condition[0].getImm() == 2)
    return true;  // a hardware loop only ever jumps back while it counts
  condition[0].setImm(condition[0].getImm() == 0);
  return false;
}

namespace {

/// The objects that an access may go to; nothing where they are not all known.
std::optional<SmallVector<const Value*, 4>> objects_of(const MachineInstr& access) {
  if (!access.hasOneMemOperand() || (*access.memoperands_begin())->getValue() == nullptr)
    return std::nullopt;
  SmallVector<const Value*, 4> objects;
  getUnderlyingObjects((*access.memoperands_begin())->getValue(), objects);
  return objects;
}

/// Whether a pointer that memory holds cannot lead to `object`: nobody has put its address there.
bool is_out_of_reach(const Value& object, const Value& pointer) {
  return isa<LoadInst>(pointer) && isIdentifiedFunctionLocal(&object) &&
         !PointerMayBeCaptured(&object, /*ReturnCaptures=*/false, /*StoreCaptures=*/true);
}

/// As C's rules and restrict have it; the caller's pointers are no locals of the function.
bool are_apart(const Value& a, const Value& b) {
  if (&a == &b)
    return false;
  if (is_out_of_reach(a, b) || is_out_of_reach(b, a))
    return true;
  return (isIdentifiedObject(&a) && isIdentifiedObject(&b)) ||
         (isIdentifiedFunctionLocal(&a) && isa<Argument>(b)) ||
         (isIdentifiedFunctionLocal(&b) && isa<Argument>(a));
}

}  // namespace

bool BfinInstrInfo::areMemAccessesTriviallyDisjoint(const MachineInstr& a,
                                                    const MachineInstr& b) const {
  if (a.hasOrderedMemoryRef() || b.hasOrderedMemoryRef())
    return false;
  const auto of_a = objects_of(a);
  const auto of_b = objects_of(b);
  return of_a && of_b && all_of(*of_a, [&](const Value* one) {
           return all_of(*of_b, [&](const Value* other) { return are_apart(*one, *other); });
         });
}

/// Before allocation nothing moves in blocks that are in order already, nor across assembly, which
/// may change the I registers.
bool BfinInstrInfo::isSchedulingBoundary(const MachineInstr& inst, const MachineBasicBlock* block,
                                         const MachineFunction& function) const {
  return function.getInfo<BfinMachineFunctionInfo>()->ordered_blocks.count(block) != 0 ||
         inst.isInlineAsm() || TargetInstrInfo::isSchedulingBoundary(inst, block, function);
}

bool BfinInstrInfo::isBranchOffsetInRange(unsigned opcode, int64_t offset) const {
  if (opcode == Bfin::JCC || opcode == Bfin::JNCC)
    return offset >= -1024 && offset <= 1022;
  return true;
}

MachineBasicBlock* BfinInstrInfo::getBranchDestBlock(const MachineInstr& inst) const {
  return inst.getOperand(0).getMBB();
}

namespace {

struct Access {
  unsigned size;
  unsigned displacement_operand;
};

/// Size and position of the displacement of a load or store with base and displacement; size 0 for
/// everything else.
Access displaced_access(unsigned opcode) {
  switch (opcode) {
    case Bfin::LDW:
    case Bfin::STW:
      return {4, 2};
    case Bfin::LDHZ:
    case Bfin::LDHX:
    case Bfin::STH:
      return {2, 2};
    case Bfin::LDBZ:
    case Bfin::LDBX:
    case Bfin::STB:
      return {1, 2};
    default:
      return {0, 0};
  }
}

/// Bytes of a load or store: the short forms reach a few elements above the base.
unsigned access_bytes(const MachineInstr& inst, Access access) {
  const MachineOperand& base = inst.getOperand(access.displacement_operand - 1);
  const MachineOperand& displacement = inst.getOperand(access.displacement_operand);
  if (!displacement.isImm() || !base.isReg())
    return 4;
  int64_t offset = displacement.getImm();
  if (offset == 0)
    return 2;
  if (access.size == 1)
    return 4;
  if (offset > 0 && offset <= 15 * static_cast<int64_t>(access.size))
    return 2;
  bool below_frame = access.size == 4 && base.getReg() == Bfin::FP && offset >= -128 && offset < 0;
  return below_frame ? 2 : 4;
}

}  // namespace

bool BfinInstrInfo::isLegalDisplacement(unsigned opcode, int64_t offset) const {
  Access access = displaced_access(opcode);
  if (access.size == 0)
    return false;
  int64_t limit = 32767 * static_cast<int64_t>(access.size);
  return offset % static_cast<int64_t>(access.size) == 0 && offset >= -limit && offset <= limit;
}

unsigned BfinInstrInfo::getInstSizeInBytes(const MachineInstr& inst) const {
  if (inst.isBundle())
    return 8;
  if (inst.isMetaInstruction())
    return 0;
  if (inst.isInlineAsm())  // at most: a packet a statement
    return getInlineAsmLength(inst.getOperand(0).getSymbolName(),
                              *inst.getMF()->getTarget().getMCAsmInfo());
  if (Access access = displaced_access(inst.getOpcode()); access.size != 0)
    return access_bytes(inst, access);
  if (inst.getOpcode() == Bfin::MOVI || inst.getOpcode() == Bfin::MOVU)
    return inst.getOpcode() == Bfin::MOVI && isInt<7>(inst.getOperand(1).getImm()) ? 2 : 4;
  return inst.getDesc().getSize();
}

}  // namespace llvm
