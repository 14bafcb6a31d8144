// Counters and pointers of a loop that step alike need one register, not two. The strength
// reduction of LLVM gives each use what suits it best, and looks at one loop at a time:
//
//   at a distance:    q = phi(p0 + 4, ..) of an outer loop  ->  q = p + 4
//   row by row:       row = phi(.., row + 32)               ->  row = phi(.., the inner loop's end)
//   behind the loop:  end = base + offset                   ->  end = p, which is the same then
//
// Works on LLVM's IR behind the strength reduction. Pointers that are accessed themselves stay as
// they are in the first case: an access steps its pointer at no cost (BfinSteps).
#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/ScalarEvolution.h>
#include <llvm/Analysis/ScalarEvolutionExpressions.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>
#include <llvm/InitializePasses.h>
#include <llvm/Pass.h>
#include <llvm/Transforms/Utils/Local.h>
#include <llvm/Transforms/Utils/ScalarEvolutionExpander.h>

#include "../target/Bfin.hpp"

namespace llvm {
namespace {

/// A value that grows by the same in each round of its loop.
struct Counter {
  PHINode* phi;
  Instruction* next;
};

/// Strikes out each counter for which another one was found that stands for it.
bool join(std::vector<Counter>& counters,
          function_ref<bool(const Counter& counter, const Counter& other)> stands_for) {
  bool changed = false;
  for (size_t i = 0; i < counters.size();) {
    const Counter counter = counters[i];
    const bool joined = any_of(counters, [&](const Counter& other) {
      return other.phi != counter.phi && stands_for(counter, other);
    });
    changed |= joined;
    if (joined)
      counters.erase(counters.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return changed;
}

class BfinSameSteps : public FunctionPass {
 public:
  static char ID;
  BfinSameSteps() : FunctionPass(ID) {
    initializeLoopInfoWrapperPassPass(*PassRegistry::getPassRegistry());
    initializeScalarEvolutionWrapperPassPass(*PassRegistry::getPassRegistry());
    initializeDominatorTreeWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin same steps"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<LoopInfoWrapperPass>();
    usage.addRequired<ScalarEvolutionWrapperPass>();
    usage.addRequired<DominatorTreeWrapperPass>();
    usage.setPreservesCFG();
  }
  bool runOnFunction(Function& function) override;

 private:
  std::vector<Counter> counters_of(const Loop& loop) const;
  const SCEV* number_of(Value* value) const;
  const SCEV* rest_of(Instruction& value, Instruction& held, const Loop& loop,
                      bool& taken_off) const;
  bool read_behind(const Counter& counter, const Counter& other, const Loop& loop);
  bool join_behind(const Loop& loop, std::vector<Counter>& counters);
  bool join_with_inner(const Loop& outer, std::vector<Counter>& counters);
  bool read_at_distance(const Counter& counter, const Counter& other);
  bool join_at_distance(std::vector<Counter>& counters);

  ScalarEvolution* scev_ = nullptr;
  const DominatorTree* dominators_ = nullptr;
};

char BfinSameSteps::ID = 0;

/// Addresses as numbers; null where nothing is known.
const SCEV* BfinSameSteps::number_of(Value* value) const {
  if (!scev_->isSCEVable(value->getType()))
    return nullptr;
  const SCEV* known = scev_->getSCEV(value);
  if (!known->getType()->isPointerTy())
    return known->getType()->isIntegerTy(32) ? known : nullptr;
  known = scev_->getLosslessPtrToIntExpr(known);
  return isa<SCEVCouldNotCompute>(known) ? nullptr : known;
}

std::vector<Counter> BfinSameSteps::counters_of(const Loop& loop) const {
  std::vector<Counter> counters;
  const BasicBlock* latch = loop.getLoopLatch();
  if (latch == nullptr || loop.getLoopPreheader() == nullptr)
    return counters;
  for (PHINode& phi : loop.getHeader()->phis()) {
    auto* next = dyn_cast<Instruction>(phi.getIncomingValueForBlock(latch));
    const auto* steps = dyn_cast_or_null<SCEVAddRecExpr>(number_of(&phi));
    if (next != nullptr && loop.contains(next) && steps != nullptr && steps->getLoop() == &loop &&
        steps->isAffine())
      counters.push_back({&phi, next});
  }
  return counters;
}

/// How `value`, behind the loop, can be computed from what `held` then is: as held + rest, or as
/// rest - held. Null: not, or not at little cost.
const SCEV* BfinSameSteps::rest_of(Instruction& value, Instruction& held, const Loop& loop,
                                   bool& taken_off) const {
  constexpr unsigned short kMostTerms = 6;
  const SCEV* wanted = isa<PHINode>(value) ? nullptr : number_of(&value);
  if (wanted == nullptr || !dominators_->dominates(&held, &value))
    return nullptr;
  for (const bool off : {false, true}) {
    const SCEV* known = number_of(&held);
    const SCEV* rest = off ? scev_->getAddExpr(wanted, known) : scev_->getMinusSCEV(wanted, known);
    SCEVExpander expander(*scev_, value.getModule()->getDataLayout(), "rest");
    if (!scev_->isLoopInvariant(rest, &loop) || rest->getExpressionSize() > kMostTerms ||
        !expander.isSafeToExpandAt(rest, &value))
      continue;
    taken_off = off;
    return rest;
  }
  return nullptr;
}

/// A counter that only code behind the loop reads is what another one says, and something.
bool BfinSameSteps::read_behind(const Counter& counter, const Counter& other, const Loop& loop) {
  struct Place {
    Instruction* value;
    const SCEV* rest;
    bool taken_off;
  };
  const auto is_behind = [&](const User* user) { return !loop.contains(cast<Instruction>(user)); };
  Instruction* held =
      any_of(other.next->users(), is_behind) || none_of(other.phi->users(), is_behind) ? other.next
                                                                                       : other.phi;
  std::vector<Place> places;
  for (const Instruction* end : {static_cast<const Instruction*>(counter.phi),
                                 static_cast<const Instruction*>(counter.next)})
    for (const User* user : end->users()) {
      auto* value = const_cast<Instruction*>(cast<Instruction>(user));
      if (value == counter.phi || value == counter.next)
        continue;
      Place place{value, nullptr, false};
      if (is_behind(user))
        place.rest = rest_of(*value, *held, loop, place.taken_off);
      if (place.rest == nullptr)
        return false;
      places.push_back(place);
    }
  other.next->dropPoisonGeneratingFlags();
  SmallVector<WeakTrackingVH, 4> dead;
  for (const Place& place : places) {
    IRBuilder<> builder(place.value);
    SCEVExpander expander(*scev_, place.value->getModule()->getDataLayout(), "rest");
    Value* rest = expander.expandCodeFor(place.rest, builder.getInt32Ty(), place.value);
    Value* number = builder.CreateBitOrPointerCast(held, builder.getInt32Ty());
    number = place.taken_off ? builder.CreateSub(rest, number) : builder.CreateAdd(number, rest);
    scev_->forgetValue(place.value);
    place.value->replaceAllUsesWith(builder.CreateBitOrPointerCast(number, place.value->getType()));
    dead.emplace_back(place.value);
  }
  RecursivelyDeleteTriviallyDeadInstructionsPermissive(dead);
  return !places.empty();
}

bool BfinSameSteps::join_behind(const Loop& loop, std::vector<Counter>& counters) {
  return join(counters, [&](const Counter& counter, const Counter& other) {
    return read_behind(counter, other, loop);
  });
}

/// Whether something is loaded from or stored to where `value` points.
bool is_accessed(const Value& value) {
  return any_of(value.users(), [&](const User* user) {
    const Value* address = getLoadStorePointerOperand(user);
    return address == &value ||
           (isa<GetElementPtrInst>(user) && any_of(user->users(), [&](const User* access) {
              return getLoadStorePointerOperand(access) == user;
            }));
  });
}

/// Whether a counter was computed from another one, at a small distance from it, in each round.
bool BfinSameSteps::read_at_distance(const Counter& counter, const Counter& other) {
  const auto* apart =
      dyn_cast<SCEVConstant>(scev_->getMinusSCEV(number_of(counter.phi), number_of(other.phi)));
  if (is_accessed(*counter.phi) || is_accessed(*counter.next) || apart == nullptr ||
      !apart->getAPInt().isSignedIntN(7) || other.phi->getType() != counter.phi->getType())
    return false;
  other.next->dropPoisonGeneratingFlags();
  IRBuilder<> builder(&*counter.phi->getParent()->getFirstInsertionPt());
  Value* same = counter.phi->getType()->isPointerTy()
                    ? builder.CreatePtrAdd(other.phi, apart->getValue())
                    : builder.CreateAdd(other.phi, apart->getValue());
  scev_->forgetValue(counter.phi);
  counter.phi->replaceAllUsesWith(same);
  return true;
}

bool BfinSameSteps::join_at_distance(std::vector<Counter>& counters) {
  return join(counters, [&](const Counter& counter, const Counter& other) {
    return read_at_distance(counter, other);
  });
}

/// An outer counter that an inner one begins with, and that goes on where the inner one ends, is
/// the same: rows that lie one behind the other.
bool BfinSameSteps::join_with_inner(const Loop& outer, std::vector<Counter>& counters) {
  bool changed = false;
  for (const Loop* inner : outer)
    for (const Counter& counter : counters_of(*inner)) {
      auto* start =
          dyn_cast<PHINode>(counter.phi->getIncomingValueForBlock(inner->getLoopPreheader()));
      const auto begun = find_if(counters, [&](const Counter& one) { return one.phi == start; });
      if (start == nullptr || begun == counters.end() || !start->hasNUses(2) ||
          !begun->next->hasOneUse() ||
          !dominators_->dominates(counter.next, outer.getLoopLatch()->getTerminator()) ||
          counter.next->getType() != start->getType() ||
          scev_->getSCEVAtScope(scev_->getSCEV(counter.next), &outer) !=
              scev_->getSCEV(begun->next))
        continue;
      counter.next->dropPoisonGeneratingFlags();
      scev_->forgetValue(start);
      Instruction* old = begun->next;
      start->replaceUsesOfWith(old, counter.next);
      RecursivelyDeleteTriviallyDeadInstructions(old);
      counters.erase(begun);
      changed = true;
    }
  return changed;
}

bool BfinSameSteps::runOnFunction(Function&) {
  scev_ = &getAnalysis<ScalarEvolutionWrapperPass>().getSE();
  dominators_ = &getAnalysis<DominatorTreeWrapperPass>().getDomTree();
  bool changed = false;
  for (const Loop* loop : getAnalysis<LoopInfoWrapperPass>().getLoopInfo().getLoopsInPreorder()) {
    std::vector<Counter> counters = counters_of(*loop);
    changed |= join_behind(*loop, counters);
    if (!loop->isInnermost()) {
      changed |= join_with_inner(*loop, counters);
      changed |= join_at_distance(counters);
    }
    SmallVector<WeakTrackingVH, 8> phis;
    for (PHINode& phi : loop->getHeader()->phis())
      phis.emplace_back(&phi);
    for (const WeakTrackingVH& phi : phis)
      if (phi)
        changed |= RecursivelyDeleteDeadPHINode(cast<PHINode>(phi));
  }
  return changed;
}

}  // namespace

FunctionPass* createBfinSameSteps() { return new BfinSameSteps(); }

}  // namespace llvm
