#include "PairProducts.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/MDBuilder.h>
#include <llvm/IR/Module.h>
#include <llvm/Transforms/Utils/LoopUtils.h>
#include <llvm/Transforms/Utils/ScalarEvolutionExpander.h>

#include "NamedCall.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;

constexpr uint32_t kMostProducts = 511;  // of magnitude 2^30, in 40 bits with a sign

bool is_same(const Factor& a, const Factor& b) { return a.start == b.start && a.step == b.step; }

/// Is b the half behind a, in each round?
bool is_next_to(const Factor& a, const Factor& b, ScalarEvolution& scev) {
  if (a.step != b.step)
    return false;
  const auto* distance = dyn_cast<SCEVConstant>(scev.getMinusSCEV(b.start, a.start));
  return distance != nullptr && distance->getAPInt() == 2;
}

std::optional<PairPlan> plan_lanes(const ProductLoop& products) {
  const auto& [left, right] = products.sums[0].factors;
  if (!goes_by_halves(left) || !goes_by_halves(right))
    return std::nullopt;
  return PairPlan{products, Pairing::kLanes, left, right, true, {left.start, right.start}};
}

std::optional<PairPlan> plan_two(const ProductLoop& products, ScalarEvolution& scev) {
  const auto& first = products.sums[0].factors;
  const auto& second = products.sums[1].factors;
  for (const unsigned i : {0U, 1U})
    for (const unsigned j : {0U, 1U}) {
      const Factor& shared = first[i];
      const Factor& own = first[1 - i];
      if (!is_same(shared, second[j]) || !is_next_to(own, second[1 - j], scev))
        continue;
      PairPlan plan{products, Pairing::kColumns, shared, own, goes_by_halves(shared), {}};
      if (goes_by_halves(own))
        plan.pairing = Pairing::kSliding;
      else
        plan.aligned = {own.start, own.step};
      if (plan.shared_in_words)
        plan.aligned.push_back(shared.start);
      if (plan.pairing == Pairing::kColumns || plan.shared_in_words)
        return plan;
    }
  return std::nullopt;
}

/// Writes one paired loop.
class Writer {
 public:
  Writer(const PairPlan& plan, ScalarEvolution& scev, BasicBlock* before)
      : plan_(plan),
        scev_(scev),
        builder_(before),
        function_(*before->getParent()),
        context_(before->getContext()),
        word_(Type::getInt32Ty(context_)) {
    builder_.SetCurrentDebugLocation(plan.products.sums[0].next->getDebugLoc());
  }

  PairedSums write();

 private:
  using Values = SmallVector<Value*, 4>;
  /// What goes from round to round: addresses of both factors, the window of a sliding pair, sums.
  struct State {
    Value* shared = nullptr;
    Value* own = nullptr;
    Value* window = nullptr;
    Values sums;

    [[nodiscard]] Values all() const;
    void set(const Values& values);
  };

  BasicBlock* block(const char* name) {
    return BasicBlock::Create(context_, name, &function_, plan_.products.loop->getHeader());
  }
  State first_state();
  State phis_of(const State& state, BasicBlock* from);
  void close(const State& phis, const State& next, BasicBlock* from);
  State write_rounds(const State& first, Value* rounds);
  State write_strips(const State& first, Value* rounds);
  State write_odd_round(const State& state, Value* rounds);
  void write_body(State& state);
  void write_lanes(State& state);
  void write_columns(State& state);
  void write_sliding(State& state);

  Value* load(Type* type, Value* address, const Factor& like, Align align);
  Value* load_word(Value* address, const Factor& like) {
    return load(word_, address, like, Align(4));
  }
  Value* load_half(Value* address, const Factor& like) {
    return builder_.CreateSExt(load(builder_.getInt16Ty(), address, like, Align(2)), word_);
  }
  Value* low(Value* word) {
    return builder_.CreateSExt(builder_.CreateTrunc(word, builder_.getInt16Ty()), word_);
  }
  Value* high(Value* word) { return builder_.CreateAShr(word, 16); }
  Value* step(Value* address, const Factor& factor, unsigned rounds) {
    Value* bytes = builder_.CreateMul(expand(factor.step), builder_.getInt32(rounds));
    return builder_.CreatePtrAdd(address, bytes);
  }
  Value* expand(const SCEV* value);
  void add_product(Value*& sum, Value* a, Value* b) {
    Value* product = builder_.CreateNSWMul(a, b);
    sum = call_named(builder_, sums_are_cs() ? "sum_fits" : "sum", {sum, product});
  }
  [[nodiscard]] bool must_fit() const;
  [[nodiscard]] bool sums_are_cs() const;
  [[nodiscard]] uint32_t most_rounds() const;

  const PairPlan& plan_;
  ScalarEvolution& scev_;
  IRBuilder<> builder_;
  Function& function_;
  LLVMContext& context_;
  Type* word_;
};

Writer::Values Writer::State::all() const {
  Values values = {shared, own};
  if (window != nullptr)
    values.push_back(window);
  values.append(sums);
  return values;
}

void Writer::State::set(const Values& values) {
  shared = values[0];
  own = values[1];
  unsigned next = 2;
  if (window != nullptr)
    window = values[next++];
  for (Value*& sum : sums)
    sum = values[next++];
}

/// What the loop wants from outside is computed in front of it.
Value* Writer::expand(const SCEV* value) {
  if (const auto* constant = dyn_cast<SCEVConstant>(value))
    return constant->getValue();
  SCEVExpander expander(scev_, function_.getParent()->getDataLayout(), "pairs");
  expander.disableCanonicalMode();  // an address that steps with the loop around, steps there
  return expander.expandCodeFor(value, value->getType(),
                                plan_.products.loop->getLoopPreheader()->getTerminator());
}

Value* Writer::load(Type* type, Value* address, const Factor& like, Align align) {
  LoadInst* load = builder_.CreateAlignedLoad(type, address, align);
  load->copyMetadata(*like.load,
                     {LLVMContext::MD_tbaa, LLVMContext::MD_alias_scope, LLVMContext::MD_noalias});
  return load;
}

Writer::State Writer::first_state() {
  State state;
  state.shared = expand(plan_.shared.start);
  state.own = expand(plan_.own.start);
  if (plan_.pairing == Pairing::kSliding)
    state.window = load_half(state.own, plan_.own);
  state.sums.assign(2, builder_.getInt32(0));
  return state;
}

void Writer::write_lanes(State& state) {
  Value* a = load_word(state.shared, plan_.shared);
  Value* b = is_same(plan_.shared, plan_.own) ? a : load_word(state.own, plan_.own);
  add_product(state.sums[0], low(a), low(b));
  add_product(state.sums[1], high(a), high(b));
}

void Writer::write_columns(State& state) {
  Value* first = nullptr;
  Value* second = nullptr;
  if (plan_.shared_in_words) {
    Value* both = load_word(state.shared, plan_.shared);
    first = low(both);
    second = high(both);
  } else {
    first = load_half(state.shared, plan_.shared);
    second = load_half(step(state.shared, plan_.shared, 1), plan_.shared);
  }
  for (const auto& [factor, round] : {std::pair(first, 0U), std::pair(second, 1U)}) {
    Value* neighbours = load_word(step(state.own, plan_.own, round), plan_.own);
    add_product(state.sums[0], factor, low(neighbours));
    add_product(state.sums[1], factor, high(neighbours));
  }
}

/// The window holds the present half and the next one, in turns the one or the other in the low
/// half.
void Writer::write_sliding(State& state) {
  Value* factors = load_word(state.shared, plan_.shared);
  Value* next = load_half(step(state.own, plan_.own, 1), plan_.own);
  state.window = call_named(builder_, "set_high", {state.window, next});
  add_product(state.sums[0], low(state.window), low(factors));
  add_product(state.sums[1], high(state.window), low(factors));
  next = load_half(step(state.own, plan_.own, 2), plan_.own);
  state.window = call_named(builder_, "set_low", {state.window, next});
  add_product(state.sums[0], high(state.window), high(factors));
  add_product(state.sums[1], low(state.window), high(factors));
}

/// Two of C's rounds.
void Writer::write_body(State& state) {
  switch (plan_.pairing) {
    case Pairing::kLanes:
      write_lanes(state);
      break;
    case Pairing::kColumns:
      write_columns(state);
      break;
    case Pairing::kSliding:
      write_sliding(state);
      break;
  }
  state.shared = step(state.shared, plan_.shared, 2);
  state.own = step(state.own, plan_.own, 2);
}

/// A block begins with phis of what goes from round to round.
Writer::State Writer::phis_of(const State& state, BasicBlock* from) {
  Values phis;
  for (Value* value : state.all()) {
    PHINode* phi = builder_.CreatePHI(value->getType(), 2);
    phi->addIncoming(value, from);
    phis.push_back(phi);
  }
  State result = state;
  result.set(phis);
  return result;
}

void Writer::close(const State& phis, const State& next, BasicBlock* from) {
  for (const auto& [phi, value] : zip(phis.all(), next.all()))
    cast<PHINode>(phi)->addIncoming(value, from);
}

Writer::State Writer::write_rounds(const State& first, Value* rounds) {
  BasicBlock* entry = builder_.GetInsertBlock();
  BasicBlock* body = block("pairs");
  BasicBlock* done = block("pairs.done");
  builder_.CreateBr(body);
  builder_.SetInsertPoint(body);
  PHINode* left = builder_.CreatePHI(word_, 2);
  left->addIncoming(rounds, entry);
  const State phis = phis_of(first, entry);
  State next = phis;
  write_body(next);
  Value* fewer = builder_.CreateSub(left, builder_.getInt32(1), "", true);
  left->addIncoming(fewer, body);
  close(phis, next, body);
  builder_.CreateCondBr(builder_.CreateICmpEQ(fewer, builder_.getInt32(0)), done, body);
  builder_.SetInsertPoint(done);
  return next;
}

/// As many rounds at a time as 40 bits hold the sums of.
Writer::State Writer::write_strips(const State& first, Value* rounds) {
  BasicBlock* entry = builder_.GetInsertBlock();
  BasicBlock* strip = block("strip");
  builder_.CreateBr(strip);
  builder_.SetInsertPoint(strip);
  PHINode* left = builder_.CreatePHI(word_, 2);
  left->addIncoming(rounds, entry);
  const State phis = phis_of(first, entry);
  Value* now =
      builder_.CreateBinaryIntrinsic(Intrinsic::smin, left, builder_.getInt32(most_rounds()));
  State from_zero = phis;
  from_zero.sums.assign(2, builder_.getInt32(0));
  State next = write_rounds(from_zero, now);
  for (const auto& [sum, before] : zip(next.sums, phis.sums))
    sum = builder_.CreateAdd(sum, before);
  Value* rest = builder_.CreateSub(left, now);
  BasicBlock* end = builder_.GetInsertBlock();
  left->addIncoming(rest, end);
  close(phis, next, end);
  BasicBlock* done = block("strips.done");
  // One strip is what most arrays have.
  builder_.CreateCondBr(builder_.CreateICmpEQ(rest, builder_.getInt32(0)), done, strip,
                        MDBuilder(context_).createBranchWeights(8, 1));
  builder_.SetInsertPoint(done);
  return next;
}

/// The last round of an odd number of them. Into the sums only: nothing comes behind.
Writer::State Writer::write_odd_round(const State& state, Value* rounds) {
  Value* odd = builder_.CreateAnd(rounds, 1);
  if (isa<ConstantInt>(odd) && cast<ConstantInt>(odd)->isZero())
    return state;
  BasicBlock* entry = builder_.GetInsertBlock();
  BasicBlock* one = block("odd");
  BasicBlock* done = block("odd.done");
  // Even numbers are what most arrays have: that way shall lead straight on.
  builder_.CreateCondBr(builder_.CreateICmpEQ(odd, builder_.getInt32(0)), done, one,
                        MDBuilder(context_).createBranchWeights(8, 1));
  builder_.SetInsertPoint(one);
  State with = state;
  Value* shared = load_half(state.shared, plan_.shared);
  for (unsigned i = 0; i < plan_.products.sums.size(); ++i) {
    Value* address = builder_.CreatePtrAdd(state.own, builder_.getInt32(2 * i));
    Value* product = builder_.CreateMul(shared, load_half(address, plan_.own), "", false, true);
    with.sums[i] = builder_.CreateAdd(with.sums[i], product);
  }
  builder_.CreateBr(done);
  builder_.SetInsertPoint(done);
  State result = state;
  for (const auto& [sum, left_out, added] : zip(result.sums, state.sums, with.sums)) {
    PHINode* phi = builder_.CreatePHI(word_, 2);
    phi->addIncoming(left_out, entry);
    phi->addIncoming(added, one);
    sum = phi;
  }
  return result;
}

/// C's own sums, which must not overflow, are those of columns and sliding windows.
bool Writer::must_fit() const {
  return plan_.pairing != Pairing::kLanes && all_of(plan_.products.sums, [](const ProductSum& sum) {
           return sum.next->hasNoSignedWrap();
         });
}

/// Whether the sums are C's in each round, too: they begin with zero, as ours do.
bool Writer::sums_are_cs() const {
  return must_fit() && all_of(plan_.products.sums, [](const ProductSum& sum) {
           const auto* start = dyn_cast<ConstantInt>(sum.start());
           return start != nullptr && start->isZero();
         });
}

/// In one piece; 0: any number.
uint32_t Writer::most_rounds() const {
  if (must_fit())
    return 0;
  return plan_.pairing == Pairing::kLanes ? kMostProducts : kMostProducts / 2;
}

PairedSums Writer::write() {
  Value* rounds = expand(plan_.products.rounds);
  Value* pairs = builder_.CreateLShr(rounds, 1);
  State state = first_state();
  const unsigned known = scev_.getSmallConstantMaxTripCount(plan_.products.loop);
  const bool in_strips = most_rounds() != 0 && (known == 0 || known / 2 > most_rounds());
  if (!in_strips && !isa<ConstantInt>(pairs))
    pairs = call_named(builder_, "at_least_two", {pairs});
  state = in_strips ? write_strips(state, pairs) : write_rounds(state, pairs);
  state = write_odd_round(state, rounds);
  PairedSums result{nullptr, {}};
  if (plan_.pairing == Pairing::kLanes)
    state.sums = {builder_.CreateAdd(state.sums[0], state.sums[1])};
  for (const auto& [sum, own] : zip(plan_.products.sums, state.sums))
    result.values.push_back(builder_.CreateAdd(sum.start(), own));
  result.end = builder_.GetInsertBlock();
  return result;
}

}  // namespace

std::optional<PairPlan> plan_pairs(const ProductLoop& products, ScalarEvolution& scev) {
  return products.sums.size() == 1 ? plan_lanes(products) : plan_two(products, scev);
}

PairedSums write_pairs(const PairPlan& plan, ScalarEvolution& scev, BasicBlock* before) {
  return Writer(plan, scev, before).write();
}

}  // namespace finback::compiler
