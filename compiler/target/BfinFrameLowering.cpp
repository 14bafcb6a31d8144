#include "BfinFrameLowering.hpp"

#include <llvm/CodeGen/MachineFrameInfo.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/CodeGen/RegisterScavenging.h>
#include <llvm/IR/DebugInfoMetadata.h>

#include "BfinInstrInfo.hpp"
#include "BfinMachineFunctionInfo.hpp"
#include "BfinSubtarget.hpp"

namespace llvm {
namespace {

constexpr int kLinkBytes = 8;               // RETS and the old FP
constexpr int64_t kMostLinked = 0x3fffc;    // LINK's immediate: a multiple of 4 in 16 bits
constexpr uint64_t kMostWithoutLink = 120;  // locals that two steps of SP make cheaper than LINK

/// What the prologue pushes: R7:n and P5:m at once (8 and 6 mean none), a handler's scratch
/// registers one by one.
struct PushList {
  unsigned lowest_d = 8;
  unsigned lowest_p = 6;
  SmallVector<MCPhysReg, 7> single;
  bool multiple() const { return lowest_d < 8 || lowest_p < 6; }
};

PushList push_list(ArrayRef<CalleeSavedInfo> saved) {
  PushList list;
  for (const CalleeSavedInfo& info : saved) {
    unsigned reg = info.getReg();
    if (reg >= Bfin::R4 && reg <= Bfin::R7)
      list.lowest_d = std::min(list.lowest_d, reg - Bfin::R0);
    else if (reg >= Bfin::P3 && reg <= Bfin::P5)
      list.lowest_p = std::min(list.lowest_p, reg - Bfin::P0);
    else
      list.single.push_back(static_cast<MCPhysReg>(reg));
  }
  return list;
}

bool has_assembly(const MachineFunction& function) {
  return function.hasInlineAsm() && any_of(function, [](const MachineBasicBlock& block) {
           return any_of(block, [](const MachineInstr& inst) {
             return inst.isInlineAsm() && *inst.getOperand(0).getSymbolName() != 0;
           });
         });
}

/// Whether a function's own instructions do not tell all that it changes: its callees, or its
/// assembly, which need not say so of the I, M, B and A registers.
bool changes_anything(const MachineFunction& function) {
  return function.getFrameInfo().hasCalls() || has_assembly(function);
}

/// What an interrupt handler keeps beside R and P: whatever it or its callees may change, in the
/// order of the pushes.
SmallVector<MCPhysReg, 32> interrupt_registers(const MachineFunction& function) {
  SmallVector<MCPhysReg, 32> regs = {Bfin::ASTAT};
  const bool anything = changes_anything(function);
  if (anything || function.getInfo<BfinMachineFunctionInfo>()->has_hardware_loops)
    regs.append({Bfin::LB0, Bfin::LB1, Bfin::LT0, Bfin::LT1, Bfin::LC0, Bfin::LC1});
  const auto is_touched = [&](MCPhysReg reg) {
    return anything || !function.getRegInfo().def_empty(reg);
  };
  if (is_touched(Bfin::A0) || is_touched(Bfin::A1))
    regs.append({Bfin::A0X, Bfin::A0W, Bfin::A1X, Bfin::A1W});
  for (const MCPhysReg index : {Bfin::I0, Bfin::I1, Bfin::I2, Bfin::I3})
    if (is_touched(index))
      regs.push_back(index);
  if (anything)
    regs.append({Bfin::M0, Bfin::M1, Bfin::M2, Bfin::M3, Bfin::B0, Bfin::B1, Bfin::B2, Bfin::B3,
                 Bfin::L0, Bfin::L1, Bfin::L2, Bfin::L3});
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

/// Bytes of locals, spills and outgoing arguments, once PEI has laid the frame out.
static uint64_t local_bytes(const MachineFunction& function) {
  return function.getFrameInfo().getStackSize() -
         function.getInfo<BfinMachineFunctionInfo>()->saved_bytes - kLinkBytes;
}

bool BfinFrameLowering::hasFP(const MachineFunction& function) const {
  const MachineFrameInfo& frame = function.getFrameInfo();
  return frame.hasCalls() || !function.getRegInfo().def_empty(Bfin::RETS) ||
         frame.hasVarSizedObjects() || frame.isFrameAddressTaken() ||
         (frame.getStackSize() > kLinkBytes && local_bytes(function) > kMostWithoutLink);
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
  if (handler && has_assembly(function))
    saved.set(Bfin::R3);  // clear_lengths
  // A multiple push saves everything from its lowest register upwards.
  for (auto [first, last] : {std::pair(Bfin::R4, Bfin::R7), std::pair(Bfin::P3, Bfin::P5)}) {
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
  frame.CreateFixedObject(special + kLinkBytes,
                          -static_cast<int64_t>(offset + special + kLinkBytes), true);
  return true;
}

bool BfinFrameLowering::spillCalleeSavedRegisters(MachineBasicBlock& block,
                                                  MachineBasicBlock::iterator at,
                                                  ArrayRef<CalleeSavedInfo> saved,
                                                  const TargetRegisterInfo*) const {
  MachineFunction& function = *block.getParent();
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  PushList list = push_list(saved);
  for (const CalleeSavedInfo& info : saved) {
    auto reg = static_cast<MCPhysReg>(info.getReg().id());
    if (!block.isLiveIn(reg))
      block.addLiveIn(reg);
  }
  if (list.multiple()) {
    auto push = BuildMI(block, at, DebugLoc(), tii.get(Bfin::PUSHM))
                    .addImm(list.lowest_d)
                    .addImm(list.lowest_p)
                    .setMIFlag(MachineInstr::FrameSetup);
    for (const CalleeSavedInfo& info : saved)
      if (!is_contained(list.single, info.getReg()))
        push.addReg(info.getReg(), RegState::ImplicitKill);
  }
  for (MCPhysReg reg : list.single)
    BuildMI(block, at, DebugLoc(), tii.get(Bfin::PUSH))
        .addReg(reg, RegState::Kill)
        .setMIFlag(MachineInstr::FrameSetup);
  return true;
}

bool BfinFrameLowering::restoreCalleeSavedRegisters(MachineBasicBlock& block,
                                                    MachineBasicBlock::iterator at,
                                                    MutableArrayRef<CalleeSavedInfo> saved,
                                                    const TargetRegisterInfo*) const {
  const auto& tii = *block.getParent()->getSubtarget<BfinSubtarget>().getInstrInfo();
  PushList list = push_list(saved);
  for (MCPhysReg reg : reverse(list.single))
    BuildMI(block, at, DebugLoc(), tii.get(Bfin::POP), reg).setMIFlag(MachineInstr::FrameDestroy);
  if (!list.multiple())
    return true;
  auto pop = BuildMI(block, at, DebugLoc(), tii.get(Bfin::POPM))
                 .addImm(list.lowest_d)
                 .addImm(list.lowest_p)
                 .setMIFlag(MachineInstr::FrameDestroy);
  for (const CalleeSavedInfo& info : saved)
    if (!is_contained(list.single, info.getReg()))
      pop.addReg(info.getReg(), RegState::ImplicitDefine);
  return true;
}

/// SP += bytes, in steps of the seven-bit immediate.
static void step_stack(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                       const DebugLoc& loc, const BfinInstrInfo& tii, int64_t bytes,
                       MachineInstr::MIFlag flag) {
  while (bytes != 0) {
    int64_t step = std::clamp<int64_t>(bytes, -64, 60);
    BuildMI(block, at, loc, tii.get(Bfin::ADDI), Bfin::SP)
        .addReg(Bfin::SP)
        .addImm(step)
        .setMIFlag(flag);
    bytes -= step;
  }
}

/// What is interrupted may use circular buffers; what a handler calls, or does in assembly, expects
/// none.
static void clear_lengths(MachineBasicBlock& block, MachineBasicBlock::iterator at,
                          const BfinInstrInfo& tii) {
  BuildMI(block, at, DebugLoc(), tii.get(Bfin::MOVI), Bfin::R3).addImm(0);
  for (MCPhysReg reg : {Bfin::L0, Bfin::L1, Bfin::L2, Bfin::L3})
    BuildMI(block, at, DebugLoc(), tii.get(Bfin::MOV), reg).addReg(Bfin::R3);
}

/// "file:line:1: " of the function; empty without debug information.
static std::string place_of(const Function& function) {
  const DISubprogram* sub = function.getSubprogram();
  return sub == nullptr ? "" : (sub->getFilename() + ":" + Twine(sub->getLine()) + ":1: ").str();
}

void BfinFrameLowering::emitPrologue(MachineFunction& function, MachineBasicBlock& block) const {
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  auto at = block.begin();
  while (at != block.end() && at->getFlag(MachineInstr::FrameSetup))
    ++at;
  if (isInterruptHandler(function.getFunction())) {
    for (MCPhysReg reg : interrupt_registers(function))
      BuildMI(block, at, DebugLoc(), tii.get(Bfin::PUSH))
          .addReg(reg, RegState::Undef)
          .setMIFlag(MachineInstr::FrameSetup);
    if (changes_anything(function))
      clear_lengths(block, at, tii);
  }
  auto locals = static_cast<int64_t>(local_bytes(function));
  if (!hasFP(function)) {
    step_stack(block, at, DebugLoc(), tii, -locals, MachineInstr::FrameSetup);
    return;
  }
  if (locals > kMostLinked)
    report_fatal_error(place_of(function.getFunction()) + "error: the stack frame of " +
                       function.getName() + " takes " + Twine(locals) +
                       " bytes; LINK makes at most " + Twine(kMostLinked));
  BuildMI(block, at, DebugLoc(), tii.get(Bfin::LINK))
      .addImm(locals)
      .setMIFlag(MachineInstr::FrameSetup);
}

void BfinFrameLowering::emitEpilogue(MachineFunction& function, MachineBasicBlock& block) const {
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  auto at = block.getFirstTerminator();
  while (at != block.begin() && std::prev(at)->getFlag(MachineInstr::FrameDestroy))
    --at;
  DebugLoc loc = at == block.end() ? DebugLoc() : at->getDebugLoc();
  if (hasFP(function))
    BuildMI(block, at, loc, tii.get(Bfin::UNLINK)).setMIFlag(MachineInstr::FrameDestroy);
  else
    step_stack(block, at, loc, tii, static_cast<int64_t>(local_bytes(function)),
               MachineInstr::FrameDestroy);
  if (isInterruptHandler(function.getFunction())) {
    auto regs = interrupt_registers(function);  // named: reverse() only refers to it
    for (MCPhysReg reg : reverse(regs))
      BuildMI(block, at, loc, tii.get(Bfin::POP), reg).setMIFlag(MachineInstr::FrameDestroy);
  }
}

StackOffset BfinFrameLowering::getFrameIndexReference(const MachineFunction& function, int index,
                                                      Register& base) const {
  int64_t offset = function.getFrameInfo().getObjectOffset(index) +
                   function.getInfo<BfinMachineFunctionInfo>()->saved_bytes;
  if (hasFP(function)) {
    base = Bfin::FP;
    return StackOffset::getFixed(offset + kLinkBytes);
  }
  // Without LINK its two words are not there: the locals lie higher by as much.
  base = Bfin::SP;
  bool argument = function.getFrameInfo().getObjectOffset(index) >= 0;
  return StackOffset::getFixed(offset + static_cast<int64_t>(local_bytes(function)) +
                               (argument ? 0 : kLinkBytes));
}

MachineBasicBlock::iterator BfinFrameLowering::eliminateCallFramePseudoInstr(
    MachineFunction& function, MachineBasicBlock& block, MachineBasicBlock::iterator at) const {
  const auto& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  // Nothing returns from a call that the function ends with.
  const bool returns = !block.succ_empty() || std::next(at) != block.end();
  if (!hasReservedCallFrame(function) && returns) {
    int64_t bytes = at->getOperand(0).getImm();
    if (at->getOpcode() == Bfin::ADJCALLSTACKDOWN)
      bytes = -bytes;
    step_stack(block, at, at->getDebugLoc(), tii, bytes, MachineInstr::NoFlags);
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
