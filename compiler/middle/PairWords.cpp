#include "PairWords.hpp"

#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/Analysis/VectorUtils.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/PatternMatch.h>
#include <llvm/Transforms/Utils/Local.h>
#include <llvm/Transforms/Utils/LoopUtils.h>

#include "HalfForms.hpp"
#include "NamedCall.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;
using namespace PatternMatch;

const Align kWord(4);

bool is_pair_type(const Type* type) {
  const auto* vector = dyn_cast<FixedVectorType>(type);
  return vector != nullptr && vector->getNumElements() == 2 &&
         vector->getElementType()->isIntegerTy(kHalfBits);
}

/// The name of what an intrinsic does with pairs; empty when it has none.
StringRef name_of(Intrinsic::ID id) {
  return id == Intrinsic::smin           ? "min_fr2x16"
         : id == Intrinsic::smax         ? "max_fr2x16"
         : id == Intrinsic::sadd_sat     ? "add_fr2x16"
         : id == Intrinsic::ssub_sat     ? "sub_fr2x16"
         : id == Intrinsic::smul_fix_sat ? "mult_fr2x16"
                                         : "";
}

/// max(x, 0 - x), where the difference saturates: x.
Value* saturated_amount(Instruction& inst) {
  Value* value = nullptr;
  const auto negative = m_Intrinsic<Intrinsic::ssub_sat>(m_Zero(), m_Deferred(value));
  return match(&inst, m_c_SMax(m_Value(value), negative)) ? value : nullptr;
}

/// What write_mean() wrote.
bool is_mean(Instruction& inst, Value*& a, Value*& b) {
  return match(&inst, m_c_Add(m_And(m_Value(a), m_Value(b)),
                              m_AShr(m_c_Xor(m_Deferred(a), m_Deferred(b)), m_One())));
}

/// A half that goes from round to round through minima or maxima goes as a word: it would be
/// extended in each round.
bool widen_extreme(PHINode& phi) {
  for (Value* incoming : phi.incoming_values()) {
    auto* next = dyn_cast<MinMaxIntrinsic>(incoming);
    if (next == nullptr || !next->isSigned() || phi.getNumIncomingValues() != 2 ||
        (next->getLHS() != &phi && next->getRHS() != &phi))
      continue;
    IRBuilder<> builder(&phi);
    PHINode* word = builder.CreatePHI(builder.getInt32Ty(), 2);
    builder.SetInsertPoint(next);
    Value* other = next->getLHS() == &phi ? next->getRHS() : next->getLHS();
    Value* wide = builder.CreateBinaryIntrinsic(next->getIntrinsicID(), word,
                                                builder.CreateSExt(other, builder.getInt32Ty()));
    next->replaceAllUsesWith(builder.CreateTrunc(wide, phi.getType()));
    for (const auto& [value, block] : zip(phi.incoming_values(), phi.blocks())) {
      builder.SetInsertPoint(block->getTerminator());
      const bool is_next = match(value.get(), m_Trunc(m_Specific(wide)));
      word->addIncoming(is_next ? wide : builder.CreateSExt(value, word->getType()), block);
    }
    builder.SetInsertPoint(phi.getParent(), phi.getParent()->getFirstInsertionPt());
    phi.replaceAllUsesWith(builder.CreateTrunc(word, phi.getType()));
    next->eraseFromParent();
    phi.eraseFromParent();
    return true;
  }
  return false;
}

class PairWords {
 public:
  explicit PairWords(Function& function) : function_(function) {}

  bool run();

 private:
  Value* word(Value* pair);
  Value* write_word(Instruction& inst);
  Value* write_operation(BinaryOperator& inst, IRBuilder<>& builder);
  Value* write_intrinsic(IntrinsicInst& inst, IRBuilder<>& builder);
  static Value* write_splat(Instruction& inst, IRBuilder<>& builder);
  Value* write_half(Instruction& inst);
  void finish_phis();
  void replace_pairs();

  Function& function_;
  DenseMap<Value*, Value*> words_;
  SmallVector<Instruction*, 16> pairs_;  // in the order in which they are computed
};

Value* PairWords::word(Value* pair) {
  if (Value* known = words_.lookup(pair); known != nullptr)
    return known;
  Type* type = Type::getInt32Ty(function_.getContext());
  if (auto* constant = dyn_cast<Constant>(pair))
    return ConstantExpr::getBitCast(constant, type);
  IRBuilder<> builder(function_.getContext());
  if (auto* inst = dyn_cast<Instruction>(pair))
    builder.SetInsertPoint(*inst->getInsertionPointAfterDef());
  else
    builder.SetInsertPointPastAllocas(&function_);
  return words_[pair] = builder.CreateBitCast(pair, type);
}

Value* PairWords::write_operation(BinaryOperator& inst, IRBuilder<>& builder) {
  Value* left = inst.getOperand(0);
  Value* right = inst.getOperand(1);
  const APInt* by = nullptr;
  Value* a = nullptr;
  Value* b = nullptr;
  switch (inst.getOpcode()) {
    case Instruction::Add:
      if (is_mean(inst, a, b))
        return builder.CreateTrunc(
            call_named(builder, "both_half_2x16", {word(a), word(b)}, builder.getInt64Ty()),
            builder.getInt32Ty());
      return call_named(builder, "add_i2x16", {word(left), word(right)});
    case Instruction::Sub:
      return call_named(builder, "sub_i2x16", {word(left), word(right)});
    case Instruction::And:
    case Instruction::Or:
    case Instruction::Xor:
      return builder.CreateBinOp(inst.getOpcode(), word(left), word(right));
    case Instruction::Shl:
    case Instruction::LShr:
    case Instruction::AShr: {
      if (!match(right, m_APInt(by)) || by->uge(kHalfBits))
        return nullptr;
      const auto count = static_cast<int16_t>(by->getZExtValue());
      const bool left_shift = inst.getOpcode() == Instruction::Shl;
      return call_named(
          builder, inst.getOpcode() == Instruction::AShr ? "shl_fr2x16" : "lshl_fr2x16",
          {word(left), builder.getInt16(static_cast<uint16_t>(left_shift ? count : -count))});
    }
    default:
      return nullptr;
  }
}

Value* PairWords::write_intrinsic(IntrinsicInst& inst, IRBuilder<>& builder) {
  if (Value* value = saturated_amount(inst))
    return call_named(builder, "abs_fr2x16", {word(value)});
  Value* first = word(inst.getArgOperand(0));
  if (inst.getIntrinsicID() == Intrinsic::abs) {
    // The instruction saturates: the least number would become the greatest.
    const bool fits = match(inst.getArgOperand(1), m_One()) ||
                      ComputeNumSignBits(inst.getArgOperand(0), inst.getDataLayout()) > 1;
    if (fits)
      return call_named(builder, "abs_fr2x16", {first});
    Value* negative = call_named(builder, "sub_i2x16", {builder.getInt32(0), first});
    return call_named(builder, "max_fr2x16", {first, negative});
  }
  const StringRef name = name_of(inst.getIntrinsicID());
  return name.empty() ? nullptr : call_named(builder, name, {first, word(inst.getArgOperand(1))});
}

Value* PairWords::write_splat(Instruction& inst, IRBuilder<>& builder) {
  Value* half = getSplatValue(&inst);
  return half == nullptr ? nullptr : call_named(builder, "compose_2x16", {half, half});
}

Value* PairWords::write_word(Instruction& inst) {
  IRBuilder<> builder(&inst);
  if (auto* load = dyn_cast<LoadInst>(&inst)) {
    if (!load->isSimple() || load->getAlign() < kWord)
      return nullptr;
    LoadInst* whole = builder.CreateAlignedLoad(builder.getInt32Ty(), load->getPointerOperand(),
                                                load->getAlign());
    whole->setAAMetadata(load->getAAMetadata());
    return whole;
  }
  if (auto* phi = dyn_cast<PHINode>(&inst))
    return builder.CreatePHI(builder.getInt32Ty(), phi->getNumIncomingValues());
  if (auto* operation = dyn_cast<BinaryOperator>(&inst))
    return write_operation(*operation, builder);
  if (auto* intrinsic = dyn_cast<IntrinsicInst>(&inst);
      intrinsic != nullptr && (intrinsic->getIntrinsicID() == Intrinsic::abs ||
                               !name_of(intrinsic->getIntrinsicID()).empty()))
    return write_intrinsic(*intrinsic, builder);
  return isa<ShuffleVectorInst>(inst) ? write_splat(inst, builder) : nullptr;
}

void PairWords::finish_phis() {
  for (Instruction* pair : pairs_)
    if (auto* phi = dyn_cast<PHINode>(pair))
      for (const auto& [value, block] : zip(phi->incoming_values(), phi->blocks()))
        cast<PHINode>(words_[phi])->addIncoming(word(value), block);
}

void PairWords::replace_pairs() {
  for (Instruction& inst : make_early_inc_range(instructions(function_))) {
    auto* store = dyn_cast<StoreInst>(&inst);
    if (store == nullptr || !is_pair_type(store->getValueOperand()->getType()) ||
        !store->isSimple() || store->getAlign() < kWord)
      continue;
    IRBuilder<> builder(store);
    StoreInst* whole = builder.CreateAlignedStore(word(store->getValueOperand()),
                                                  store->getPointerOperand(), store->getAlign());
    whole->setAAMetadata(store->getAAMetadata());
    store->eraseFromParent();
  }
  for (Instruction* pair : reverse(pairs_)) {
    if (!pair->use_empty()) {
      auto* known = cast<Instruction>(words_[pair]);
      IRBuilder<> builder(known->getContext());
      builder.SetInsertPoint(*known->getInsertionPointAfterDef());
      pair->replaceAllUsesWith(builder.CreateBitCast(known, pair->getType()));
    }
    pair->eraseFromParent();
  }
}

/// A half alone, of what selection has no form of its own for.
Value* PairWords::write_half(Instruction& inst) {
  IRBuilder<> builder(&inst);
  if (Value* value = saturated_amount(inst))
    return call_named(builder, "abs_fr1x16", {value}, inst.getType());
  Value* a = nullptr;
  Value* b = nullptr;
  if (auto* all = dyn_cast<IntrinsicInst>(&inst);
      all != nullptr && (all->getIntrinsicID() == Intrinsic::vector_reduce_smin ||
                         all->getIntrinsicID() == Intrinsic::vector_reduce_smax)) {
    if (!is_pair_type(all->getArgOperand(0)->getType()))
      return nullptr;
    Value* both = word(all->getArgOperand(0));
    return builder.CreateBinaryIntrinsic(
        getMinMaxReductionIntrinsicOp(all->getIntrinsicID()),
        builder.CreateTrunc(both, inst.getType()),
        builder.CreateTrunc(builder.CreateLShr(both, kHalfBits), inst.getType()));
  }
  if (is_mean(inst, a, b)) {
    Type* wide = builder.getInt32Ty();
    Value* sum = builder.CreateAdd(builder.CreateSExt(a, wide), builder.CreateSExt(b, wide));
    return builder.CreateTrunc(builder.CreateAShr(sum, 1), inst.getType());
  }
  if (match(&inst, m_Intrinsic<Intrinsic::ssub_sat>(m_Zero(), m_Value(a))))
    return call_named(builder, "negate_fr1x16", {a}, inst.getType());
  if (match(&inst, m_Intrinsic<Intrinsic::smul_fix_sat>(m_Value(a), m_Value(b),
                                                        m_SpecificInt(kHalfBits - 1)))) {
    if (may_be_least(a) && may_be_least(b))
      return call_named(builder, "mult_fr1x16", {a, b}, inst.getType());
    Type* wide = builder.getInt32Ty();
    Value* product = builder.CreateMul(builder.CreateSExt(a, wide), builder.CreateSExt(b, wide));
    return builder.CreateTrunc(builder.CreateAShr(product, kHalfBits - 1), inst.getType());
  }
  return nullptr;
}

bool PairWords::run() {
  SmallVector<Instruction*, 32> all;
  for (BasicBlock* block : ReversePostOrderTraversal<Function*>(&function_))
    for (Instruction& inst : *block)
      if (is_pair_type(inst.getType()) || inst.getType()->isIntegerTy(kHalfBits))
        all.push_back(&inst);
  bool changed = false;
  for (Instruction* inst : all) {
    if (is_pair_type(inst->getType())) {
      if (Value* written = write_word(*inst)) {
        words_[inst] = written;
        pairs_.push_back(inst);
      }
    } else if (Value* half = write_half(*inst)) {
      inst->replaceAllUsesWith(half);
      inst->eraseFromParent();
      changed = true;
    }
  }
  finish_phis();
  for (BasicBlock& block : function_)
    for (PHINode& phi : make_early_inc_range(block.phis()))
      changed |= phi.getType()->isIntegerTy(kHalfBits) && widen_extreme(phi);
  changed |= !pairs_.empty();
  replace_pairs();
  if (changed)
    for (BasicBlock& block : function_)
      SimplifyInstructionsInBlock(&block);
  return changed;
}

}  // namespace

Value* write_mean(Value* a, Value* b, IRBuilder<>& builder) {
  return builder.CreateAdd(builder.CreateAnd(a, b), builder.CreateAShr(builder.CreateXor(a, b), 1));
}

PreservedAnalyses PairWordsPass::run(Function& function, FunctionAnalysisManager&) {
  if (!PairWords(function).run())
    return PreservedAnalyses::all();
  PreservedAnalyses kept;
  kept.preserveSet<CFGAnalyses>();
  return kept;
}

}  // namespace finback::compiler
