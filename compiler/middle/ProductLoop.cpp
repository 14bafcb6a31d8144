#include "ProductLoop.hpp"

#include <llvm/IR/PatternMatch.h>

namespace finback::compiler {
namespace {

using namespace llvm;
using namespace llvm::PatternMatch;

bool match_factor(Value* value, const Loop& loop, ScalarEvolution& scev, Factor& factor) {
  Value* half = nullptr;
  if (!match(value, m_SExt(m_Value(half))))
    return false;
  factor.load = dyn_cast<LoadInst>(half);
  if (factor.load == nullptr || !factor.load->isSimple() ||
      !factor.load->getType()->isIntegerTy(16) || factor.load->getPointerAddressSpace() != 0 ||
      factor.load->getParent() != loop.getHeader())
    return false;
  const auto* address = dyn_cast<SCEVAddRecExpr>(scev.getSCEV(factor.load->getPointerOperand()));
  if (address == nullptr || address->getLoop() != &loop || !address->isAffine())
    return false;
  factor.start = address->getStart();
  factor.step = address->getStepRecurrence(scev);
  return true;
}

bool match_sum(PHINode& phi, const Loop& loop, ScalarEvolution& scev, ProductSum& sum) {
  Value* left = nullptr;
  Value* right = nullptr;
  Value* next = phi.getIncomingValueForBlock(loop.getLoopLatch());
  if (!phi.getType()->isIntegerTy(32) || !phi.hasOneUse() ||
      !match(next, m_c_Add(m_Specific(&phi), m_OneUse(m_Mul(m_Value(left), m_Value(right))))))
    return false;
  sum.phi = &phi;
  sum.next = dyn_cast<BinaryOperator>(next);
  return sum.next != nullptr && sum.next->getParent() == loop.getHeader() &&
         match_factor(left, loop, scev, sum.factors[0]) &&
         match_factor(right, loop, scev, sum.factors[1]);
}

/// Nothing but the sums may be wanted of the loop, and nothing else happen in it.
bool only_sums(const ProductLoop& products) {
  for (const Instruction& inst : *products.loop->getHeader()) {
    if (inst.mayHaveSideEffects() || (isa<LoadInst>(inst) && !cast<LoadInst>(inst).isSimple()))
      return false;
    const bool is_next =
        any_of(products.sums, [&](const ProductSum& sum) { return sum.next == &inst; });
    for (const User* user : inst.users()) {
      const bool outside = !products.loop->contains(cast<Instruction>(user));
      const bool own_phi =
          is_next && any_of(products.sums, [&](const ProductSum& sum) { return sum.phi == user; });
      if (is_next ? !outside && !own_phi : outside)
        return false;
    }
  }
  return true;
}

}  // namespace

Value* ProductSum::start() const {
  return phi->getIncomingValue(phi->getIncomingBlock(0) == phi->getParent() ? 1 : 0);
}

bool goes_by_halves(const Factor& factor) {
  const auto* step = dyn_cast<SCEVConstant>(factor.step);
  return step != nullptr && step->getAPInt() == 2;
}

std::optional<ProductLoop> match_product_loop(Loop& loop, ScalarEvolution& scev) {
  if (loop.getNumBlocks() != 1 || loop.getLoopPreheader() == nullptr ||
      loop.getExitBlock() == nullptr)
    return std::nullopt;
  const SCEV* again = scev.getBackedgeTakenCount(&loop);
  if (isa<SCEVCouldNotCompute>(again) || again->getType()->getScalarSizeInBits() > 32)
    return std::nullopt;
  Type* word = Type::getInt32Ty(loop.getHeader()->getContext());
  ProductLoop products{&loop, {}, nullptr};
  products.rounds = scev.getAddExpr(scev.getNoopOrZeroExtend(again, word), scev.getOne(word));
  for (PHINode& phi : loop.getHeader()->phis()) {
    ProductSum sum{};
    const auto* steps = dyn_cast<SCEVAddRecExpr>(scev.getSCEV(&phi));
    if (match_sum(phi, loop, scev, sum))
      products.sums.push_back(sum);
    else if (steps == nullptr || steps->getLoop() != &loop || !steps->isAffine())
      return std::nullopt;
  }
  if (products.sums.empty() || products.sums.size() > 2 || !only_sums(products))
    return std::nullopt;
  return products;
}

}  // namespace finback::compiler
