#include "SaturatedShifts.hpp"

#include <llvm/IR/InstIterator.h>
#include <llvm/IR/PatternMatch.h>

#include "NamedCall.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;
using namespace PatternMatch;

constexpr unsigned kHalfWord = 16;

/// value = clamp(sum >> by, -32768, 32767), where sum may be word + 2^(by - 1), which does not
/// overflow.
struct Match {
  Instruction* value = nullptr;
  Value* word = nullptr;
  unsigned by = 0;
  bool rounded = false;
};

bool match_saturated(Instruction& inst, Match& match) {
  Value* shifted = nullptr;
  Value* sum = nullptr;
  const APInt* by = nullptr;
  const auto least = m_SpecificInt(uint64_t{static_cast<uint32_t>(INT16_MIN)});
  const auto most = m_SpecificInt(uint64_t{INT16_MAX});
  if (!inst.getType()->isIntegerTy(32) ||
      (!PatternMatch::match(&inst, m_SMin(m_OneUse(m_SMax(m_Value(shifted), least)), most)) &&
       !PatternMatch::match(&inst, m_SMax(m_OneUse(m_SMin(m_Value(shifted), most)), least))) ||
      !PatternMatch::match(shifted, m_OneUse(m_AShr(m_Value(sum), m_APInt(by)))) ||
      by->uge(kHalfWord) || by->isZero())
    return false;
  match.value = &inst;
  match.by = static_cast<unsigned>(by->getZExtValue());
  match.rounded = PatternMatch::match(
      sum, m_OneUse(m_NSWAdd(m_Value(match.word), m_SpecificInt(uint64_t{1} << (match.by - 1)))));
  if (!match.rounded)
    match.word = sum;
  return true;
}

}  // namespace

PreservedAnalyses SaturatedShiftsPass::run(Function& function, FunctionAnalysisManager&) {
  SmallVector<Match, 8> matches;
  for (Instruction& inst : instructions(function))
    if (Match match; match_saturated(inst, match))
      matches.push_back(match);
  for (const Match& match : matches) {
    IRBuilder<> builder(match.value);
    Value* upper =
        call_named(builder, "shl_fr1x32", {match.word, builder.getInt32(kHalfWord - match.by)});
    Value* half = match.rounded ? call_named(builder, "round_fr1x32", {upper})
                                : builder.CreateAShr(upper, kHalfWord);
    match.value->replaceAllUsesWith(half);
  }
  if (matches.empty())
    return PreservedAnalyses::all();
  PreservedAnalyses kept;
  kept.preserveSet<CFGAnalyses>();
  return kept;
}

}  // namespace finback::compiler
