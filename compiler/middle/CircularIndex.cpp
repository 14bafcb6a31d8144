#include "CircularIndex.hpp"

#include <llvm/Analysis/ScalarEvolutionExpressions.h>
#include <llvm/IR/ConstantRange.h>
#include <llvm/IR/PatternMatch.h>

namespace finback::compiler {
namespace {

using namespace llvm;
using namespace llvm::PatternMatch;

constexpr unsigned kIndexBits = 32;

ConstantInt* word(const Value& like, int64_t value) {
  return ConstantInt::getSigned(cast<IntegerType>(like.getType()), value);
}

/// `value` is the phi plus a number: that number.
std::optional<int64_t> distance_from(Value* value, PHINode& phi) {
  const APInt* number = nullptr;
  if (value == &phi)
    return 0;
  if (match(value, m_Add(m_Specific(&phi), m_APInt(number))))
    return number->getSExtValue();
  return std::nullopt;
}

/// For which values of the phi a comparison with a number is true.
std::optional<ConstantRange> where_true(ICmpInst& compare, PHINode& phi) {
  const APInt* number = nullptr;
  const std::optional<int64_t> from = distance_from(compare.getOperand(0), phi);
  if (!from || !match(compare.getOperand(1), m_APInt(number)))
    return std::nullopt;
  return ConstantRange::makeExactICmpRegion(compare.getPredicate(), *number)
      .subtract(APInt(kIndexBits, static_cast<uint64_t>(*from), /*isSigned=*/true));
}

ConstantRange range(int64_t from, int64_t to) {
  return ConstantRange::getNonEmpty(APInt(kIndexBits, static_cast<uint64_t>(from)),
                                    APInt(kIndexBits, static_cast<uint64_t>(to)));
}

/// Within a circle of `size`, is the range just where a step leaves it?
bool is_where_left(const ConstantRange& where, int64_t step, int64_t size) {
  const int64_t border = step > 0 ? size - step : -step;
  if (border <= 0 || border >= size)
    return false;
  const ConstantRange below = range(0, border);
  const ConstantRange above = range(border, size);
  const ConstantRange& outside = step > 0 ? above : below;
  const ConstantRange& inside = step > 0 ? below : above;
  return where.contains(outside) && where.inverse().contains(inside);
}

/// One side of a selection: a number, and the phi or something that the loop does not change.
struct Side {
  bool of_phi = false;
  Value* invariant = nullptr;
  int64_t number = 0;
};

std::optional<Side> side_of(Value* value, const PHINode& phi, const Loop& loop) {
  Side side;
  Value* plain = nullptr;
  const APInt* number = nullptr;
  while (match(value, m_Add(m_Value(plain), m_APInt(number))) && !loop.isLoopInvariant(value)) {
    side.number += number->getSExtValue();
    value = plain;
  }
  if (match(value, m_APInt(number)))
    side.number += number->getSExtValue();
  else if (value == &phi)
    side.of_phi = true;
  else if (loop.isLoopInvariant(value))
    side.invariant = value;
  else
    return std::nullopt;
  return side;
}

/// condition ? sides[0] : sides[1]
struct Selection {
  ICmpInst* condition;
  std::array<Side, 2> sides;
};

/// A selection, also where what its sides have in common has been taken out of it.
std::optional<Selection> selection_of(Value* value, PHINode& phi, const Loop& loop) {
  Value* other = nullptr;
  auto* select = dyn_cast<SelectInst>(value);
  if (select == nullptr &&
      match(value, m_c_Add(m_Select(m_Value(), m_Value(), m_Value()), m_Value(other)))) {
    Value* first = cast<Instruction>(value)->getOperand(0);
    select = dyn_cast<SelectInst>(first == other ? cast<Instruction>(value)->getOperand(1) : first);
  }
  auto* condition = select == nullptr ? nullptr : dyn_cast<ICmpInst>(select->getCondition());
  const std::optional<Side> common = other == nullptr ? Side{} : side_of(other, phi, loop);
  if (condition == nullptr || !common)
    return std::nullopt;
  Selection selection{condition, {}};
  for (const unsigned i : {0U, 1U}) {
    std::optional<Side> side = side_of(select->getOperand(i + 1), phi, loop);
    if (!side || (common->of_phi && side->of_phi) ||
        (common->invariant != nullptr && side->invariant != nullptr))
      return std::nullopt;
    side->of_phi |= common->of_phi;
    side->invariant = common->invariant != nullptr ? common->invariant : side->invariant;
    side->number += common->number;
    if (side->of_phi && side->invariant != nullptr)
      return std::nullopt;
    selection.sides[i] = *side;
  }
  return selection;
}

/// where ? wrapped : phi + step, all of them numbers.
bool match_numbers(CircularIndex& index, const ConstantRange& where, int64_t step,
                   const Side& wrapped) {
  int64_t size = 0;
  if (wrapped.of_phi) {
    size = std::abs(step - wrapped.number);
  } else if (wrapped.invariant != nullptr) {
    return false;
  } else if (step == 1 && wrapped.number == 0) {
    // The first value that is wrapped is the last one of the circle.
    const ConstantRange rest = where.intersectWith(range(0, kLargestCircle));
    size = rest.isEmptySet() ? 0 : static_cast<int64_t>(rest.getUnsignedMin().getZExtValue()) + 1;
  } else if (step == -1) {
    size = wrapped.number + 1;
  }
  const bool comes_back = !wrapped.of_phi || (step > 0) == (wrapped.number < step);
  if (!comes_back || size <= 1 || size > kLargestCircle || !is_where_left(where, step, size))
    return false;
  index.size = word(*index.phi, size);
  index.step = word(*index.phi, step);
  return true;
}

/// phi + 1 == n ? 0 : phi + 1, and the like, for an n that the loop does not change.
bool match_up(CircularIndex& index, const ICmpInst& compare, bool wraps_if_true,
              const Side& wrapped, const Loop& loop) {
  ICmpInst::Predicate predicate = compare.getPredicate();
  Value* left = compare.getOperand(0);
  Value* right = compare.getOperand(1);
  if (loop.isLoopInvariant(left)) {
    std::swap(left, right);
    predicate = ICmpInst::getSwappedPredicate(predicate);
  }
  if (!wraps_if_true)
    predicate = ICmpInst::getInversePredicate(predicate);
  const std::optional<int64_t> from = distance_from(left, *index.phi);
  const bool at_end = predicate == ICmpInst::ICMP_EQ || predicate == ICmpInst::ICMP_UGE ||
                      predicate == ICmpInst::ICMP_SGE;
  if (!from || !at_end || wrapped.of_phi || wrapped.invariant != nullptr || wrapped.number != 0 ||
      !loop.isLoopInvariant(right))
    return false;
  if (*from == 1)
    index.size = right;
  else if (*from == 0)
    index.size_less_one = right;
  else
    return false;
  index.step = word(*index.phi, 1);
  return true;
}

/// phi == 0 ? n - 1 : phi - 1, for such an n.
bool match_down(CircularIndex& index, const ConstantRange& where, const Side& wrapped) {
  if (wrapped.of_phi || wrapped.invariant == nullptr || !is_where_left(where, -1, kLargestCircle))
    return false;
  if (wrapped.number == -1)
    index.size = wrapped.invariant;
  else if (wrapped.number == 0)
    index.size_less_one = wrapped.invariant;
  else
    return false;
  index.step = word(*index.phi, -1);
  return true;
}

bool match_selection(CircularIndex& index, const Loop& loop) {
  const std::optional<Selection> selection = selection_of(index.next, *index.phi, loop);
  if (!selection)
    return false;
  const std::optional<ConstantRange> where = where_true(*selection->condition, *index.phi);
  for (const bool wraps_if_true : {true, false}) {
    const Side& wrapped = selection->sides[wraps_if_true ? 0 : 1];
    const Side& plain = selection->sides[wraps_if_true ? 1 : 0];
    const int64_t step = plain.number;
    if (!plain.of_phi || step == 0)
      continue;
    if (where) {
      const ConstantRange leaves = wraps_if_true ? *where : where->inverse();
      if (match_numbers(index, leaves, step, wrapped) ||
          (step == -1 && match_down(index, leaves, wrapped)))
        return true;
    }
    if (step == 1 && match_up(index, *selection->condition, wraps_if_true, wrapped, loop))
      return true;
  }
  return false;
}

/// The shorter way round a circle: 63 of 64 is one back.
int64_t shorter(int64_t step, int64_t size) {
  step %= size;
  return step > size / 2 ? step - size : step < -size / 2 ? step + size : step;
}

/// (phi + s) & (n - 1), n a power of two.
bool match_mask(CircularIndex& index) {
  Value* sum = nullptr;
  const APInt* mask = nullptr;
  if (!match(index.next, m_And(m_Value(sum), m_APInt(mask))) || !mask->isMask() ||
      mask->uge(kLargestCircle))
    return false;
  const std::optional<int64_t> step = distance_from(sum, *index.phi);
  const int64_t size = mask->getSExtValue() + 1;
  if (!step || *step % size == 0)
    return false;
  index.size = word(*index.phi, size);
  index.step = word(*index.phi, shorter(*step, size));
  return true;
}

/// (phi + s) % n, without sign.
bool match_remainder(CircularIndex& index, const Loop& loop) {
  Value* sum = nullptr;
  Value* size = nullptr;
  if (!match(index.next, m_URem(m_Value(sum), m_Value(size))) || !loop.isLoopInvariant(size))
    return false;
  const std::optional<int64_t> step = distance_from(sum, *index.phi);
  const auto* number = dyn_cast<ConstantInt>(size);
  if (!step || *step <= 0 || *step >= kLargestCircle ||
      (number != nullptr && (number->getValue().ult(static_cast<uint64_t>(*step)) ||
                             number->getValue().ugt(kLargestCircle))))
    return false;
  index.size = size;
  index.step = word(*index.phi, number == nullptr ? *step : shorter(*step, number->getSExtValue()));
  return !cast<ConstantInt>(index.step)->isZero();
}

bool match_call(CircularIndex& index, const Loop& loop) {
  const auto* call = dyn_cast<CallInst>(index.next);
  const Function* function = call == nullptr ? nullptr : call->getCalledFunction();
  const bool pointer = function != nullptr && function->getName() == "__builtin_bfin_circptr";
  if (function == nullptr || (!pointer && function->getName() != "__builtin_bfin_circindex") ||
      call->getArgOperand(0) != index.phi ||
      !all_of(drop_begin(call->args()),
              [&](const Use& argument) { return loop.isLoopInvariant(argument.get()); }))
    return false;
  index.step = call->getArgOperand(1);
  index.base = pointer ? call->getArgOperand(2) : nullptr;
  index.size = call->getArgOperand(pointer ? 3 : 2);
  index.vouched = true;
  return true;
}

/// What leads from the phi to its next value; false where it leads elsewhere, too.
bool find_chain(CircularIndex& index, const Loop& loop) {
  SmallVector<Value*, 4> left = {index.next};
  while (!left.empty()) {
    auto* inst = dyn_cast<Instruction>(left.pop_back_val());
    if (inst == nullptr || inst == index.phi || !loop.contains(inst) ||
        is_contained(index.chain, inst))
      continue;
    index.chain.push_back(inst);
    append_range(left, inst->operands());
  }
  // A value stands behind what it is made of: all of them lie on ways of at most three.
  llvm::sort(index.chain, [](const Instruction* a, const Instruction* b) {
    return a->getParent() == b->getParent() && a->comesBefore(b);
  });
  const BasicBlock* block = cast<Instruction>(index.next)->getParent();
  return all_of(index.chain, [&](const Instruction* inst) {
    return inst->getParent() == block &&
           (inst == index.next || all_of(inst->users(), [&](const User* user) {
              return is_contained(index.chain, user);
            }));
  });
}

}  // namespace

std::optional<CircularIndex> match_circular_index(PHINode& phi, const Loop& loop) {
  CircularIndex index;
  index.value = &phi;
  index.phi = &phi;
  index.next = phi.getIncomingValueForBlock(loop.getLoopLatch());
  if (!isa<Instruction>(index.next) || index.next == &phi ||
      !loop.contains(cast<Instruction>(index.next)) ||
      (!phi.getType()->isIntegerTy(kIndexBits) && !phi.getType()->isPointerTy()))
    return std::nullopt;
  const bool found =
      match_call(index, loop) ||
      (phi.getType()->isIntegerTy() &&
       (match_mask(index) || match_remainder(index, loop) || match_selection(index, loop)));
  if (!found || !find_chain(index, loop))
    return std::nullopt;
  return index;
}

std::optional<CircularIndex> match_masked_index(Instruction& masked, const Loop& loop,
                                                ScalarEvolution& scev) {
  Value* sum = nullptr;
  const APInt* mask = nullptr;
  const APInt* number = nullptr;
  if (!masked.getType()->isIntegerTy(kIndexBits) ||
      !match(&masked, m_And(m_Value(sum), m_APInt(mask))) || !mask->isMask() ||
      mask->uge(kLargestCircle))
    return std::nullopt;
  CircularIndex index;
  index.value = &masked;
  int64_t step = 0;
  const auto* steps = dyn_cast<SCEVAddRecExpr>(scev.getSCEV(sum));
  auto* phi = dyn_cast<PHINode>(sum);
  if (phi != nullptr && phi->getParent() == loop.getHeader() && phi->hasOneUse() &&
      match(phi->getIncomingValueForBlock(loop.getLoopLatch()),
            m_Add(m_Specific(&masked), m_APInt(number)))) {
    index.phi = phi;
    index.next = phi->getIncomingValueForBlock(loop.getLoopLatch());
    index.chain.push_back(cast<Instruction>(index.next));
    index.start = scev.getSCEV(phi->getIncomingValueForBlock(loop.getLoopPredecessor()));
    step = number->getSExtValue();
  } else if (steps != nullptr && steps->getLoop() == &loop && steps->isAffine() &&
             isa<SCEVConstant>(steps->getStepRecurrence(scev))) {
    index.start = steps->getStart();
    step = cast<SCEVConstant>(steps->getStepRecurrence(scev))->getAPInt().getSExtValue();
  }
  const int64_t size = mask->getSExtValue() + 1;
  if (index.start == nullptr || step % size == 0)
    return std::nullopt;
  index.size = word(masked, size);
  index.step = word(masked, shorter(step, size));
  return index;
}

}  // namespace finback::compiler
