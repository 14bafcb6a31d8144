#include "BfinFrameLowering.hpp"

#include <llvm/CodeGen/MachineFrameInfo.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/CodeGen/RegisterScavenging.h>

#include "BfinInstrInfo.hpp"
#include "BfinMachineFunctionInfo.hpp"
#include "BfinSubtarget.hpp"

namespace llvm {
namespace {

constexpr int kLinkBytes = 8;  // RETS and the old FP

/// The lowest register of each bank in a multiple push; 8 and 6 mean none.
struct PushList {
  unsigned lowest_d = 8;
  unsigned lowest_p = 6;
  unsigned bytes() const { return 4 * ((8 - lowest_d) + (6 - lowest_p)); }
};

PushList push_list(ArrayRef<CalleeSavedInfo> saved) {
  PushList list;
  for (const CalleeSavedInfo& info : saved) {
    unsigned reg = info.getReg();
    if (Bfin::DRegClass.contains(reg))
      list.lowest_d = std::min(list.lowest_d, reg - Bfin::R0);
    else
      list.lowest_p = std::min(list.lowest_p, reg - Bfin::P0);
  }
  return list;
}

/// What an interrupt handler keeps beside R and P: whatever it or its callees may change, in the
/// order of the pushes.
SmallVector<MCPhysReg, 32> interrupt_registers(const MachineFunction& function) {
  SmallVector<MCPhysReg, 32> regs = {Bfin::ASTAT};
  bool calls = function.getFrameInfo().hasCalls();
  if (calls || function.getInfo<BfinMachineFunctionInfo>()->has_hardware_loops)
    regs.append({Bfin::LB0, Bfin::LB1, Bfin::LT0, Bfin::LT1, Bfin::LC0, Bfin::LC1});
  if (calls)
    regs.append({Bfin::A0X, Bfin::A0W, Bfin::A1X, Bfin::A1W, Bfin::I0, Bfin::I1, Bfin::I2,
                 Bfin::I3, Bfin::M0, Bfin::M1, Bfin::M2, Bfin::M3, Bfin::B0, Bfin::B1, Bfin::B2,
                 Bfin::B3, Bfin::L0, Bfin::L1, Bfin::L2, Bfin::L3});
  return regs;
}

unsigned saved_special_bytes(const MachineFunction& function) {
  return isInterruptHandler(function.getFunction())
             ? 4 * static_cast<unsigned>(interrupt_registers(function).size())
             : 0;
}

}  // namespace

BfinFrameLowering::BfinFrameLowering()
    : TargetFrameLowering(StackGrowsDown, Align(4), 0, Align(4), /*StackReal=*/false) {}

bool BfinFrameLowering::hasFP(const MachineFunction& function) const {
  const MachineFrameInfo& frame = function.getFrameInfo();
  if (frame.hasCalls() || frame.hasVarSizedObjects() || frame.isFrameAddressTaken())
    return true;
  // Stack arguments lie at or above the incoming SP; what the prologue itself pushes lies below.
  for (int index = frame.getObjectIndexBegin(); index != frame.getObjectIndexEnd(); ++index)
    if (!frame.isDeadObjectIndex(index) && (index >= 0 || frame.getObjectOffset(index) >= 0))
      return true;
  return false;
}

bool BfinFrameLowering::hasReservedCallFrame(const MachineFunction& function) const {
  return !function.getFrameInfo().hasVarSizedObjects();
}

void BfinFrameLowering::determineCalleeSaves(MachineFunction& function, BitVector& saved,
                                             RegScavenger* scavenger) const {
  TargetFrameLowering::determineCalleeSaves(function, saved, scavenger);
  bool handler = isInterruptHandler(function.getFunction());
  if (handler && function.getFrameInfo().hasCalls())
    for (unsigned i = 0; i < 4; ++i) {
      saved.set(Bfin::R0 + i);
      if (i < 3)
        saved.set(Bfin::P0 + i);
    }
  if (handler && function.getInfo<BfinMachineFunctionInfo>()->has_hardware_loops)
    saved.set(Bfin::R7);
  // A multiple push saves everything from its lowest register upwards.
  for (auto [first, last] : {std::pair(Bfin::R0, Bfin::R7), std::pair(Bfin::P0, Bfin::P5)}) {
    bool from_here = false;
    for (unsigned reg = first; reg <= last; ++reg) {
      from_here |= saved.test(reg);
      if (from_here)
        saved.set(reg);
    }
  }
}

bool BfinFrameLowering::assignCalleeSavedSpillSlots(MachineFunction& function,
                                                    const TargetRegisterInfo*,
                                                    std::vector<CalleeSavedInfo>& saved) const {
  MachineFrameInfo& frame = function.getFrameInfo();
  unsigned offset = 0;
  for (CalleeSavedInfo& info : saved) {
    offset += 4;
    info.setFrameIdx(frame.CreateFixedSpillStackObject(4, -static_cast<int64_t>(offset)));
  }
  unsigned special = saved_special_bytes(function);
  function.getInfo<BfinMachineFunctionInfo>()->saved_bytes = offset + special;
  // The locals begin below everything that is pushed and below LINK's two words.
  frame.CreateFixedObject(special + kLinkBytes, -static_cast<int64_t>(offset + special + kLinkBytes),
                          true);
  return true;
}

bool BfinFrameLowering::spillCalleeSavedRegisters(MachineBasicBlock& block,
                                                  MachineBasicBlock::iterator at,
                                                  ArrayRef<CalleeSavedInfo> saved,
                                                  const TargetRegisterInfo*) const {
  MachineFunction& function = *block.getParent();
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  PushList list = push_list(saved);
  if (list.bytes() == 0)
    return true;
  auto push = BuildMI(block, at, DebugLoc(), tii.get(Bfin::PUSHM))
                  .addImm(list.lowest_d)
                  .addImm(list.lowest_p)
                  .setMIFlag(MachineInstr::FrameSetup);
  for (const CalleeSavedInfo& info : saved) {
    bool live = function.getRegInfo().isLiveIn(info.getReg());
    auto reg = static_cast<MCPhysReg>(info.getReg().id());
    if (!block.isLiveIn(reg))
      block.addLiveIn(reg);
    push.addReg(info.getReg(), RegState::Implicit | getKillRegState(!live));
  }
  return true;
}

bool BfinFrameLowering::restoreCalleeSavedRegisters(MachineBasicBlock& block,
                                                    MachineBasicBlock::iterator at,
                                                    MutableArrayRef<CalleeSavedInfo> saved,
                                                    const TargetRegisterInfo*) const {
  const auto& tii = *block.getParent()->getSubtarget<BfinSubtarget>().getInstrInfo();
  PushList list = push_list(saved);
  if (list.bytes() == 0)
    return true;
  auto pop = BuildMI(block, at, DebugLoc(), tii.get(Bfin::POPM))
                 .addImm(list.lowest_d)
                 .addImm(list.lowest_p)
                 .setMIFlag(MachineInstr::FrameDestroy);
  for (const CalleeSavedInfo& info : saved)
    pop.addReg(info.getReg(), RegState::ImplicitDefine);
  return true;
}

void BfinFrameLowering::emitPrologue(MachineFunction& function, MachineBasicBlock& block) const {
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  auto at = block.begin();
  while (at != block.end() && at->getOpcode() == Bfin::PUSHM)
    ++at;
  auto push = [&](MCPhysReg reg) {
    BuildMI(block, at, DebugLoc(), tii.get(Bfin::PUSH))
        .addReg(reg, RegState::Undef)
        .setMIFlag(MachineInstr::FrameSetup);
  };
  if (isInterruptHandler(function.getFunction())) {
    auto regs = interrupt_registers(function);
    for (MCPhysReg reg : regs)
      push(reg);
    // What is interrupted may have a loop on its last instruction, or a circular buffer.
    if (regs.size() > 1 && function.getFrameInfo().hasCalls()) {
      BuildMI(block, at, DebugLoc(), tii.get(Bfin::MOVI), Bfin::R3).addImm(0);
      for (MCPhysReg reg : {Bfin::L0, Bfin::L1, Bfin::L2, Bfin::L3})
        BuildMI(block, at, DebugLoc(), tii.get(Bfin::MOV), reg).addReg(Bfin::R3);
    }
  }
  if (!hasFP(function))
    return;
  const MachineFrameInfo& frame = function.getFrameInfo();
  uint64_t locals = frame.getStackSize() - function.getInfo<BfinMachineFunctionInfo>()->saved_bytes -
                    kLinkBytes;
  uint64_t linked = std::min<uint64_t>(locals, 0x3fffc);
  BuildMI(block, at, DebugLoc(), tii.get(Bfin::LINK))
      .addImm(static_cast<int64_t>(linked))
      .setMIFlag(MachineInstr::FrameSetup);
  if (locals > linked)
    report_fatal_error(Twine("stack frame of ") + Twine(locals) + " bytes in function '" +
                       function.getName() + "' is larger than LINK can make (262140)");
}

void BfinFrameLowering::emitEpilogue(MachineFunction& function, MachineBasicBlock& block) const {
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  auto at = block.getFirstTerminator();
  while (at != block.begin() && std::prev(at)->getOpcode() == Bfin::POPM)
    --at;
  DebugLoc loc = at == block.end() ? DebugLoc() : at->getDebugLoc();
  if (hasFP(function))
    BuildMI(block, at, loc, tii.get(Bfin::UNLINK)).setMIFlag(MachineInstr::FrameDestroy);
  if (isInterruptHandler(function.getFunction()))
    for (MCPhysReg reg : reverse(interrupt_registers(function)))
      BuildMI(block, at, loc, tii.get(Bfin::POP), reg).setMIFlag(MachineInstr::FrameDestroy);
}

StackOffset BfinFrameLowering::getFrameIndexReference(const MachineFunction& function, int index,
                                                      Register& base) const {
  const MachineFrameInfo& frame = function.getFrameInfo();
  base = Bfin::FP;
  return StackOffset::getFixed(frame.getObjectOffset(index) + kLinkBytes +
                               function.getInfo<BfinMachineFunctionInfo>()->saved_bytes);
}

MachineBasicBlock::iterator BfinFrameLowering::eliminateCallFramePseudoInstr(
    MachineFunction& function, MachineBasicBlock& block, MachineBasicBlock::iterator at) const {
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  if (!hasReservedCallFrame(function)) {
    int64_t bytes = at->getOperand(0).getImm();
    if (at->getOpcode() == Bfin::ADJCALLSTACKDOWN)
      bytes = -bytes;
    // Steps of the seven-bit immediate: outgoing areas are small.
    while (bytes != 0) {
      int64_t step = std::clamp<int64_t>(bytes, -64, 60);
      BuildMI(block, at, at->getDebugLoc(), tii.get(Bfin::ADDI), Bfin::SP)
          .addReg(Bfin::SP)
          .addImm(step);
      bytes -= step;
    }
  }
  return block.erase(at);
}

void BfinFrameLowering::processFunctionBeforeFrameFinalized(MachineFunction& function,
                                                            RegScavenger* scavenger) const {
  MachineFrameInfo& frame = function.getFrameInfo();
  // Bytes are reached within 32 KB of FP; beyond, an address register may have to be freed.
  if (scavenger != nullptr && frame.estimateStackSize(function) > 30000)
    scavenger->addScavengingFrameIndex(frame.CreateStackObject(4, Align(4), false));
}

}  // namespace llvm
