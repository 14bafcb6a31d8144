// Accesses to neighbours through a pointer that steps over them, [P - 1] and [P] and then P += 2,
// as unrolled loops have them, become accesses that step one by one: those are two bytes long and
// may share packets. Only in loops of one block, where nothing else reads the pointer and the
// accesses stand in the order of their addresses, one size apart.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

class BfinSteppedAccesses : public MachineFunctionPass {
 public:
  static char ID;
  BfinSteppedAccesses() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin stepped accesses"; }
  bool runOnMachineFunction(MachineFunction& function) override;
};

char BfinSteppedAccesses::ID = 0;

struct Access {
  unsigned plain;
  unsigned stepped;
  int size;
};

constexpr Access kAccesses[] = {
    {Bfin::LDW, Bfin::LDWInc, 4},   {Bfin::LDHZ, Bfin::LDHZInc, 2}, {Bfin::LDHX, Bfin::LDHXInc, 2},
    {Bfin::LDBZ, Bfin::LDBZInc, 1}, {Bfin::LDBX, Bfin::LDBXInc, 1}, {Bfin::STW, Bfin::STWInc, 4},
    {Bfin::STH, Bfin::STHInc, 2},   {Bfin::STB, Bfin::STBInc, 1},
};

const Access* access_of(const MachineInstr& inst) {
  const Access* found =
      find_if(kAccesses, [&](const Access& access) { return access.plain == inst.getOpcode(); });
  return found == std::end(kAccesses) ? nullptr : found;
}

/// A pointer's accesses in one round, from the first address on.
struct Walk {
  MachineInstr* phi;
  MachineInstr* step;
  SmallVector<MachineInstr*, 4> accesses;
  int64_t first = 0;
};

std::optional<Walk> walk_of(MachineInstr& phi) {
  MachineBasicBlock& block = *phi.getParent();
  const MachineRegisterInfo& regs = block.getParent()->getRegInfo();
  if (phi.getNumOperands() != 5)
    return std::nullopt;
  const unsigned around = phi.getOperand(2).getMBB() == &block ? 1 : 3;
  const Register pointer = phi.getOperand(0).getReg();
  const Register next = phi.getOperand(around).getReg();
  MachineInstr* step = next.isVirtual() ? regs.getVRegDef(next) : nullptr;
  if (step == nullptr || step->getOpcode() != Bfin::ADDI || step->getParent() != &block ||
      step->getOperand(1).getReg() != pointer || !regs.hasOneNonDBGUse(next))
    return std::nullopt;
  Walk walk{&phi, step, {}, 0};
  int64_t at = 0;
  size_t uses = 0;
  for (MachineInstr& inst : block) {
    const Access* access = access_of(inst);
    if (access == nullptr || !inst.getOperand(1).isReg() ||
        inst.getOperand(1).getReg() != pointer || inst.getOperand(0).getReg() == pointer)
      continue;
    const int64_t displacement = inst.getOperand(2).getImm();
    if (walk.accesses.empty())
      at = walk.first = displacement;
    if (displacement != at)
      return std::nullopt;
    at += access->size;
    ++uses;
    walk.accesses.push_back(&inst);
  }
  const auto users = regs.use_nodbg_operands(pointer);
  if (walk.accesses.empty() || at - walk.first != step->getOperand(2).getImm() ||
      static_cast<size_t>(std::distance(users.begin(), users.end())) != uses + 1 ||
      !isInt<7>(walk.first))
    return std::nullopt;
  return walk;
}

/// The pointer as it comes into the loop, moved to the first access.
void move_start(const Walk& walk, const BfinInstrInfo& tii) {
  MachineBasicBlock& block = *walk.phi->getParent();
  MachineRegisterInfo& regs = block.getParent()->getRegInfo();
  const unsigned from = walk.phi->getOperand(2).getMBB() == &block ? 3 : 1;
  MachineBasicBlock& before = *walk.phi->getOperand(from + 1).getMBB();
  const Register start =
      regs.createVirtualRegister(regs.getRegClass(walk.phi->getOperand(0).getReg()));
  BuildMI(before, before.getFirstTerminator(), walk.step->getDebugLoc(), tii.get(Bfin::ADDI), start)
      .addReg(walk.phi->getOperand(from).getReg())
      .addImm(walk.first);
  regs.clearKillFlags(walk.phi->getOperand(from).getReg());
  walk.phi->getOperand(from).setReg(start);
}

void rewrite(const Walk& walk, const BfinInstrInfo& tii) {
  MachineBasicBlock& block = *walk.phi->getParent();
  MachineRegisterInfo& regs = block.getParent()->getRegInfo();
  if (walk.first != 0)
    move_start(walk, tii);
  Register pointer = walk.phi->getOperand(0).getReg();
  regs.constrainRegClass(pointer, &Bfin::PRegClass);
  for (MachineInstr* inst : walk.accesses) {
    const bool is_last = inst == walk.accesses.back();
    const Register next =
        is_last ? walk.step->getOperand(0).getReg() : regs.createVirtualRegister(&Bfin::PRegClass);
    const MachineInstrBuilder stepped =
        BuildMI(block, inst, inst->getDebugLoc(), tii.get(access_of(*inst)->stepped));
    if (inst->mayStore())
      stepped.addDef(next).addReg(inst->getOperand(0).getReg());
    else
      stepped.addDef(inst->getOperand(0).getReg()).addDef(next);
    stepped.addReg(pointer).cloneMemRefs(*inst);
    pointer = next;
  }
  regs.constrainRegClass(pointer, &Bfin::PRegClass);
  for (MachineInstr* inst : walk.accesses)
    inst->eraseFromParent();
  walk.step->eraseFromParent();
}

bool BfinSteppedAccesses::runOnMachineFunction(MachineFunction& function) {
  const BfinInstrInfo& tii = *function.getSubtarget<BfinSubtarget>().getInstrInfo();
  bool changed = false;
  for (MachineBasicBlock& block : function) {
    if (!block.isSuccessor(&block))
      continue;
    SmallVector<Walk, 4> walks;
    for (MachineInstr& phi : block.phis())
      if (std::optional<Walk> walk = walk_of(phi))
        walks.push_back(std::move(*walk));
    for (const Walk& walk : walks)
      rewrite(walk, tii);
    changed = changed || !walks.empty();
  }
  return changed;
}

}  // namespace

FunctionPass* createBfinSteppedAccesses() { return new BfinSteppedAccesses(); }

}  // namespace llvm
