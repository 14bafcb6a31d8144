#include "LoopScopes.hpp"

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/CodeGen/MachineFunction.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>

namespace llvm {

LoopScopes::LoopScopes(const MachineBasicBlock& block) {
  const BasicBlock* code = block.getBasicBlock();
  if (code == nullptr)
    return;
  const DominatorTree dominators(const_cast<Function&>(*code->getParent()));
  const LoopInfo loops(dominators);
  const Loop* loop = loops.getLoopFor(code);
  if (loop == nullptr)
    return;
  SmallPtrSet<const Metadata*, 8> inside;
  for (const Instruction& inst : instructions(*code->getParent()))
    if (const auto* begin = dyn_cast<NoAliasScopeDeclInst>(&inst))
      for (const MDOperand& scope : begin->getScopeList()->operands())
        (loop->contains(&inst) ? inside : outside_).insert(scope.get());
  for (const Metadata* scope : inside)
    outside_.erase(scope);
}

AAMDNodes LoopScopes::in_every_pass(const AAMDNodes& promises) const {
  AAMDNodes kept;
  kept.TBAA = promises.TBAA;
  const auto holds = [&](const MDOperand& scope) { return outside_.contains(scope.get()); };
  if (promises.Scope != nullptr && all_of(promises.Scope->operands(), holds))
    kept.Scope = promises.Scope;
  if (promises.NoAlias == nullptr)
    return kept;
  SmallVector<Metadata*, 4> apart_from;
  for (const MDOperand& scope : promises.NoAlias->operands())
    if (holds(scope))
      apart_from.push_back(scope.get());
  if (!apart_from.empty())
    kept.NoAlias = MDNode::get(promises.NoAlias->getContext(), apart_from);
  return kept;
}

AAMDNodes promises_of(const MachineInstr& access) {
  return access.hasOneMemOperand() && !access.hasOrderedMemoryRef()
             ? (*access.memoperands_begin())->getAAInfo()
             : AAMDNodes();
}

/// Is an access of all these scopes apart from one that promises `apart_from`? All scopes of one
/// domain, that of an inlined call, must be among them.
static bool covers(const MDNode* scopes, const MDNode* apart_from) {
  if (scopes == nullptr || apart_from == nullptr)
    return false;
  const auto domain_of = [](const MDOperand& scope) {
    return AliasScopeNode(cast<MDNode>(scope.get())).getDomain();
  };
  return any_of(apart_from->operands(), [&](const MDOperand& first) {
    const auto in_domain = [&](const MDOperand& scope) {
      return domain_of(scope) == domain_of(first);
    };
    return any_of(scopes->operands(), in_domain) &&
           all_of(scopes->operands(), [&](const MDOperand& scope) {
             return !in_domain(scope) || is_contained(apart_from->operands(), scope);
           });
  });
}

bool lie_apart(const AAMDNodes& a, const AAMDNodes& b) {
  return covers(a.Scope, b.NoAlias) || covers(b.Scope, a.NoAlias);
}

}  // namespace llvm
