#include "JamProducts.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>
#include <llvm/Transforms/Utils/BasicBlockUtils.h>
#include <llvm/Transforms/Utils/Local.h>
#include <llvm/Transforms/Utils/LoopSimplify.h>
#include <llvm/Transforms/Utils/LoopUtils.h>
#include <llvm/Transforms/Utils/ScalarEvolutionExpander.h>
#include <llvm/Transforms/Utils/UnrollLoop.h>

#include "Alignment.hpp"
#include "LoopCopy.hpp"
#include "PairProducts.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;

constexpr unsigned kLeastOuterRounds = 4;  // fewer are not worth the tests

/// What a nest needs for its fast copy.
struct Nest {
  const ProductLoop& products;
  Loop* outer;
  BranchInst* guard = nullptr;  // goes around the inner loop, by a condition from outside
  SmallVector<const SCEV*, 4> aligned;
};

/// Is the factor of the next round of the outer loop the half behind the one of this round? Its
/// start becomes that of the first round.
bool moves_by_halves(Factor& factor, const Loop& outer, ScalarEvolution& scev) {
  const auto* start = dyn_cast<SCEVAddRecExpr>(factor.start);
  if (start == nullptr || start->getLoop() != &outer || !start->isAffine() ||
      !scev.isLoopInvariant(factor.step, &outer))
    return false;
  const auto* step = dyn_cast<SCEVConstant>(start->getStepRecurrence(scev));
  factor.start = start->getStart();
  return step != nullptr && step->getAPInt() == 2;
}

bool shares_factor(Nest& nest, ScalarEvolution& scev) {
  for (const unsigned i : {0U, 1U}) {
    const Factor& shared = nest.products.sums[0].factors[i];
    Factor own = nest.products.sums[0].factors[1 - i];
    if (!scev.isLoopInvariant(shared.start, nest.outer) ||
        !scev.isLoopInvariant(shared.step, nest.outer) || !moves_by_halves(own, *nest.outer, scev))
      continue;
    const bool sliding = goes_by_halves(own);
    if (sliding && !goes_by_halves(shared))
      continue;
    if (goes_by_halves(shared))
      nest.aligned.push_back(shared.start);
    if (!sliding) {
      nest.aligned.push_back(own.start);
      nest.aligned.push_back(own.step);
    }
    return none_of(nest.aligned, [&](const SCEV* value) {
      const auto* constant = dyn_cast<SCEVConstant>(value);
      return constant != nullptr && constant->getAPInt().countr_zero() < 2;
    });
  }
  return false;
}

/// One way through the nest: what lies before the inner loop, it, one block behind it; and perhaps
/// a branch around it.
bool has_simple_form(Nest& nest) {
  Loop& outer = *nest.outer;
  const Loop& inner = *nest.products.loop;
  if (!outer.isLoopSimplifyForm() || outer.getSubLoops().size() != 1 ||
      outer.getExitingBlock() != outer.getLoopLatch() || outer.getExitBlock() == nullptr)
    return false;
  const BasicBlock* latch = outer.getLoopLatch();
  const BasicBlock* behind = inner.getExitBlock();
  if (behind != latch && behind->getSingleSuccessor() != latch)
    return false;
  for (BasicBlock* block : outer.blocks()) {
    auto* branch = dyn_cast<BranchInst>(block->getTerminator());
    if (branch == nullptr)
      return false;
    if (block == latch || block == inner.getHeader() || branch->isUnconditional())
      continue;
    const bool goes_around = branch->getSuccessor(0) == latch || branch->getSuccessor(1) == latch;
    if (nest.guard != nullptr || !goes_around || !outer.isLoopInvariant(branch->getCondition()))
      return false;
    nest.guard = branch;
  }
  return true;
}

/// Stores only behind the inner loop, to where nothing before them is loaded from.
bool may_jam_memory(const Nest& nest, AAResults& aliases) {
  const BasicBlock* latch = nest.outer->getLoopLatch();
  const BasicBlock* behind = nest.products.loop->getExitBlock();
  SmallVector<const StoreInst*, 4> stores;
  SmallVector<const LoadInst*, 4> loads;
  for (const BasicBlock* block : nest.outer->blocks())
    for (const Instruction& inst : *block) {
      const bool last = block == latch || block == behind;
      const auto* store = dyn_cast<StoreInst>(&inst);
      const auto* load = dyn_cast<LoadInst>(&inst);
      if (store != nullptr && store->isSimple() && last)
        stores.push_back(store);
      else if (load != nullptr && load->isSimple())
        loads.append(last ? 0 : 1, load);
      else if (inst.mayHaveSideEffects() || inst.mayReadFromMemory())
        return false;
    }
  return all_of(stores, [&](const StoreInst* store) {
    return all_of(loads, [&](const LoadInst* load) {
      return aliases.isNoAlias(MemoryLocation::getBeforeOrAfter(store->getPointerOperand()),
                               MemoryLocation::getBeforeOrAfter(load->getPointerOperand()));
    });
  });
}

bool can_jam(Nest& nest, const NestAnalyses& analyses) {
  ScalarEvolution& scev = analyses.scev;
  if (nest.products.sums.size() != 1 || !has_simple_form(nest) || !shares_factor(nest, scev) ||
      !scev.isLoopInvariant(nest.products.rounds, nest.outer) ||
      !scev.hasLoopInvariantBackedgeTakenCount(nest.outer) ||
      !may_jam_memory(nest, analyses.aliases))
    return false;
  const unsigned known = scev.getSmallConstantTripCount(nest.outer);
  if (known != 0 && known < kLeastOuterRounds)
    return false;
  for (PHINode& phi : nest.outer->getHeader()->phis()) {
    const auto* steps = dyn_cast<SCEVAddRecExpr>(scev.getSCEV(&phi));
    if (steps == nullptr || steps->getLoop() != nest.outer || !steps->isAffine())
      return false;
  }
  SmallVector<const SCEV*, 4> wanted = nest.aligned;
  wanted.push_back(nest.products.rounds);
  return can_expand(wanted, scev, nest.outer->getLoopPreheader()->getTerminator());
}

/// A copy of the nest, reached where the tests allow. The guard has said yes there.
Loop* add_fast_copy(const Nest& nest, const NestAnalyses& analyses, ValueToValueMapTy& map) {
  const LoopCopy fast = copy_beside(*nest.outer, ".jam", analyses.loops, analyses.dominators, map);
  Instruction* at = fast.before_both;
  align_objects(nest.aligned, analyses.scev);
  Value* test =
      write_test(nest.products.rounds, kLeastPairedRounds, nest.aligned, analyses.scev, at);
  IRBuilder<> builder(at);
  if (nest.guard != nullptr) {
    const bool around = nest.guard->getSuccessor(0) == nest.outer->getLoopLatch();
    Value* condition = nest.guard->getCondition();
    test = builder.CreateLogicalAnd(around ? builder.CreateNot(condition) : condition, test);
    auto* copied = cast<BranchInst>(&*map[nest.guard]);
    BasicBlock* left_out = copied->getSuccessor(around ? 0 : 1);
    left_out->removePredecessor(copied->getParent(), /*KeepOneInputPHIs=*/true);
    BranchInst::Create(copied->getSuccessor(around ? 1 : 0), copied->getIterator());
    copied->eraseFromParent();
  }
  builder.CreateCondBr(test, fast.preheader, fast.preheader_of_original);
  at->eraseFromParent();
  return fast.loop;
}

/// The form that jamming wants.
void tidy(Loop& fast, const NestAnalyses& analyses) {
  analyses.dominators.recalculate(*fast.getHeader()->getParent());
  Loop* inner = fast.getSubLoops()[0];
  BasicBlock* behind = inner->getExitBlock();
  if (behind != fast.getLoopLatch())
    MergeBlockIntoPredecessor(fast.getLoopLatch(), nullptr, &analyses.loops);
  analyses.dominators.recalculate(*fast.getHeader()->getParent());
  analyses.scev.forgetAllLoops();
  simplifyLoop(&fast, &analyses.dominators, &analyses.loops, &analyses.scev, &analyses.assumptions,
               nullptr, false);
  formLCSSARecursively(fast, analyses.dominators, &analyses.loops, &analyses.scev);
}

/// Addresses behind the inner loop step from round to round; those that lie at a known distance
/// from one before are written so.
void write_as_neighbours(BasicBlock& block, ScalarEvolution& scev) {
  SCEVExpander expander(scev, block.getModule()->getDataLayout(), "behind");
  expander.disableCanonicalMode();
  SmallVector<Value*, 4> bases;
  for (Instruction& inst : block) {
    Value* address = getLoadStorePointerOperand(&inst);
    if (address == nullptr)
      continue;
    const SCEV* own = scev.getSCEV(address);
    const auto base = find_if(bases, [&](Value* other) {
      return isa<SCEVConstant>(scev.getMinusSCEV(own, scev.getSCEV(other)));
    });
    Value* better = nullptr;
    if (base == bases.end()) {
      if (expander.isSafeToExpandAt(own, &inst))
        better = expander.expandCodeFor(own, address->getType(), &inst);
      bases.push_back(better == nullptr ? address : better);
    } else {
      const auto* distance = cast<SCEVConstant>(scev.getMinusSCEV(own, scev.getSCEV(*base)));
      better =
          distance->isZero() ? *base : IRBuilder<>(&inst).CreatePtrAdd(*base, distance->getValue());
    }
    if (better == nullptr || better == address)
      continue;
    inst.setOperand(isa<StoreInst>(inst) ? 1 : 0, better);
    RecursivelyDeleteTriviallyDeadInstructions(address);
  }
}

}  // namespace

std::optional<JammedNest> jam_products(const ProductLoop& products, const NestAnalyses& analyses) {
  Nest nest{products, products.loop->getParentLoop(), nullptr, {}};
  if (nest.outer == nullptr || !can_jam(nest, analyses))
    return std::nullopt;
  ValueToValueMapTy map;
  Loop* fast = add_fast_copy(nest, analyses, map);
  tidy(*fast, analyses);
  Loop* inner = fast->getSubLoops()[0];
  ScalarEvolution& scev = analyses.scev;
  if (isSafeToUnrollAndJam(fast, scev, analyses.dominators, analyses.dependences, analyses.loops)) {
    UnrollAndJamLoop(fast, 2, scev.getSmallConstantTripCount(fast),
                     scev.getSmallConstantTripMultiple(fast), false, &analyses.loops, &scev,
                     &analyses.dominators, &analyses.assumptions, &analyses.target,
                     &analyses.remarks);
    scev.forgetAllLoops();
    write_as_neighbours(*inner->getExitBlock(), scev);
  }
  return JammedNest{inner, nest.aligned};
}

}  // namespace finback::compiler
