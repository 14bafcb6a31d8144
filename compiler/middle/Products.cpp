#include "Products.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/Transforms/Utils/BasicBlockUtils.h>
#include <llvm/Transforms/Utils/LoopSimplify.h>
#include <llvm/Transforms/Utils/LoopUtils.h>

#include "../target/BfinMachineFunctionInfo.hpp"
#include "Alignment.hpp"
#include "JamProducts.hpp"
#include "PairProducts.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;

constexpr unsigned kLeastRounds = 8;  // fewer are not worth the tests

using Heads = SmallPtrSet<const BasicBlock*, 8>;

/// Leads from `from`, the loop's way in, through the paired loop to where the loop leads. A null
/// test: always; the loop itself goes.
void pair(const PairPlan& plan, ScalarEvolution& scev, Value* test) {
  const Loop& loop = *plan.products.loop;
  BasicBlock* before = loop.getLoopPreheader();
  BasicBlock* head = loop.getHeader();
  BasicBlock* exit = loop.getExitBlock();
  BasicBlock* fast =
      BasicBlock::Create(head->getContext(), "pairs.before", head->getParent(), head);
  const PairedSums paired = write_pairs(plan, scev, fast);
  BranchInst::Create(exit, paired.end);
  for (PHINode& phi : exit->phis()) {
    Value* value = phi.getIncomingValueForBlock(head);
    for (const auto& [sum, result] : zip(plan.products.sums, paired.values))
      if (value == sum.next)
        value = result;
    phi.addIncoming(value, paired.end);
  }
  before->getTerminator()->eraseFromParent();
  IRBuilder<> builder(before);
  if (test != nullptr) {
    builder.CreateCondBr(test, fast, head);
    return;
  }
  builder.CreateBr(fast);
  DeleteDeadBlock(head);
}

bool pair_under_test(const ProductLoop& products, ScalarEvolution& scev) {
  const std::optional<PairPlan> plan = plan_pairs(products, scev);
  const unsigned most = scev.getSmallConstantMaxTripCount(products.loop);
  if (!plan || (most != 0 && most < kLeastRounds))
    return false;
  Instruction* at = products.loop->getLoopPreheader()->getTerminator();
  SmallVector<const SCEV*, 8> wanted(plan->aligned.begin(), plan->aligned.end());
  wanted.append(
      {products.rounds, plan->own.start, plan->own.step, plan->shared.start, plan->shared.step});
  if (!can_expand(wanted, scev, at))
    return false;
  align_objects(plan->aligned, scev);
  pair(*plan, scev, write_test(products.rounds, kLeastPairedRounds, plan->aligned, scev, at));
  return true;
}

/// The jammed loop, where its words are known to be aligned.
void pair_jammed(const JammedNest& nest, ScalarEvolution& scev) {
  const std::optional<ProductLoop> products = match_product_loop(*nest.inner, scev);
  if (!products || products->sums.size() != 2)
    return;
  const std::optional<PairPlan> plan = plan_pairs(*products, scev);
  const auto is_known = [&](const SCEV* value) {
    // Two halves further in each round of the outer loop.
    const auto* steps = dyn_cast<SCEVAddRecExpr>(value);
    if (steps != nullptr && steps->getLoop() == nest.inner->getParentLoop() &&
        is_aligned(steps->getStepRecurrence(scev), scev))
      value = steps->getStart();
    return is_aligned(value, scev) || is_contained(nest.aligned, value);
  };
  if (plan && all_of(plan->aligned, is_known))
    pair(*plan, scev, nullptr);
}

/// One loop or nest. True: something was changed; `jammed`: a nest was.
bool visit(Loop& loop, const NestAnalyses& analyses, Heads& done, bool& jammed) {
  done.insert(loop.getHeader());
  const std::optional<ProductLoop> products = match_product_loop(loop, analyses.scev);
  if (!products)
    return false;
  Heads before;
  for (const Loop* other : analyses.loops.getLoopsInPreorder())
    before.insert(other->getHeader());
  const std::optional<JammedNest> nest = jam_products(*products, analyses);
  if (!nest)
    return pair_under_test(*products, analyses.scev);
  jammed = true;
  // An odd round at the end, and the copy itself.
  for (const Loop* other : analyses.loops.getLoopsInPreorder())
    if (!before.contains(other->getHeader()))
      done.insert(other->getHeader());
  pair_jammed(*nest, analyses.scev);
  return true;
}

bool visit_one(Function& function, FunctionAnalysisManager& manager, Heads& done, bool& jammed) {
  auto& loops = manager.getResult<LoopAnalysis>(function);
  auto& dominators = manager.getResult<DominatorTreeAnalysis>(function);
  auto& scev = manager.getResult<ScalarEvolutionAnalysis>(function);
  auto& assumptions = manager.getResult<AssumptionAnalysis>(function);
  const NestAnalyses analyses{loops,
                              scev,
                              dominators,
                              assumptions,
                              manager.getResult<AAManager>(function),
                              manager.getResult<DependenceAnalysis>(function),
                              manager.getResult<TargetIRAnalysis>(function),
                              manager.getResult<OptimizationRemarkEmitterAnalysis>(function)};
  for (Loop* loop : loops) {
    simplifyLoop(loop, &dominators, &loops, &scev, &assumptions, nullptr, false);
    formLCSSARecursively(*loop, dominators, &loops, &scev);
  }
  for (Loop* loop : loops.getLoopsInPreorder())
    if (loop->isInnermost() && !done.contains(loop->getHeader()) &&
        visit(*loop, analyses, done, jammed))
      return true;
  return false;
}

}  // namespace

PreservedAnalyses ProductsPass::run(Function& function, FunctionAnalysisManager& manager) {
  if (function.hasOptSize() || isInterruptHandler(function) ||
      manager.getResult<LoopAnalysis>(function).empty())
    return PreservedAnalyses::all();
  Heads done;
  bool jammed = false;
  while (visit_one(function, manager, done, jammed))
    manager.invalidate(function, PreservedAnalyses::none());
  manager.invalidate(function, PreservedAnalyses::none());
  if (jammed)
    ask_once(function, manager);
  return PreservedAnalyses::none();
}

}  // namespace finback::compiler
