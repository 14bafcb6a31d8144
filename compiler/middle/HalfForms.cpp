#include "HalfForms.hpp"

#include <llvm/ADT/StringSwitch.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Module.h>
#include <llvm/IR/PatternMatch.h>

namespace finback::compiler {
namespace {

using namespace llvm;
using namespace PatternMatch;

constexpr unsigned kFractionBits = 15;

/// Is the value what its low 16 bits are, extended by zeros?
bool fits_unsigned(const Value* value, const DataLayout& layout) {
  return is_half(value) ||
         MaskedValueIsZero(value, APInt::getHighBitsSet(2 * kHalfBits, kHalfBits), layout);
}

/// a * b >> 15 and one more, (a + b) >> 1: more than 16 bits come down.
HalfForm form_of_wide_shift(Value* from, unsigned by, const DataLayout& layout) {
  Value* a = nullptr;
  Value* b = nullptr;
  const bool fraction =
      (by == kFractionBits || by == kHalfBits) && match(from, m_Mul(m_Value(a), m_Value(b)));
  const bool mean = by == 1 && match(from, m_Add(m_Value(a), m_Value(b)));
  if (!(fraction || mean) || !fits_signed(a, layout) || !fits_signed(b, layout) ||
      (fraction && may_be_least(a) && may_be_least(b)))
    return {};
  const auto* inst = dyn_cast<Instruction>(from);
  HalfForm form{HalfForm::mean, 0, 0, {a, b}, {}};
  if (fraction)
    form = {HalfForm::intrinsic, Intrinsic::smul_fix_sat, by - kFractionBits, {a, b}, {}};
  if (inst != nullptr)
    form.within.push_back(inst);
  return form;
}

HalfForm form_of_shift(const BinaryOperator& shift, const DataLayout& layout) {
  const APInt* amount = nullptr;
  if (!match(shift.getOperand(1), m_APInt(amount)))
    return {};
  const auto by = static_cast<unsigned>(amount->getLimitedValue(uint64_t{2} * kHalfBits));
  Value* from = shift.getOperand(0);
  const bool narrow = is_half(&shift);
  if (by == 0 || by > (narrow ? kHalfBits - 1 : kHalfBits))
    return {};
  HalfForm form{HalfForm::shift, shift.getOpcode(), by, {from}, {}};
  if (narrow || (shift.getOpcode() == Instruction::Shl && by < kHalfBits))
    return form;
  if (shift.getOpcode() == Instruction::Shl)
    return {};
  if (HalfForm wide = form_of_wide_shift(from, by, layout); wide.kind != HalfForm::none)
    return wide;
  // Of an extended half, sign bits come down also in a logical shift of the word.
  if (fits_signed(from, layout))
    return {HalfForm::shift, Instruction::AShr, std::min(by, kHalfBits - 1), {from}, {}};
  if (fits_unsigned(from, layout) && by < kHalfBits)
    return {HalfForm::shift, Instruction::LShr, by, {from}, {}};
  return {};
}

/// What stands between a value and those that its form begins with.
void add_between(const Instruction& inst, ArrayRef<Value*> ends,
                 SmallVectorImpl<const Instruction*>& between) {
  for (const Use& use : inst.operands()) {
    const auto* operand = dyn_cast<Instruction>(use.get());
    if (operand == nullptr || operand->getParent() != inst.getParent() ||
        is_contained(ends, operand) || is_contained(between, operand))
      continue;
    between.push_back(operand);
    add_between(*operand, ends, between);
  }
}

/// abs(a - b), which has 17 bits before it has 16, and a > b ? a - b : b - a: the greater one less
/// the other one.
HalfForm form_of_distance(Value* value, const DataLayout& layout) {
  Value* a = nullptr;
  Value* b = nullptr;
  ICmpInst::Predicate predicate{};
  const auto greater_less_other = [&](auto first, auto second) {
    return match(value, m_Select(m_ICmp(predicate, m_Value(a), m_Value(b)), m_Sub(first, second),
                                 m_Sub(second, first)));
  };
  const bool known = match(value, m_Intrinsic<Intrinsic::abs>(m_Sub(m_Value(a), m_Value(b)))) ||
                     (greater_less_other(m_Deferred(a), m_Deferred(b)) &&
                      (predicate == ICmpInst::ICMP_SGT || predicate == ICmpInst::ICMP_SGE)) ||
                     (greater_less_other(m_Deferred(b), m_Deferred(a)) &&
                      (predicate == ICmpInst::ICMP_SLT || predicate == ICmpInst::ICMP_SLE));
  if (!known)
    return {};
  // The amount of a half's difference is another one.
  if ((is_half(value) && !isa<SelectInst>(value)) || !fits_signed(a, layout) ||
      !fits_signed(b, layout))
    return {};
  HalfForm form{HalfForm::distance, 0, 0, {a, b}, {}};
  add_between(*cast<Instruction>(value), {a, b}, form.within);
  return form;
}

HalfForm form_of_call(const CallBase& call, const DataLayout& layout) {
  const Function* callee = call.getCalledFunction();
  if (callee == nullptr)
    return {};
  const auto operands = SmallVector<Value*, 2>(call.args());
  const auto all_fit = [&](ArrayRef<Value*> values) {
    return all_of(values, [&](const Value* value) { return fits_signed(value, layout); });
  };
  const Intrinsic::ID id = call.getIntrinsicID();
  switch (id) {
    case Intrinsic::smin:
    case Intrinsic::smax:
      return all_fit(operands) ? HalfForm{HalfForm::intrinsic, id, 0, operands, {}} : HalfForm{};
    case Intrinsic::sadd_sat:
    case Intrinsic::ssub_sat:
      return is_half(&call) ? HalfForm{HalfForm::intrinsic, id, 0, operands, {}} : HalfForm{};
    case Intrinsic::abs:
      return all_fit(operands[0]) ? HalfForm{HalfForm::intrinsic, id, 0, {operands[0]}, {}}
                                  : HalfForm{};
    default:
      break;
  }
  if (callee->getName() == "__builtin_bfin_negate_fr1x16")
    return {HalfForm::negated, 0, 0, operands, {}};
  if (callee->getName() == "__builtin_bfin_abs_fr1x16")
    return {HalfForm::amount, 0, 0, operands, {}};
  const unsigned named = StringSwitch<unsigned>(callee->getName())
                             .Case("__builtin_bfin_add_fr1x16", Intrinsic::sadd_sat)
                             .Case("__builtin_bfin_sub_fr1x16", Intrinsic::ssub_sat)
                             .Case("__builtin_bfin_min_fr1x16", Intrinsic::smin)
                             .Case("__builtin_bfin_max_fr1x16", Intrinsic::smax)
                             .Case("__builtin_bfin_mult_fr1x16", Intrinsic::smul_fix_sat)
                             .Default(0);
  return named == 0 ? HalfForm{} : HalfForm{HalfForm::intrinsic, named, 0, operands, {}};
}

/// a * b < 32767 << 15 ? (short)(a * b >> 15) : 32767, as the middle end writes it at times.
bool is_compared_fraction(Value* value, Value*& product) {
  return match(value, m_Select(m_SpecificICmp(ICmpInst::ICMP_SLT, m_Value(product),
                                              m_SpecificInt(uint64_t{INT16_MAX} << kFractionBits)),
                               m_Trunc(m_Shr(m_Deferred(product), m_SpecificInt(kFractionBits))),
                               m_SpecificInt(uint64_t{INT16_MAX})));
}

/// clamp(a + b), clamp(a - b), and min(a * b >> 15, 32767), which alone passes 32767.
HalfForm form_of_saturation(Value* value, const DataLayout& layout) {
  const auto least = m_SpecificInt(uint64_t{static_cast<uint32_t>(INT16_MIN)});
  const auto most = m_SpecificInt(uint64_t{INT16_MAX});
  Value* wide = nullptr;
  Value* product = nullptr;
  Value* a = nullptr;
  Value* b = nullptr;
  const bool narrow = is_half(value);
  const bool both = !narrow && (match(value, m_SMin(m_SMax(m_Value(wide), least), most)) ||
                                match(value, m_SMax(m_SMin(m_Value(wide), most), least)));
  const bool fraction =
      narrow ? is_compared_fraction(value, product)
             : (both || match(value, m_SMin(m_Value(wide), most))) &&
                   match(wide, m_AShr(m_Value(product), m_SpecificInt(kFractionBits)));
  unsigned code = 0;
  if (fraction && match(product, m_Mul(m_Value(a), m_Value(b))))
    code = Intrinsic::smul_fix_sat;
  else if (both && match(wide, m_Add(m_Value(a), m_Value(b))))
    code = Intrinsic::sadd_sat;
  else if (both && match(wide, m_Sub(m_Value(a), m_Value(b))))
    code = Intrinsic::ssub_sat;
  if (code == 0 || !fits_signed(a, layout) || !fits_signed(b, layout))
    return {};
  HalfForm form{HalfForm::intrinsic, code, 0, {a, b}, {}};
  add_between(*cast<Instruction>(value), {a, b}, form.within);
  return form;
}

}  // namespace

bool may_be_least(const Value* value) {
  const APInt least(value->getType()->getIntegerBitWidth(), INT16_MIN, /*isSigned=*/true);
  return computeConstantRange(value, /*ForSigned=*/true).contains(least);
}

bool fits_signed(const Value* value, const DataLayout& layout) {
  return is_half(value) || ComputeNumSignBits(value, layout) > kHalfBits;
}

HalfForm form_of(Value* value, const Loop& loop) {
  const auto* inst = dyn_cast<Instruction>(value);
  if (inst == nullptr || !loop.contains(inst))
    return {HalfForm::invariant, 0, 0, {}, {}};
  const DataLayout& layout = inst->getDataLayout();
  if (const auto* load = dyn_cast<LoadInst>(inst))
    return {load->isSimple() ? HalfForm::loaded : HalfForm::none, 0, 0, {}, {}};
  if (HalfForm saturation = form_of_saturation(value, layout); saturation.kind != HalfForm::none)
    return saturation;
  if (HalfForm distance = form_of_distance(value, layout); distance.kind != HalfForm::none)
    return distance;
  if (const auto* call = dyn_cast<CallBase>(inst))
    return form_of_call(*call, layout);
  switch (inst->getOpcode()) {
    case Instruction::SExt:
    case Instruction::ZExt:
      return {is_half(inst->getOperand(0)) ? HalfForm::same : HalfForm::none,
              0,
              0,
              {inst->getOperand(0)},
              {}};
    case Instruction::Trunc:
      return {HalfForm::same, 0, 0, {inst->getOperand(0)}, {}};
    case Instruction::Add:
    case Instruction::Sub:
    case Instruction::And:
    case Instruction::Or:
    case Instruction::Xor:
      return {HalfForm::operation,
              inst->getOpcode(),
              0,
              {inst->getOperand(0), inst->getOperand(1)},
              {}};
    case Instruction::Shl:
    case Instruction::LShr:
    case Instruction::AShr:
      return form_of_shift(*cast<BinaryOperator>(inst), layout);
    default:
      return {};
  }
}

}  // namespace finback::compiler
