// A call of one of the back end's named instructions (target/BfinNamedInstructions.cpp) by a pass
// of the middle end: words in, a word out, nothing else touched.
#pragma once

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

namespace finback::compiler {

inline llvm::Value* call_named(llvm::IRBuilder<>& builder, llvm::StringRef name,
                               llvm::ArrayRef<llvm::Value*> arguments) {
  using llvm::Attribute;
  llvm::LLVMContext& context = builder.getContext();
  llvm::AttributeList attributes;
  for (const Attribute::AttrKind kind : {Attribute::NoUnwind, Attribute::WillReturn})
    attributes = attributes.addFnAttribute(context, kind);
  attributes = attributes.addFnAttribute(
      context, Attribute::getWithMemoryEffects(context, llvm::MemoryEffects::none()));
  const llvm::SmallVector<llvm::Type*, 4> words(arguments.size(), builder.getInt32Ty());
  llvm::Module& module = *builder.GetInsertBlock()->getModule();
  const llvm::FunctionCallee callee = module.getOrInsertFunction(
      ("__builtin_bfin_" + name).str(), llvm::FunctionType::get(builder.getInt32Ty(), words, false),
      attributes);
  return builder.CreateCall(callee, arguments);
}

}  // namespace finback::compiler
