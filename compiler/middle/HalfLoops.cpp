#include "HalfLoops.hpp"

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/ScalarEvolutionExpressions.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Module.h>
#include <llvm/Transforms/Utils/Local.h>

#include "Alignment.hpp"
#include "HalfForms.hpp"
#include "PairWords.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;

constexpr unsigned kLeastElements = 8;  // fewer are not worth the tests
constexpr unsigned kMostValues = 40;    // more do not stay in registers

/// The least or the greatest of an array: `next`, which each round makes of `last` and `other`.
struct Extreme {
  PHINode* last;
  IntrinsicInst* next;
  Value* other;
};

class HalfLoop {
 public:
  HalfLoop(Loop& loop, ScalarEvolution& scev)
      : loop_(loop), block_(*loop.getHeader()), scev_(scev) {}

  bool plan();
  void write();

 private:
  bool plan_value(Value* value);
  bool plan_access(const Value* address);
  bool plan_store(StoreInst& store);
  bool plan_extreme(PHINode& last);
  [[nodiscard]] bool steers(Instruction& inst) const;
  [[nodiscard]] bool is_used_otherwise(const Instruction& inst) const;
  Value* write_value(Value* value);
  Value* write_form(const HalfForm& form, IRBuilder<>& builder);
  void write_extreme(const Extreme& extreme);

  Loop& loop_;
  BasicBlock& block_;
  ScalarEvolution& scev_;
  SmallVector<StoreInst*, 4> stores_;
  SmallVector<Extreme, 2> extremes_;
  SmallVector<const SCEV*, 8> addresses_;
  SmallPtrSet<const Value*, 32> planned_;
  SmallPtrSet<const Value*, 8> passed_;  // parts of others' forms
  DenseMap<Value*, Value*> written_;
};

/// Up by a half a round; not beside an array that lies a half off, where one of the two would
/// always be loaded in halves.
bool HalfLoop::plan_access(const Value* address) {
  const SCEV* at = scev_.getSCEV(const_cast<Value*>(address));
  const auto* steps = dyn_cast<SCEVAddRecExpr>(at);
  if (steps == nullptr || steps->getLoop() != &loop_ || !steps->isAffine())
    return false;
  const auto* step = dyn_cast<SCEVConstant>(steps->getStepRecurrence(scev_));
  if (step == nullptr || step->getAPInt() != sizeof(int16_t))
    return false;
  for (const SCEV* other : addresses_) {
    const auto* apart = dyn_cast<SCEVConstant>(scev_.getMinusSCEV(at, other));
    if (apart != nullptr && !is_aligned(apart, scev_))
      return false;
  }
  addresses_.push_back(at);
  return true;
}

bool HalfLoop::plan_value(Value* value) {
  if (!value->getType()->isIntegerTy(kHalfBits) && !value->getType()->isIntegerTy(2 * kHalfBits))
    return false;
  const HalfForm form = form_of(value, loop_);
  if (form.kind == HalfForm::invariant || planned_.contains(value))
    return true;
  if (form.kind == HalfForm::none || planned_.size() >= kMostValues)
    return false;
  if (form.kind == HalfForm::loaded &&
      (!is_half(value) || !plan_access(cast<LoadInst>(value)->getPointerOperand())))
    return false;
  planned_.insert(value);
  passed_.insert(form.within.begin(), form.within.end());
  return all_of(form.operands, [&](Value* operand) { return plan_value(operand); });
}

/// Counts rounds, computes addresses, or ends the loop.
bool HalfLoop::steers(Instruction& inst) const {
  if (isa<BranchInst>(inst) || isa<ICmpInst>(inst) || isa<DbgInfoIntrinsic>(inst))
    return true;
  return !inst.mayReadOrWriteMemory() && scev_.isSCEVable(inst.getType()) &&
         isa<SCEVAddRecExpr>(scev_.getSCEV(&inst));
}

bool HalfLoop::is_used_otherwise(const Instruction& inst) const {
  if (any_of(extremes_, [&](const Extreme& extreme) { return extreme.next == &inst; }))
    return false;  // what is behind the loop may want it
  return any_of(inst.users(), [&](const User* user) {
    const auto* store = dyn_cast<StoreInst>(user);
    return store != nullptr ? !is_contained(stores_, store) || store->getPointerOperand() == &inst
                            : !planned_.contains(user) && !passed_.contains(user);
  });
}

bool HalfLoop::plan_store(StoreInst& store) {
  stores_.push_back(&store);
  return store.isSimple() && is_half(store.getValueOperand()) &&
         plan_access(store.getPointerOperand()) && plan_value(store.getValueOperand());
}

bool HalfLoop::plan_extreme(PHINode& last) {
  auto* next = dyn_cast<IntrinsicInst>(last.getIncomingValueForBlock(&block_));
  if (next == nullptr || !last.hasOneUse() || last.getNumIncomingValues() != 2 ||
      (next->getIntrinsicID() != Intrinsic::smin && next->getIntrinsicID() != Intrinsic::smax) ||
      (next->getArgOperand(0) != &last && next->getArgOperand(1) != &last))
    return false;
  Value* other = next->getArgOperand(next->getArgOperand(0) == &last ? 1 : 0);
  const bool only_behind = all_of(next->users(), [&](const User* user) {
    const auto* phi = dyn_cast<PHINode>(user);
    return phi == &last || (phi != nullptr && phi->getParent() == loop_.getExitBlock() &&
                            phi->getNumIncomingValues() == 1);
  });
  const DataLayout& layout = next->getDataLayout();
  if (!only_behind || !fits_signed(other, layout) ||
      !fits_signed(last.getIncomingValueForBlock(loop_.getLoopPreheader()), layout))
    return false;
  extremes_.push_back({&last, next, other});
  planned_.insert(&last);
  planned_.insert(next);
  return plan_value(other);
}

bool HalfLoop::plan() {
  for (Instruction& inst : block_) {
    auto* store = dyn_cast<StoreInst>(&inst);
    auto* phi = dyn_cast<PHINode>(&inst);
    if ((store != nullptr && !plan_store(*store)) ||
        (phi != nullptr && !steers(*phi) && !plan_extreme(*phi)))
      return false;
  }
  if (stores_.empty() && extremes_.empty())
    return false;
  return all_of(block_, [&](Instruction& inst) {
    if (planned_.contains(&inst) || passed_.contains(&inst))
      return !is_used_otherwise(inst);
    return isa<StoreInst>(inst) || steers(inst);
  });
}

Value* HalfLoop::write_form(const HalfForm& form, IRBuilder<>& builder) {
  SmallVector<Value*, 3> operands;
  for (Value* operand : form.operands)
    operands.push_back(write_value(operand));
  switch (form.kind) {
    case HalfForm::operation:
      return builder.CreateBinOp(Instruction::BinaryOps(form.code), operands[0], operands[1]);
    case HalfForm::shift:
      return builder.CreateBinOp(Instruction::BinaryOps(form.code), operands[0],
                                 builder.getInt16(static_cast<uint16_t>(form.by)));
    case HalfForm::intrinsic:
      if (form.code == Intrinsic::abs)
        operands.push_back(builder.getFalse());
      if (form.code == Intrinsic::smul_fix_sat)
        operands.push_back(builder.getInt32(kHalfBits - 1));
      return builder.CreateAShr(
          builder.CreateIntrinsic(form.code, {builder.getInt16Ty()}, operands), form.by);
    case HalfForm::negated:
    case HalfForm::amount: {
      Value* negative =
          builder.CreateBinaryIntrinsic(Intrinsic::ssub_sat, builder.getInt16(0), operands[0]);
      return form.kind == HalfForm::negated
                 ? negative
                 : builder.CreateBinaryIntrinsic(Intrinsic::smax, operands[0], negative);
    }
    case HalfForm::mean:
      return write_mean(operands[0], operands[1], builder);
    case HalfForm::distance:
      return builder.CreateSub(
          builder.CreateBinaryIntrinsic(Intrinsic::smax, operands[0], operands[1]),
          builder.CreateBinaryIntrinsic(Intrinsic::smin, operands[0], operands[1]));
    default:
      return operands[0];
  }
}

Value* HalfLoop::write_value(Value* value) {
  if (Value*& known = written_[value]; known != nullptr)
    return known;
  const HalfForm form = form_of(value, loop_);
  Value* half = value;
  if (form.kind == HalfForm::invariant && !is_half(value)) {
    IRBuilder<> builder(loop_.getLoopPreheader()->getTerminator());
    half = builder.CreateTrunc(value, builder.getInt16Ty());
  } else if (form.kind != HalfForm::invariant && form.kind != HalfForm::loaded) {
    IRBuilder<> builder(cast<Instruction>(value));
    half = write_form(form, builder);
  }
  written_[value] = half;
  return half;
}

void HalfLoop::write_extreme(const Extreme& extreme) {
  Value* other = write_value(extreme.other);
  BasicBlock* before = loop_.getLoopPreheader();
  IRBuilder<> builder(before->getTerminator());
  Type* half = builder.getInt16Ty();
  Value* first = builder.CreateTrunc(extreme.last->getIncomingValueForBlock(before), half);
  builder.SetInsertPoint(extreme.last);
  PHINode* last = builder.CreatePHI(half, 2);
  builder.SetInsertPoint(extreme.next);
  Value* next = builder.CreateBinaryIntrinsic(extreme.next->getIntrinsicID(), last, other);
  last->addIncoming(first, before);
  last->addIncoming(next, &block_);
  BasicBlock* behind = loop_.getExitBlock();
  for (User* user : make_early_inc_range(extreme.next->users())) {
    auto* old = cast<PHINode>(user);
    if (old == extreme.last)
      continue;
    builder.SetInsertPoint(old);
    PHINode* result = builder.CreatePHI(half, 1);
    result->addIncoming(next, &block_);
    builder.SetInsertPoint(behind, behind->getFirstInsertionPt());
    old->replaceAllUsesWith(builder.CreateSExtOrTrunc(result, old->getType()));
    old->eraseFromParent();
  }
  scev_.forgetValue(extreme.last);
  extreme.last->replaceAllUsesWith(PoisonValue::get(extreme.last->getType()));
  extreme.last->eraseFromParent();
  RecursivelyDeleteTriviallyDeadInstructions(extreme.next);
}

void HalfLoop::write() {
  for (const Extreme& extreme : extremes_)
    write_extreme(extreme);
  SmallVector<WeakTrackingVH, 8> old;
  for (StoreInst* store : stores_) {
    old.emplace_back(store->getValueOperand());
    store->setOperand(0, write_value(store->getValueOperand()));
  }
  RecursivelyDeleteTriviallyDeadInstructionsPermissive(old);
}

}  // namespace

bool narrow_loop(Loop& loop, ScalarEvolution& scev, LoopAccessInfoManager& accesses) {
  const unsigned most = scev.getSmallConstantMaxTripCount(&loop);
  if (!loop.isInnermost() || loop.getNumBlocks() != 1 || loop.getLoopPreheader() == nullptr ||
      !scev.hasLoopInvariantBackedgeTakenCount(&loop) || (most != 0 && most < kLeastElements))
    return false;
  HalfLoop halves(loop, scev);
  if (!halves.plan() || !accesses.getInfo(loop).canVectorizeMemory())
    return false;
  accesses.clear();  // they know values that go
  halves.write();
  return true;
}

}  // namespace finback::compiler
