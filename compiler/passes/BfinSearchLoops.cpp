// Loops that go on until they find something (while (*low < pivot) ++low) take several rounds at a
// time, each with its own question: a branch that is not taken costs one cycle, one that is taken
// five.
//
//   loop: A; if c jump loop      loop: A; if !c jump exit; A; if !c jump exit; A; if c jump loop
//
// Works after allocation and block placement: every round keeps its registers, and nothing is
// computed that was not before. Looks at small loops of a few blocks in a row with one way back,
// not at those on a loop counter, nor at those that wait for volatile memory.
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineInstrBuilder.h>
#include <map>

#include "../target/Bfin.hpp"
#include "../target/BfinInstrInfo.hpp"
#include "../target/BfinSubtarget.hpp"

namespace llvm {
namespace {

constexpr size_t kMostBlocks = 3;       // of a round
constexpr unsigned kMostSearched = 30;  // of all rounds together
constexpr unsigned kMostRounds = 4;

/// Blocks in a row; the last one goes back to the first, or on to `exit`.
struct Search {
  std::vector<MachineBasicBlock*> blocks;
  MachineBasicBlock* exit = nullptr;
  SmallVector<MachineOperand, 2> again;  // the condition of going back
  unsigned rounds = 1;
};

class BfinSearchLoops : public MachineFunctionPass {
 public:
  static char ID;
  BfinSearchLoops() : MachineFunctionPass(ID) {}
  StringRef getPassName() const override { return "Blackfin search loops"; }
  bool runOnMachineFunction(MachineFunction& function) override;

 private:
  bool find(MachineBasicBlock& latch, Search& search) const;
  bool find_blocks(MachineBasicBlock& latch, Search& search) const;
  void unroll(const Search& search);
  std::vector<MachineBasicBlock*> copy(const Search& search, MachineBasicBlock* behind);

  MachineFunction* function_ = nullptr;
  const TargetInstrInfo* tii_ = nullptr;
};

char BfinSearchLoops::ID = 0;

bool may_stand_twice(const MachineInstr& inst) {
  const bool known = !inst.isTerminator() || inst.getOpcode() == Bfin::JCC ||
                     inst.getOpcode() == Bfin::JNCC || inst.getOpcode() == Bfin::JUMP;
  return known && !inst.isCall() && !inst.isInlineAsm() && !inst.isPosition() &&
         !inst.hasUnmodeledSideEffects() && !(inst.mayLoadOrStore() && inst.hasOrderedMemoryRef());
}

/// From the latch up to where it leads back to, if nothing else leads in between.
bool BfinSearchLoops::find_blocks(MachineBasicBlock& latch, Search& search) const {
  MachineBasicBlock* taken = nullptr;
  MachineBasicBlock* otherwise = nullptr;
  if (latch.succ_size() != 2 || tii_->analyzeBranch(latch, taken, otherwise, search.again) ||
      search.again.size() != 1 || latch.getFirstTerminator()->getOpcode() == Bfin::LOOPSETUP)
    return false;
  search.exit = otherwise != nullptr ? otherwise : latch.getNextNode();
  for (MachineBasicBlock* block = &latch;; block = block->getPrevNode()) {
    if (block == nullptr || search.blocks.size() == kMostBlocks)
      return false;
    search.blocks.insert(search.blocks.begin(), block);
    if (block == taken)
      break;
  }
  const auto place = [&](const MachineBasicBlock* block) {
    return llvm::find(search.blocks, block) - search.blocks.begin();
  };
  const auto within = [&](const MachineBasicBlock* block) {
    return is_contained(search.blocks, block);
  };
  return search.exit != nullptr && !within(search.exit) &&
         all_of(search.blocks, [&](const MachineBasicBlock* block) {
           return all_of(block->predecessors(), [&](const MachineBasicBlock* from) {
             return block == taken ? !within(from) || from == &latch
                                   : within(from) && place(from) < place(block);
           });
         });
}

bool BfinSearchLoops::find(MachineBasicBlock& latch, Search& search) const {
  if (!find_blocks(latch, search))
    return false;
  unsigned count = 0;
  for (MachineBasicBlock* block : search.blocks) {
    if (block->hasAddressTaken() || block->isEHPad() || !all_of(*block, may_stand_twice))
      return false;
    count += static_cast<unsigned>(
        count_if(*block, [](const MachineInstr& inst) { return !inst.isMetaInstruction(); }));
  }
  search.rounds = std::min(kMostRounds, kMostSearched / std::max(count, 1U));
  return search.rounds > 1;
}

/// One more round, which begins right behind `behind`; its last block still goes back.
std::vector<MachineBasicBlock*> BfinSearchLoops::copy(const Search& search,
                                                      MachineBasicBlock* behind) {
  std::map<const MachineBasicBlock*, MachineBasicBlock*> copies;
  std::vector<MachineBasicBlock*> blocks;
  for (const MachineBasicBlock* block : search.blocks) {
    MachineBasicBlock* own = function_->CreateMachineBasicBlock(block->getBasicBlock());
    function_->insert(std::next(behind->getIterator()), own);
    behind = own;
    copies[block] = own;
    blocks.push_back(own);
  }
  const auto place_of = [&](MachineBasicBlock* block) {
    const auto found = copies.find(block);
    return found == copies.end() || block == search.blocks.front() ? block : found->second;
  };
  for (const MachineBasicBlock* block : search.blocks) {
    MachineBasicBlock* own = copies[block];
    for (const auto& live : block->liveins())
      own->addLiveIn(live);
    for (const MachineInstr& inst : *block) {
      MachineInstr* another = function_->CloneMachineInstr(&inst);
      own->push_back(another);
      for (MachineOperand& operand : another->operands())
        if (operand.isMBB())
          operand.setMBB(place_of(operand.getMBB()));
    }
    for (auto next = block->succ_begin(); next != block->succ_end(); ++next)
      own->addSuccessor(place_of(*next), block->getSuccProbability(next));
  }
  return blocks;
}

void BfinSearchLoops::unroll(const Search& search) {
  MachineBasicBlock* head = search.blocks.front();
  const DebugLoc loc = search.blocks.back()->findBranchDebugLoc();
  // All of them alike first, each of which goes back to the head.
  std::vector<std::vector<MachineBasicBlock*>> rounds = {search.blocks};
  while (rounds.size() < search.rounds)
    rounds.push_back(copy(search, rounds.back().back()));
  SmallVector<MachineOperand, 2> leave = search.again;
  tii_->reverseBranchCondition(leave);
  for (size_t i = 0; i + 1 < rounds.size(); ++i) {
    MachineBasicBlock& latch = *rounds[i].back();
    tii_->removeBranch(latch);
    tii_->insertBranch(latch, search.exit, nullptr, leave, loc);
    latch.replaceSuccessor(head, rounds[i + 1].front());
  }
  MachineBasicBlock& last = *rounds.back().back();
  tii_->removeBranch(last);
  tii_->insertBranch(last, head, last.isLayoutSuccessor(search.exit) ? nullptr : search.exit,
                     search.again, loc);
}

bool BfinSearchLoops::runOnMachineFunction(MachineFunction& function) {
  if (function.getFunction().hasOptSize())
    return false;
  function_ = &function;
  tii_ = function.getSubtarget<BfinSubtarget>().getInstrInfo();
  std::vector<Search> searches;
  for (MachineBasicBlock& block : function) {
    Search search;
    if (find(block, search))
      searches.push_back(std::move(search));
  }
  for (const Search& search : searches)
    unroll(search);
  return !searches.empty();
}

}  // namespace

FunctionPass* createBfinSearchLoops() { return new BfinSearchLoops(); }

}  // namespace llvm
