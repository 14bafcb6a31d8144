// A call of one of the back end's named instructions (target/BfinNamedInstructions.cpp) by a pass
// of the middle end: arguments of the types that its table says, nothing else touched.
#pragma once

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

namespace finback::compiler {

/// `result`: its type; without one a word.
inline llvm::Value* call_named(llvm::IRBuilder<>& builder, llvm::StringRef name,
                               llvm::ArrayRef<llvm::Value*> arguments,
                               llvm::Type* result = nullptr) {
  using llvm::Attribute;
  llvm::LLVMContext& context = builder.getContext();
  llvm::AttributeList attributes;
  for (const Attribute::AttrKind kind : {Attribute::NoUnwind, Attribute::WillReturn})
    attributes = attributes.addFnAttribute(context, kind);
  attributes = attributes.addFnAttribute(
      context, Attribute::getWithMemoryEffects(context, llvm::MemoryEffects::none()));
  llvm::SmallVector<llvm::Type*, 4> types;
  for (const llvm::Value* argument : arguments)
    types.push_back(argument->getType());
  if (result == nullptr)
    result = builder.getInt32Ty();
  llvm::Module& module = *builder.GetInsertBlock()->getModule();
  const llvm::FunctionCallee callee = module.getOrInsertFunction(
      ("__builtin_bfin_" + name).str(), llvm::FunctionType::get(result, types, false), attributes);
  return builder.CreateCall(callee, arguments);
}

}  // namespace finback::compiler
