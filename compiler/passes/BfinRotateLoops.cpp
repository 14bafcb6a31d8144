// Two passes of a small loop at once: the first stage of the next pass runs beside the second stage
// of the present one, in packets that would have had room, or where it waited for its own results.
//
//   loop: F; S            F
//                         if only one pass: jump last
//                   loop: S and the next F  (one pass less)
//                   last: S
//
// Looks at loops of one block on a loop counter, on SSA form before allocation; ModuloSchedule says
// what belongs to F and to S and in which order they stand. Nothing is done that was not before.
// Not where the loop saves less than what stands around it costs, nor where registers do not
// suffice.
#include <llvm/CodeGen/MachineBlockFrequencyInfo.h>
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineLoopInfo.h>
#include <llvm/CodeGen/MachineRegisterInfo.h>
#include <llvm/InitializePasses.h>
#include <map>
#include <optional>
#include <set>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinMachineFunctionInfo.hpp"
#include "../target/BfinSubtarget.hpp"
#include "CountedLoop.hpp"
#include "LoopPhis.hpp"
#include "ModuloSchedule.hpp"

namespace llvm {
namespace {

constexpr size_t kMostInstructions = 64;  // of a body: it stands twice afterwards
constexpr unsigned kMostCycles = 4;       // of one instruction, with what it waits for
constexpr double kCyclesAround = 6;       // for a count that may be one
constexpr double kCyclesAroundKnown = 2;
constexpr size_t kDataRegisters = 8;
constexpr size_t kPointerRegisters = 6;

using Registers = std::map<Register, Register>;

class BfinRotateLoops : public MachineFunctionPass {
 public:
  static char ID;
  BfinRotateLoops() : MachineFunctionPass(ID) {
    initializeMachineBlockFrequencyInfoWrapperPassPass(*PassRegistry::getPassRegistry());
    initializeMachineLoopInfoWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin loop rotation"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<AAResultsWrapperPass>();
    usage.addRequired<MachineBlockFrequencyInfoWrapperPass>();
    usage.addRequired<MachineLoopInfoWrapperPass>();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  struct Loop : CountedLoop {
    MachineBasicBlock* counted = nullptr;  // where one is taken off the count: it is known there
    std::vector<MachineInstr*> first;      // of each pass, the stage that runs a pass ahead
    std::vector<MachineInstr*> second;
    std::vector<MachineInstr*> order;  // of both in the loop
    std::vector<IndexStream> streams;  // of pointers that move to I registers
  };

  bool find(MachineBasicBlock& block, Loop& loop) const;
  bool divide(Loop& loop) const;
  MachineBasicBlock* place_of_count(const Loop& loop) const;
  bool pays(const Loop& loop, unsigned saved) const;
  bool values_stay_in_their_banks(const MachineBasicBlock& block) const;
  bool registers_suffice(const LoopDependences& loop, const ModuloSchedule& schedule,
                         const std::vector<IndexStream>& streams) const;
  void rotate(Loop& loop);
  Registers begin_before(const Loop& loop);
  std::optional<int64_t> passes(const Loop& loop) const;
  bool runs_twice(const Loop& loop) const;
  void count_one_less(Loop& loop, MachineBasicBlock* last);
  MachineBasicBlock* make_last(const Loop& loop, const Registers& first, const Registers& next,
                               const Registers& found);
  Register outside(MachineBasicBlock& last, Register value);
  void forget_address(MachineInstr& access, const LoopScopes& scopes);
  void replace(MachineOperand& use, Register value);
  void clone(const MachineInstr& inst, MachineBasicBlock& block, Registers& values);
  Register incoming(const MachineInstr& phi, const MachineBasicBlock& from) const;
  Register alike(Register reg) { return regs_->createVirtualRegister(regs_->getRegClass(reg)); }

  MachineFunction* function_ = nullptr;
  MachineRegisterInfo* regs_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
  AAResults* aliases_ = nullptr;
  const MachineBlockFrequencyInfo* frequencies_ = nullptr;
  const MachineLoopInfo* loops_ = nullptr;
};

char BfinRotateLoops::ID = 0;

Register value_of(const Registers& values, Register reg) {
  const auto found = values.find(reg);
  return found == values.end() ? reg : found->second;
}

Register BfinRotateLoops::incoming(const MachineInstr& phi, const MachineBasicBlock& from) const {
  return phi.getOperand(incoming_operand(phi, from)).getReg();
}

bool BfinRotateLoops::find(MachineBasicBlock& block, Loop& loop) const {
  if (!loop.find(block))
    return false;
  loop.counted = place_of_count(loop);
  return divide(loop);
}

/// In front of all loops that find the same count.
MachineBasicBlock* BfinRotateLoops::place_of_count(const Loop& loop) const {
  const MachineInstr* count = regs_->getVRegDef(loop.setup->getOperand(1).getReg());
  MachineBasicBlock* place = loop.before;
  for (const MachineLoop* around = loops_->getLoopFor(place);
       around != nullptr && !around->contains(count->getParent());
       around = around->getParentLoop()) {
    MachineBasicBlock* outside = around->getLoopPreheader();
    if (outside == nullptr)
      break;
    place = outside;
  }
  return place;
}

/// Into stages. False: nothing would be won.
bool BfinRotateLoops::divide(Loop& loop) const {
  const LoopDependences dependences(*loop.block, *aliases_);
  const std::vector<MachineInstr*>& instructions = dependences.instructions();
  if (!dependences.complete() || instructions.empty() || instructions.size() > kMostInstructions ||
      !values_stay_in_their_banks(*loop.block))
    return false;
  const std::vector<IndexStream> streams = index_streams(*loop.block);
  const ModuloSchedule in_one =
      schedule_loop(dependences, *tii_, 1, kMostCycles * kMostInstructions, streams,
                    [](const ModuloSchedule&) { return true; });
  const unsigned alone = in_one.cycles;
  if (alone < 2)
    return false;
  const auto in_two = [&](const std::vector<IndexStream>& indexed, unsigned most) {
    return schedule_loop(dependences, *tii_, 2, most, indexed, [&](const ModuloSchedule& found) {
      return registers_suffice(dependences, found, indexed);
    });
  };
  loop.streams = streams;
  ModuloSchedule schedule = in_two(streams, alone - 1);
  if (schedule.cycles == 0) {
    loop.streams.clear();
    schedule = in_two({}, alone - 1);
  }
  if (schedule.cycles == 0)
    return false;
  // As few I registers as that takes.
  for (const IndexStream& stream : std::vector<IndexStream>(loop.streams)) {
    std::vector<IndexStream> fewer = loop.streams;
    llvm::erase_if(fewer, [&](const IndexStream& one) { return one.phi == stream.phi; });
    if (ModuloSchedule other = in_two(fewer, schedule.cycles); other.cycles != 0) {
      schedule = std::move(other);
      loop.streams = std::move(fewer);
    }
  }
  if (!pays(loop, alone - schedule.cycles))
    return false;
  for (const size_t i : kernel_order(dependences, schedule)) {
    loop.order.push_back(instructions[i]);
    (schedule.in_first_stage(i) ? loop.first : loop.second).push_back(instructions[i]);
  }
  return !loop.first.empty() && !loop.second.empty();
}

/// What each pass saves against what stands around the loop: the count, a comparison, a branch.
bool BfinRotateLoops::pays(const Loop& loop, unsigned saved) const {
  const std::optional<int64_t> known = passes(loop);
  const double count =
      known ? static_cast<double>(*known)
            : frequencies_->getBlockFreqRelativeToEntryBlock(loop.block) /
                  std::max(frequencies_->getBlockFreqRelativeToEntryBlock(loop.before), 1e-6);
  return (count - 1) * saved > (runs_twice(loop) ? kCyclesAroundKnown : kCyclesAround);
}

/// Whether each value that goes from pass to pass stays in one bank.
bool BfinRotateLoops::values_stay_in_their_banks(const MachineBasicBlock& block) const {
  return all_of(block.phis(), [&](const MachineInstr& phi) {
    const TargetRegisterClass* wanted = regs_->getRegClass(phi.getOperand(0).getReg());
    return regs_->getRegClass(incoming(phi, block)) == wanted && phi.getNumOperands() == 5 &&
           phi.getOperand(1).getSubReg() == 0 && phi.getOperand(3).getSubReg() == 0;
  });
}

/// Whether what lives at once in the loop has registers: its values, from cycle to cycle, and what
/// comes from outside. A value's register is free again with its last use.
bool BfinRotateLoops::registers_suffice(const LoopDependences& loop, const ModuloSchedule& schedule,
                                        const std::vector<IndexStream>& streams) const {
  const auto bank = [&](Register reg) -> size_t {
    return Bfin::PRegClass.hasSubClassEq(regs_->getRegClass(reg)) ? 1 : 0;
  };
  const auto is_ring = [&](Register reg) { return regs_->getRegClass(reg) == &Bfin::RINGRegClass; };
  std::array<std::vector<size_t>, 2> living;
  living.fill(std::vector<size_t>(schedule.cycles, 0));
  std::set<Register> outside;
  std::map<Register, unsigned> ends;
  const std::vector<MachineInstr*>& instructions = loop.instructions();
  for (size_t i = 0; i < instructions.size(); ++i)
    for (const MachineOperand& use : instructions[i]->all_uses()) {
      if (!use.getReg().isVirtual() || use.isUndef() || is_ring(use.getReg()))
        continue;
      Register reg = use.getReg();
      unsigned end = schedule.times[i];
      const MachineInstr* def = regs_->getVRegDef(reg);
      if (def->isPHI() && def->getParent() == instructions[i]->getParent()) {
        reg = incoming(*def, *def->getParent());
        end += schedule.cycles;
        def = regs_->getVRegDef(reg);
      }
      if (def->getParent() == instructions[i]->getParent())
        ends[reg] = std::max(ends[reg], end);
      else
        outside.insert(reg);
    }
  // What moves to I registers needs no P register.
  for (const IndexStream& stream : streams)
    for (const MachineInstr* access : stream.accesses)
      for (const MachineOperand& def : access->defs())
        if (bank(def.getReg()) == 1)
          ends.erase(def.getReg());
  // Of a register with a zero in its upper half no cycle is free.
  for (const IndexStream& stream : streams)
    for (const MachineInstr* load : stream.zero_extended)
      ends[load->getOperand(0).getReg()] = 2 * schedule.cycles;
  for (size_t i = 0; i < instructions.size(); ++i)
    for (const MachineOperand& def : instructions[i]->defs())
      if (const auto end = ends.find(def.getReg()); end != ends.end())
        for (unsigned time = schedule.times[i] + 1;
             time <= std::min(end->second, schedule.times[i] + schedule.cycles); ++time)
          ++living[bank(def.getReg())][time % schedule.cycles];
  std::array<size_t, 2> always = {};
  for (const Register reg : outside)
    ++always[bank(reg)];
  return *std::max_element(living[0].begin(), living[0].end()) + always[0] <= kDataRegisters &&
         *std::max_element(living[1].begin(), living[1].end()) + always[1] <= kPointerRegisters;
}

/// Lets an instruction read `value` instead.
void BfinRotateLoops::replace(MachineOperand& use, Register value) {
  regs_->constrainRegClass(value, regs_->getRegClass(use.getReg()));
  use.setReg(value);
  use.setIsKill(false);
}

/// Appends `inst` with its values replaced; what it defines gets new registers, noted in `values`.
void BfinRotateLoops::clone(const MachineInstr& inst, MachineBasicBlock& block, Registers& values) {
  MachineInstr* copy = function_->CloneMachineInstr(&inst);
  block.insert(block.getFirstTerminator(), copy);
  for (MachineOperand& operand : copy->operands()) {
    if (!operand.isReg() || !operand.getReg().isVirtual())
      continue;
    if (operand.isUse())
      replace(operand, value_of(values, operand.getReg()));
  }
  for (MachineOperand& operand : copy->defs())
    if (operand.getReg().isVirtual()) {
      const Register reg = alike(operand.getReg());
      values[operand.getReg()] = reg;
      operand.setReg(reg);
    }
}

/// The first pass's first stage, in front of the loop. What each register of the body then is.
Registers BfinRotateLoops::begin_before(const Loop& loop) {
  Registers values;
  for (const MachineInstr& phi : loop.block->phis())
    values[phi.getOperand(0).getReg()] = incoming(phi, *loop.before);
  for (const MachineInstr* inst : loop.first)
    clone(*inst, *loop.before, values);
  return values;
}

/// How many passes there are, where that is known.
std::optional<int64_t> BfinRotateLoops::passes(const Loop& loop) const {
  const MachineInstr* count = regs_->getVRegDef(loop.setup->getOperand(1).getReg());
  while (count->isCopy() && count->getOperand(1).getReg().isVirtual())
    count = regs_->getVRegDef(count->getOperand(1).getReg());
  if (count->getOpcode() != Bfin::MOVI && count->getOpcode() != Bfin::MOVU)
    return std::nullopt;
  return count->getOperand(1).getImm();
}

bool BfinRotateLoops::runs_twice(const Loop& loop) const {
  return passes(loop).value_or(loop.setup->getOperand(2).getImm()) > 1;
}

/// The loop makes one pass less; where that is none, control goes to the last one.
void BfinRotateLoops::count_one_less(Loop& loop, MachineBasicBlock* last) {
  MachineBasicBlock& before = *loop.before;
  const DebugLoc& loc = loop.setup->getDebugLoc();
  MachineOperand& count = loop.setup->getOperand(1);
  const Register less = regs_->createVirtualRegister(&Bfin::PRegClass);
  const bool twice = runs_twice(loop);
  if (const std::optional<int64_t> known = passes(loop))
    tii_->buildConstant(before, loop.setup, loc, less, *known - 1);
  else
    BuildMI(*loop.counted,
            loop.counted == &before ? loop.setup : loop.counted->getFirstTerminator(), loc,
            tii_->get(Bfin::ADDI), less)
        .addReg(count.getReg())
        .addImm(-1);
  regs_->clearKillFlags(count.getReg());
  count.setReg(less);
  count.setIsKill(false);
  loop.setup->getOperand(2).setImm(1);
  if (twice)
    return;
  MachineBasicBlock* enter = function_->CreateMachineBasicBlock(loop.block->getBasicBlock());
  function_->insert(std::next(before.getIterator()), enter);
  enter->splice(enter->end(), &before, loop.setup->getIterator(), before.end());
  before.replaceSuccessor(loop.block, enter);
  enter->addSuccessor(loop.block);
  loop.block->replacePhiUsesWith(&before, enter);
  before.addSuccessor(last, BranchProbability(1, 16));
  before.normalizeSuccProbs();
  BuildMI(&before, loc, tii_->get(Bfin::CMPEQI)).addReg(less).addImm(0);
  BuildMI(&before, loc, tii_->get(Bfin::JCC)).addMBB(last).addImm(0);
}

/// The value as it is behind `last`: pointers are in P registers there.
Register BfinRotateLoops::outside(MachineBasicBlock& last, Register value) {
  if (!Bfin::IRRegClass.hasSubClassEq(regs_->getRegClass(value)))
    return value;
  const Register pointer = regs_->createVirtualRegister(&Bfin::PRegClass);
  BuildMI(last, last.getFirstTerminator(), DebugLoc(), tii_->get(TargetOpcode::COPY), pointer)
      .addReg(value);
  regs_->clearKillFlags(value);
  return pointer;
}

/// The last pass, behind the loop, and where the only one begins. `first` and `next`: what the
/// registers of the body are on the way from before the loop and from the loop; `found`: by what
/// name the rest reads what the loads found.
MachineBasicBlock* BfinRotateLoops::make_last(const Loop& loop, const Registers& first,
                                              const Registers& next, const Registers& found) {
  MachineBasicBlock* last = function_->CreateMachineBasicBlock(loop.block->getBasicBlock());
  function_->insert(std::next(loop.block->getIterator()), last);
  const bool only = !runs_twice(loop);
  Registers values;
  for (const auto& [reg, from_loop] : next) {
    if (!only) {
      values[reg] = from_loop;
      continue;
    }
    values[reg] = alike(reg);
    BuildMI(*last, last->begin(), DebugLoc(), tii_->get(TargetOpcode::PHI), values[reg])
        .addReg(value_of(first, reg))
        .addMBB(loop.before)
        .addReg(from_loop)
        .addMBB(loop.block);
  }
  for (const auto& [reg, phi] : found)
    values[phi] = values[reg];
  for (const MachineInstr* inst : loop.second)
    clone(*inst, *last, values);
  // Whoever is outside sees the last pass.
  for (MachineInstr& inst : *loop.block)
    for (const MachineOperand& def : inst.defs()) {
      if (!def.getReg().isVirtual())
        continue;
      for (MachineOperand& use : make_early_inc_range(regs_->use_operands(def.getReg()))) {
        const MachineBasicBlock* user = use.getParent()->getParent();
        if (user != loop.block && user != last)
          use.setReg(outside(*last, value_of(values, def.getReg())));
      }
    }
  last->addSuccessor(loop.after);
  if (!last->isLayoutSuccessor(loop.after))
    BuildMI(last, loop.second.back()->getDebugLoc(), tii_->get(Bfin::JUMP)).addMBB(loop.after);
  loop.block->replaceSuccessor(loop.after, last);
  loop.after->replacePhiUsesWith(loop.block, last);
  return last;
}

/// What is known of an access's address is known of the pass that it was in, not of the next.
void BfinRotateLoops::forget_address(MachineInstr& access, const LoopScopes& scopes) {
  SmallVector<MachineMemOperand*, 1> places;
  for (const MachineMemOperand* place : access.memoperands())
    places.push_back(in_any_pass(*function_, *place, scopes));
  access.setMemRefs(*function_, places);
}

void BfinRotateLoops::rotate(Loop& loop) {
  MachineBasicBlock& block = *loop.block;
  for (const IndexStream& stream : loop.streams)
    use_index_register(stream, *loop.before, *tii_);
  const LoopScopes scopes(block);
  for (MachineInstr* inst : loop.first)
    forget_address(*inst, scopes);
  const Registers first = begin_before(loop);

  // What the first stage found lives until the second one, in the next round of the loop.
  Registers found;
  for (const MachineInstr* inst : loop.first)
    for (const MachineOperand& def : inst->defs())
      if (def.getReg().isVirtual())
        found[def.getReg()] = alike(def.getReg());
  for (MachineInstr* inst : loop.second)
    for (MachineOperand& use : inst->all_uses())
      if (found.count(use.getReg()) != 0) {
        use.setReg(found[use.getReg()]);
        use.setIsKill(false);
      }
  // What the registers of the body are when the next pass begins: by the pass's own end, but for
  // the first stage, which then has run already.
  Registers next;
  for (MachineInstr& phi : block.phis()) {
    MachineOperand& own = phi.getOperand(phi.getOperand(2).getMBB() == &block ? 1 : 3);
    if (found.count(own.getReg()) != 0)
      own.setReg(found[own.getReg()]);
    next[phi.getOperand(0).getReg()] = own.getReg();
  }
  Registers at_end = next;
  for (MachineInstr* inst : loop.first) {
    for (MachineOperand& use : inst->all_uses())
      if (use.getReg().isVirtual())
        replace(use, value_of(at_end, use.getReg()));
    for (const MachineOperand& def : inst->defs())
      if (def.getReg().isVirtual())
        next[def.getReg()] = def.getReg();
  }
  for (MachineInstr* inst : loop.order)
    block.splice(block.getFirstTerminator(), &block, inst->getIterator());
  for (const auto& [reg, phi] : found)
    BuildMI(block, block.begin(), DebugLoc(), tii_->get(TargetOpcode::PHI), phi)
        .addReg(value_of(first, reg))
        .addMBB(loop.before)
        .addReg(reg)
        .addMBB(&block);
  for (const auto& [reg, value] : next)
    regs_->clearKillFlags(value);

  MachineBasicBlock* last = make_last(loop, first, next, found);
  for (MachineInstr& inst : make_early_inc_range(block.terminators()))
    if (inst.getOpcode() == Bfin::JUMP)
      inst.getOperand(0).setMBB(last);
  count_one_less(loop, last);
}

bool BfinRotateLoops::runOnMachineFunction(MachineFunction& function) {
  if (function.getFunction().hasOptSize())
    return false;
  function_ = &function;
  regs_ = &function.getRegInfo();
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  aliases_ = &getAnalysis<AAResultsWrapperPass>().getAAResults();
  frequencies_ = &getAnalysis<MachineBlockFrequencyInfoWrapperPass>().getMBFI();
  loops_ = &getAnalysis<MachineLoopInfoWrapperPass>().getLI();
  std::vector<Loop> loops;
  for (MachineBasicBlock& block : function) {
    Loop loop;
    if (find(block, loop))
      loops.push_back(std::move(loop));
  }
  for (Loop& loop : loops) {
    rotate(loop);
    function.getInfo<BfinMachineFunctionInfo>()->ordered_blocks.insert(loop.block);
  }
  return !loops.empty();
}

}  // namespace

FunctionPass* createBfinRotateLoops() { return new BfinRotateLoops(); }

}  // namespace llvm
