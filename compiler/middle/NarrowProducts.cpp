#include "NarrowProducts.hpp"

#include <llvm/Analysis/DemandedBits.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>

#include "NamedCall.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;

constexpr unsigned kHalf = 16;

/// Selection sees by itself that such factors fit halves.
bool is_half(Value* value, const DataLayout& layout) {
  return ComputeNumSignBits(value, layout) > kHalf ||
         computeKnownBits(value, layout).countMaxActiveBits() <= kHalf;
}

bool wants_low_half(Instruction& product, DemandedBits& bits, const DataLayout& layout) {
  if (product.getOpcode() != Instruction::Mul || !product.getType()->isIntegerTy(32) ||
      isa<Constant>(product.getOperand(1)) ||
      bits.getDemandedBits(&product).getActiveBits() > kHalf)
    return false;
  return !is_half(product.getOperand(0), layout) || !is_half(product.getOperand(1), layout);
}

/// The product's other bits change, and with them what its users promise of theirs.
void forget_promises(Instruction& product, DemandedBits& bits) {
  SmallVector<Instruction*, 8> left = {&product};
  SmallPtrSet<Instruction*, 8> seen;
  while (!left.empty()) {
    Instruction* inst = left.pop_back_val();
    for (User* user : inst->users()) {
      auto* next = cast<Instruction>(user);
      if (!next->getType()->isIntegerTy() || bits.getDemandedBits(next).isAllOnes() ||
          !seen.insert(next).second)
        continue;
      next->dropPoisonGeneratingFlags();
      left.push_back(next);
    }
  }
}

}  // namespace

PreservedAnalyses NarrowProductsPass::run(Function& function, FunctionAnalysisManager& manager) {
  auto& bits = manager.getResult<DemandedBitsAnalysis>(function);
  const DataLayout& layout = function.getParent()->getDataLayout();
  SmallVector<Instruction*, 8> products;
  for (Instruction& inst : instructions(function))
    if (wants_low_half(inst, bits, layout))
      products.push_back(&inst);
  for (Instruction* product : products)
    forget_promises(*product, bits);
  for (Instruction* product : products) {
    IRBuilder<> builder(product);
    product->replaceAllUsesWith(
        call_named(builder, "mul_low", {product->getOperand(0), product->getOperand(1)}));
    product->eraseFromParent();
  }
  if (products.empty())
    return PreservedAnalyses::all();
  PreservedAnalyses kept;
  kept.preserveSet<CFGAnalyses>();
  return kept;
}

}  // namespace finback::compiler
