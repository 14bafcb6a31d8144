#include "PairedLoop.hpp"

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/ScalarEvolutionExpressions.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>
#include <llvm/IR/PatternMatch.h>
#include <llvm/Transforms/Utils/BasicBlockUtils.h>
#include <llvm/Transforms/Utils/Cloning.h>
#include <llvm/Transforms/Utils/ScalarEvolutionExpander.h>

#include "Alignment.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;
using namespace PatternMatch;

constexpr unsigned kLeastCount = 8;  // fewer elements are sooner done one by one
constexpr uint32_t kWordBytes = 4;

bool is_pair(const Type* type) {
  const auto* vector = dyn_cast<FixedVectorType>(type);
  return vector != nullptr && vector->getNumElements() == 2 &&
         vector->getElementType()->isIntegerTy(16);
}

/// The first of the branches in front of the vectorised loop that lead past it, all to one block.
BranchInst* way_past(const Loop& loop) {
  BranchInst* first = nullptr;
  const BasicBlock* past = nullptr;
  const BasicBlock* block = loop.getLoopPreheader();
  while (const BasicBlock* before = block == nullptr ? nullptr : block->getSinglePredecessor()) {
    auto* branch = dyn_cast<BranchInst>(const_cast<Instruction*>(before->getTerminator()));
    if (branch == nullptr || !branch->isConditional() || branch->getSuccessor(1) != block ||
        (past != nullptr && branch->getSuccessor(0) != past))
      break;
    past = branch->getSuccessor(0);
    first = branch;
    block = before;
  }
  return first;
}

/// What must be multiples of 4 for `start` to be one in each round of all loops around: what every
/// round of a loop answers alike is asked in front of it.
void add_parts(const SCEV* start, ScalarEvolution& scev, SmallVectorImpl<const SCEV*>& parts) {
  const auto add = [&](const SCEV* part) {
    if (!is_aligned(part, scev) && !is_contained(parts, part))
      parts.push_back(part);
  };
  while (const auto* steps = dyn_cast<SCEVAddRecExpr>(start)) {
    if (!steps->isAffine())
      break;
    add(steps->getStepRecurrence(scev));
    start = steps->getStart();
  }
  add(start);
}

/// The vectoriser's own question before the loop is whether there is one round.
void ask_for_more_rounds(BranchInst& branch) {
  Value* count = nullptr;
  ICmpInst::Predicate predicate{};
  if (match(branch.getCondition(), m_ICmp(predicate, m_Value(count), m_SpecificInt(2))) &&
      predicate == ICmpInst::ICMP_ULT)
    branch.setCondition(
        IRBuilder<>(&branch).CreateICmpULT(count, ConstantInt::get(count->getType(), kLeastCount)));
}

// One access of the vectorised loop: two halves, whose address grows by a word a round.
struct PairAccess {
  Instruction* inst;
  const SCEV* start;
};

/// All accesses of pairs, in their order; none where one is another kind.
SmallVector<PairAccess, 8> accesses_of(const Loop& loop, ScalarEvolution& scev) {
  SmallVector<PairAccess, 8> accesses;
  for (Instruction& inst : *loop.getHeader()) {
    if (!(isa<LoadInst>(inst) || isa<StoreInst>(inst)) || !is_pair(getLoadStoreType(&inst)))
      continue;
    const auto* steps = dyn_cast<SCEVAddRecExpr>(
        scev.getSCEV(const_cast<Value*>(getLoadStorePointerOperand(&inst))));
    const auto* step =
        steps == nullptr ? nullptr : dyn_cast<SCEVConstant>(steps->getStepRecurrence(scev));
    if (step == nullptr || steps->getLoop() != &loop || step->getAPInt() != kWordBytes)
      return {};
    accesses.push_back({&inst, steps->getStart()});
  }
  return accesses;
}

unsigned address_operand(const Instruction& access) { return isa<LoadInst>(access) ? 0 : 1; }

/// Each array has a pointer of its own, which goes on behind the loop. Returns where it is then,
/// for each access.
SmallVector<Value*, 8> write_pointers(const Loop& loop, ArrayRef<PairAccess> accesses,
                                      ScalarEvolution& scev) {
  BasicBlock* body = loop.getHeader();
  BasicBlock* behind = loop.getExitBlock();
  SCEVExpander expander(scev, body->getModule()->getDataLayout(), "pairs");
  expander.disableCanonicalMode();  // rows begin where a pointer of their own is, without a product
  DenseMap<const SCEV*, std::pair<PHINode*, PHINode*>> pointers;
  SmallVector<Value*, 8> ends;
  for (const PairAccess& access : accesses) {
    auto& [pointer, end] = pointers[access.start];
    if (pointer == nullptr) {
      Value* first = expander.expandCodeFor(access.start, access.start->getType(),
                                            loop.getLoopPreheader()->getTerminator());
      IRBuilder<> builder(body, body->begin());
      pointer = builder.CreatePHI(first->getType(), 2);
      builder.SetInsertPoint(body->getTerminator());
      Value* next = builder.CreatePtrAdd(pointer, builder.getInt32(kWordBytes));
      pointer->addIncoming(first, loop.getLoopPreheader());
      pointer->addIncoming(next, body);
      builder.SetInsertPoint(behind, behind->begin());
      end = builder.CreatePHI(first->getType(), 1);
      end->addIncoming(next, body);
    }
    access.inst->setOperand(address_operand(*access.inst), pointer);
    ends.push_back(end);
  }
  return ends;
}

/// The loop as it was, behind `past`; null where the vectorised one is shaped otherwise than known.
BasicBlock* single_loop(const Loop& loop, const BasicBlock& past) {
  const BasicBlock* behind = loop.getExitBlock();
  const auto* whether = behind == nullptr ? nullptr : dyn_cast<BranchInst>(behind->getTerminator());
  auto* body = const_cast<BasicBlock*>(past.getSingleSuccessor());
  if (whether == nullptr || !whether->isConditional() || whether->getSuccessor(1) != &past ||
      body == nullptr || !is_contained(successors(body), body) ||
      !is_contained(successors(body), whether->getSuccessor(0)))
    return nullptr;
  return body;
}

/// The element that an odd count leaves over has code of its own behind the vectorised loop, at the
/// addresses `ends`, so that the loop as it was begins where it always did.
void write_last_element(const Loop& loop, BasicBlock& past, BasicBlock& body,
                        ArrayRef<Value*> ends) {
  BasicBlock* behind = loop.getExitBlock();
  auto* whether = cast<BranchInst>(behind->getTerminator());
  BasicBlock* exit = whether->getSuccessor(0);
  ValueToValueMapTy values;
  BasicBlock* last = CloneBasicBlock(&body, values, ".last", body.getParent());
  for (PHINode& phi : body.phis()) {
    Value* first = phi.getIncomingValueForBlock(&past);
    auto* start = dyn_cast<PHINode>(first);
    const bool resumes = start != nullptr && start->getParent() == &past;
    cast<Instruction>(values[&phi])->eraseFromParent();
    values[&phi] = resumes ? start->getIncomingValueForBlock(behind) : first;
  }
  last->getTerminator()->eraseFromParent();
  remapInstructionsInBlocks({last}, values);
  BranchInst::Create(exit, last);
  for (PHINode& phi : exit->phis()) {
    Value* value = phi.getIncomingValueForBlock(&body);
    Value* here = values.lookup(value);
    phi.addIncoming(here == nullptr ? value : here, last);
  }
  const Value* const* end = ends.begin();
  for (Instruction& inst : *last)
    if (isa<LoadInst>(inst) || isa<StoreInst>(inst))
      inst.setOperand(address_operand(inst), const_cast<Value*>(*end++));
  past.removePredecessor(behind, true);
  whether->setSuccessor(1, last);
}

/// Counts rounds instead of elements, which takes fewer registers, and asks for an odd count by its
/// low bit.
void write_count(const Loop& loop) {
  BasicBlock* body = loop.getHeader();
  auto* back = cast<BranchInst>(body->getTerminator());
  auto* whether = cast<BranchInst>(loop.getExitBlock()->getTerminator());
  Value* limit = nullptr;
  Value* count = nullptr;
  if (!match(back->getCondition(), m_SpecificICmp(ICmpInst::ICMP_EQ, m_Value(), m_Value(limit))) ||
      !match(limit, m_Sub(m_Value(count), m_URem(m_Deferred(count), m_SpecificInt(2)))) ||
      back->getSuccessor(1) != body)
    return;
  Type* type = count->getType();
  IRBuilder<> builder(loop.getLoopPreheader()->getTerminator());
  Value* rounds = builder.CreateLShr(count, 1);
  builder.SetInsertPoint(body, body->begin());
  PHINode* round = builder.CreatePHI(type, 2);
  builder.SetInsertPoint(back);
  Value* next = builder.CreateNUWAdd(round, ConstantInt::get(type, 1));
  round->addIncoming(ConstantInt::get(type, 0), loop.getLoopPreheader());
  round->addIncoming(next, body);
  back->setCondition(builder.CreateICmpEQ(next, rounds));
  builder.SetInsertPoint(whether);
  Value* odd = builder.CreateAnd(count, ConstantInt::get(type, 1));
  whether->setCondition(builder.CreateICmpEQ(odd, ConstantInt::get(type, 0)));
  DeleteDeadPHIs(body);
}

/// Are these, in the loop as it was, the same accesses in the same order?
bool are_accesses_of(ArrayRef<PairAccess> accesses, const BasicBlock& body) {
  SmallVector<unsigned, 8> wanted;
  SmallVector<unsigned, 8> found;
  for (const PairAccess& access : accesses)
    wanted.push_back(access.inst->getOpcode());
  for (const Instruction& inst : body)
    if (isa<LoadInst>(inst) || isa<StoreInst>(inst))
      found.push_back(inst.getOpcode());
  return wanted == found;
}

}  // namespace

bool finish_paired_loop(const Loop& loop, ScalarEvolution& scev) {
  const SmallVector<PairAccess, 8> accesses = accesses_of(loop, scev);
  BranchInst* branch = way_past(loop);
  if (accesses.empty() || branch == nullptr)
    return false;
  SmallVector<const SCEV*, 8> starts;
  for (const PairAccess& access : accesses)
    starts.push_back(access.start);
  align_objects(starts, scev);
  SmallVector<const SCEV*, 8> parts;
  for (const SCEV* start : starts)
    add_parts(start, scev, parts);
  if (!can_expand(parts, scev, branch))
    return false;
  ask_for_more_rounds(*branch);
  Value* aligned = write_alignment_test(parts, scev, branch);
  IRBuilder<> builder(branch);
  branch->setCondition(builder.CreateOr(branch->getCondition(), builder.CreateNot(aligned)));
  for (const PairAccess& access : accesses)
    if (auto* load = dyn_cast<LoadInst>(access.inst))
      load->setAlignment(Align(kWordBytes));
    else
      cast<StoreInst>(access.inst)->setAlignment(Align(kWordBytes));
  BasicBlock& past = *branch->getSuccessor(0);
  BasicBlock* body = single_loop(loop, past);
  if (body != nullptr && are_accesses_of(accesses, *body) &&
      can_expand(starts, scev, loop.getLoopPreheader()->getTerminator())) {
    write_last_element(loop, past, *body, write_pointers(loop, accesses, scev));
    write_count(loop);
  }
  return true;
}

}  // namespace finback::compiler
