// A second access a cycle: in a loop of one block, pointers that are only stepped by their own
// accesses move to I registers, so that a packet holds an access through one of these beside one
// through a P register. Done where the packets of the loop become fewer, with as few I registers as
// that takes; they are free at calls and serve no more than one loop at a time.
// Works after allocation, right before packets. Does not look at bytes, which I registers cannot
// reach, nor at 16-bit loads whose upper half would have to be made.
#include <llvm/CodeGen/MachineBlockFrequencyInfo.h>
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <llvm/CodeGen/MachineLoopInfo.h>
#include <llvm/InitializePasses.h>

#include "../target/Bfin.hpp"
#include "../target/BfinMachineFunctionInfo.hpp"
#include "../target/BfinSubtarget.hpp"
#include "HalfValues.hpp"
#include "IndexForms.hpp"
#include "PacketDag.hpp"

namespace llvm {
namespace {

constexpr MCPhysReg kIndexRegisters[kIndexRegisterCount] = {Bfin::I0, Bfin::I1, Bfin::I2, Bfin::I3};

/// One access of a pointer, as it is and through an I register; one of the two is in the block.
struct Access {
  MachineInstr* now;
  MachineInstr* other;
};

struct Stream {
  MCPhysReg pointer = 0;
  MCPhysReg index = 0;
  std::vector<Access> accesses;
  std::vector<MCPhysReg> zeros;  // data registers that must be 0 before the loop
};

class BfinIndexStreams : public MachineFunctionPass {
 public:
  static char ID;
  BfinIndexStreams() : MachineFunctionPass(ID) {
    initializeMachineLoopInfoWrapperPassPass(*PassRegistry::getPassRegistry());
    initializeMachineBlockFrequencyInfoWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin index streams"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<AAResultsWrapperPass>();
    usage.addRequired<MachineLoopInfoWrapperPass>();
    usage.addRequired<MachineBlockFrequencyInfoWrapperPass>();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  struct Loop {
    MachineBasicBlock* block = nullptr;
    MachineBasicBlock* before = nullptr;
    MachineBasicBlock* after = nullptr;
  };

  static bool find(MachineBasicBlock& block, Loop& loop);
  std::vector<Stream> streams_of(const Loop& loop);
  bool find_stream(const Loop& loop, MCPhysReg pointer, Stream& stream);
  MachineInstr* through_index(MachineInstr& inst, const Loop& loop, Stream& stream);
  std::vector<Stream> worth_it(const Loop& loop, std::vector<Stream> streams, PacketDag& dag);
  bool pays(const Loop& loop, const std::vector<Stream>& streams, unsigned saved) const;
  void commit(Loop& loop, const std::vector<Stream>& streams);

  MachineFunction* function_ = nullptr;
  const BfinInstrInfo* tii_ = nullptr;
  const MachineBlockFrequencyInfo* frequencies_ = nullptr;
};

char BfinIndexStreams::ID = 0;

/// Puts each access of the stream into the block that is not there.
void swap(Stream& stream) {
  for (Access& access : stream.accesses) {
    access.now->getParent()->insert(access.now->getIterator(), access.other);
    access.now->removeFromParent();
    std::swap(access.now, access.other);
  }
}

/// What C reaches by name may want one, and two passes at once have theirs (BfinRotateLoops).
bool uses_index_register(const MachineInstr& inst, const TargetRegisterInfo& tri) {
  return any_of(kIndexRegisters, [&](MCPhysReg index) {
    return inst.readsRegister(index, &tri) || inst.modifiesRegister(index, &tri);
  });
}

/// An outer loop's, or one of a circular buffer.
bool brings_index_register(const MachineBasicBlock& block, const TargetRegisterInfo& tri) {
  return any_of(block.liveins(), [&](const MachineBasicBlock::RegisterMaskPair& live) {
    return any_of(kIndexRegisters,
                  [&](MCPhysReg index) { return tri.regsOverlap(live.PhysReg, index); });
  });
}

bool BfinIndexStreams::find(MachineBasicBlock& block, Loop& loop) {
  if (!block.isSuccessor(&block) || block.succ_size() != 2 || block.pred_size() != 2)
    return false;
  const TargetRegisterInfo& tri = *block.getParent()->getSubtarget().getRegisterInfo();
  if (brings_index_register(block, tri))
    return false;
  for (const MachineInstr& inst : block)
    if (inst.isCall() || inst.isInlineAsm() || inst.isPosition() || uses_index_register(inst, tri))
      return false;
  const auto is_other = [&](const MachineBasicBlock* other) { return other != &block; };
  loop.block = &block;
  loop.before = *find_if(block.predecessors(), is_other);
  loop.after = *find_if(block.successors(), is_other);
  return loop.after->pred_size() == 1 || block.canSplitCriticalEdge(loop.after);
}

/// `inst` with its pointer in the stream's I register; null where that is not the same.
MachineInstr* BfinIndexStreams::through_index(MachineInstr& inst, const Loop& loop,
                                              Stream& stream) {
  const unsigned form = index_form(inst.getOpcode());
  if (form == 0)
    return nullptr;
  // What is loaded comes first, then the stepped pointer, what is stored, and the pointer.
  const bool steps = inst.getNumExplicitDefs() == (inst.mayLoad() ? 2U : 1U);
  const unsigned base = steps ? 2 : 1;
  const MachineOperand& value = inst.getOperand(inst.mayStore() && steps ? 1 : 0);
  const bool displaced = !steps && inst.getOperand(base + 1).getImm() != 0;
  const auto data = static_cast<MCPhysReg>(value.getReg().id());
  if (displaced || inst.getOperand(base).getReg() != stream.pointer ||
      !Bfin::DRegClass.contains(data))
    return nullptr;
  unsigned old_value = 0;
  if (is_half_load(form)) {
    const bool zero = inst.getOpcode() == Bfin::LDHZ || inst.getOpcode() == Bfin::LDHZInc ||
                      inst.getOpcode() == Bfin::LDHZDec;
    if (only_low_half_is_read(inst, data)) {
      old_value = RegState::Undef;
    } else if (!zero || !stays_a_half(*loop.block, *loop.before, data)) {
      return nullptr;
    } else if (!loop.block->isLiveIn(data)) {
      if (any_of(loop.before->successors(),
                 [&](const MachineBasicBlock* next) { return next->isLiveIn(data); }))
        return nullptr;
      stream.zeros.push_back(data);
    }
  }
  MachineInstrBuilder access = BuildMI(*function_, inst.getDebugLoc(), tii_->get(form));
  if (inst.mayLoad())
    access.addDef(data);
  if (steps)
    access.addDef(stream.index);
  if (inst.mayStore())
    access.addReg(data);
  access.addReg(stream.index);
  if (!steps)
    access.addImm(0);
  if (is_half_load(form))
    access.addReg(data, old_value);
  access.cloneMemRefs(inst);
  return access;
}

bool BfinIndexStreams::find_stream(const Loop& loop, MCPhysReg pointer, Stream& stream) {
  stream.pointer = pointer;
  const TargetRegisterInfo* tri = function_->getSubtarget().getRegisterInfo();
  bool steps = false;
  for (MachineInstr& inst : *loop.block) {
    if (!inst.readsRegister(pointer, tri) && !inst.modifiesRegister(pointer, tri))
      continue;
    MachineInstr* access = through_index(inst, loop, stream);
    if (access == nullptr)
      return false;
    steps |= inst.modifiesRegister(pointer, tri);
    stream.accesses.push_back({&inst, access});
  }
  return steps;
}

std::vector<Stream> BfinIndexStreams::streams_of(const Loop& loop) {
  std::vector<Stream> streams;
  for (const MCPhysReg pointer : Bfin::PRegClass) {
    if (streams.size() == kIndexRegisterCount)
      break;
    Stream stream;
    stream.index = kIndexRegisters[streams.size()];
    if (pointer != Bfin::SP && pointer != Bfin::FP && find_stream(loop, pointer, stream))
      streams.push_back(std::move(stream));
    else
      for (const Access& access : stream.accesses)
        function_->deleteMachineInstr(access.other);
  }
  return streams;
}

/// Moves, counted where they stand, against the cycles that the loop saves.
bool BfinIndexStreams::pays(const Loop& loop, const std::vector<Stream>& streams,
                            unsigned saved) const {
  size_t moves = 0;
  for (const Stream& stream : streams)
    moves += 1 + stream.zeros.size() + (loop.after->isLiveIn(stream.pointer) ? 1 : 0);
  const double rounds = frequencies_->getBlockFreqRelativeToEntryBlock(loop.block) /
                        std::max(frequencies_->getBlockFreqRelativeToEntryBlock(loop.before), 1e-6);
  return !streams.empty() && rounds * saved > static_cast<double>(moves);
}

/// The streams that make the loop shorter, now in the block; the others are as they were.
std::vector<Stream> BfinIndexStreams::worth_it(const Loop& loop, std::vector<Stream> streams,
                                               PacketDag& dag) {
  const unsigned before = dag.cycles(*loop.block);
  for (Stream& stream : streams)
    swap(stream);
  const unsigned least = dag.cycles(*loop.block);
  std::vector<Stream> kept;
  for (Stream& stream : streams) {
    swap(stream);
    if (least < before && dag.cycles(*loop.block) == least)
      continue;
    swap(stream);
    kept.push_back(stream);
  }
  if (pays(loop, kept, before - least))
    return kept;
  for (Stream& stream : kept)
    swap(stream);
  return {};
}

void BfinIndexStreams::commit(Loop& loop, const std::vector<Stream>& streams) {
  const bool lives_on =
      any_of(streams, [&](const Stream& stream) { return loop.after->isLiveIn(stream.pointer); });
  if (lives_on && loop.after->pred_size() != 1)
    loop.after = loop.block->SplitCriticalEdge(loop.after, *this);
  const auto entry = loop.before->getFirstTerminator();
  const DebugLoc& loc = streams.front().accesses.front().now->getDebugLoc();
  const auto move = [&](MachineBasicBlock& block, MachineBasicBlock::iterator at, MCPhysReg to,
                        MCPhysReg from) {
    BuildMI(block, at, loc, tii_->get(Bfin::MOV), to).addReg(from);
  };
  for (const Stream& stream : streams) {
    move(*loop.before, entry, stream.index, stream.pointer);
    loop.block->addLiveIn(stream.index);
    for (const MCPhysReg zero : stream.zeros) {
      if (loop.block->isLiveIn(zero))
        continue;
      BuildMI(*loop.before, entry, loc, tii_->get(Bfin::MOVI), zero).addImm(0);
      loop.block->addLiveIn(zero);
    }
    if (loop.after->isLiveIn(stream.pointer)) {
      move(*loop.after, loop.after->begin(), stream.pointer, stream.index);
      loop.after->removeLiveIn(stream.pointer);
      loop.after->addLiveIn(stream.index);
    }
    loop.block->removeLiveIn(stream.pointer);
  }
  loop.block->sortUniqueLiveIns();
}

bool BfinIndexStreams::runOnMachineFunction(MachineFunction& function) {
  if (isInterruptHandler(function.getFunction()))
    return false;
  function_ = &function;
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  frequencies_ = &getAnalysis<MachineBlockFrequencyInfoWrapperPass>().getMBFI();
  PacketDag dag(function, &getAnalysis<MachineLoopInfoWrapperPass>().getLI(),
                &getAnalysis<AAResultsWrapperPass>().getAAResults());
  std::vector<Loop> loops;
  for (MachineBasicBlock& block : function) {
    Loop loop;
    if (find(block, loop))
      loops.push_back(loop);
  }
  bool changed = false;
  for (Loop& loop : loops) {
    std::vector<Stream> streams = streams_of(loop);
    std::vector<Stream> kept = worth_it(loop, streams, dag);
    if (!kept.empty())
      commit(loop, kept);
    changed |= !kept.empty();
    // Of each access one stands in the block, the other nowhere.
    for (Stream& stream : streams)
      for (Access& access : stream.accesses)
        function.deleteMachineInstr(access.now->getParent() == nullptr ? access.now : access.other);
  }
  return changed;
}

}  // namespace

FunctionPass* createBfinIndexStreams() { return new BfinIndexStreams(); }

}  // namespace llvm
