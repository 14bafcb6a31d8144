#include "Alignment.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>
#include <llvm/Transforms/Utils/ScalarEvolutionExpander.h>

namespace finback::compiler {

using namespace llvm;

bool is_aligned(const SCEV* value, ScalarEvolution& scev) {
  return scev.getMinTrailingZeros(value) >= 2;
}

bool can_expand(ArrayRef<const SCEV*> values, ScalarEvolution& scev, Instruction* at) {
  SCEVExpander expander(scev, at->getModule()->getDataLayout(), "test");
  return all_of(values, [&](const SCEV* value) { return expander.isSafeToExpandAt(value, at); });
}

Value* write_test(const SCEV* rounds, unsigned least, ArrayRef<const SCEV*> values,
                  ScalarEvolution& scev, Instruction* at) {
  SCEVExpander expander(scev, at->getModule()->getDataLayout(), "test");
  IRBuilder<> builder(at);
  Value* test = builder.getTrue();
  if (!scev.isKnownPredicate(CmpInst::ICMP_UGE, rounds, scev.getConstant(rounds->getType(), least)))
    test = builder.CreateICmpUGE(expander.expandCodeFor(rounds, rounds->getType(), at),
                                 builder.getInt32(least));
  Value* bits = builder.getInt32(0);
  for (const SCEV* value : values) {
    if (is_aligned(value, scev))
      continue;
    Value* number = expander.expandCodeFor(value, value->getType(), at);
    bits = builder.CreateOr(bits, builder.CreatePtrToInt(number, builder.getInt32Ty()));
  }
  Value* rest = builder.CreateAnd(bits, builder.getInt32(3));
  return builder.CreateAnd(test, builder.CreateICmpEQ(rest, builder.getInt32(0)));
}

}  // namespace finback::compiler
