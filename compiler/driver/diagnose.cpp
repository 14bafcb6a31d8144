#include "diagnose.hpp"

#include <llvm/IR/CFG.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>

#include "../target/BfinMachineFunctionInfo.hpp"
#include "../target/BfinNamedInstructions.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;

bool has_vector(const Type* type) { return type->isVectorTy(); }

/// Bit-fields make wide integers, which fall into words; products and quotients do not.
bool computes_wide(const Instruction& inst) {
  if (!inst.getType()->isIntegerTy() || inst.getType()->getIntegerBitWidth() <= 64)
    return false;
  switch (inst.getOpcode()) {
    case Instruction::Mul:
    case Instruction::SDiv:
    case Instruction::UDiv:
    case Instruction::SRem:
    case Instruction::URem:
      return true;
    default:
      return inst.isShift() && !isa<ConstantInt>(inst.getOperand(1));
  }
}

std::string problem_of_assembly(const CallBase& call) {
  if (isa<CallBrInst>(call))
    return "asm goto is not supported";
  const DataLayout& layout = call.getModule()->getDataLayout();
  const auto too_big = [&](const Type* type) {
    return type->isSized() && !type->isVoidTy() &&
           layout.getTypeSizeInBits(const_cast<Type*>(type)) > 32;
  };
  const auto* results = dyn_cast<StructType>(call.getType());
  const bool big_result =
      results == nullptr ? too_big(call.getType()) : any_of(results->elements(), too_big);
  if (big_result || any_of(call.args(), [&](const Use& use) { return too_big(use->getType()); }))
    return "an operand of inline assembly has at most 32 bits";
  return "";
}

/// Arguments are words on the stack: a struct by value is an array of them, which takes the back
/// end time by the square of its length.
constexpr uint64_t kLargestArgument = 16384;

std::string problem_of_arguments(const CallBase& call) {
  const DataLayout& layout = call.getModule()->getDataLayout();
  for (const Use& argument : call.args())
    if (argument->getType()->isArrayTy() &&
        layout.getTypeAllocSize(argument->getType()) > kLargestArgument)
      return "a struct of " + std::to_string(layout.getTypeAllocSize(argument->getType())) +
             " bytes is passed by value; pass its address (by value: at most " +
             std::to_string(kLargestArgument) + " bytes)";
  return "";
}

/// Where clang rounds a pointer to variable arguments up for a type: callers align none of them.
bool aligns_variable_argument(const CallBase& call) {
  return call.getIntrinsicID() == Intrinsic::ptrmask && call.getName().starts_with("argp.cur") &&
         call.getName().contains(".aligned");
}

std::string problem_of_call(const CallBase& call) {
  if (call.isInlineAsm())
    return problem_of_assembly(call);
  if (aligns_variable_argument(call))
    return "va_arg of a type that is aligned to more than 4 bytes is not supported";
  if (call.getIntrinsicID() == Intrinsic::returnaddress ||
      call.getIntrinsicID() == Intrinsic::frameaddress)
    return "addresses of frames and to return to are not supported";
  if (isNamedInstruction(call.getCalledFunction()))
    return problemOfNamedInstruction(call);
  return problem_of_arguments(call);
}

std::string problem_of(const Instruction& inst) {
  if (isa<AtomicRMWInst>(inst) || isa<AtomicCmpXchgInst>(inst))
    return "atomic read-modify-write is not supported; use __builtin_bfin_testset or cli/sti";
  if (has_vector(inst.getType()))
    return "vector types are not supported";
  if (computes_wide(inst))
    return "products, quotients and variable shifts of integers wider than 64 bits are not "
           "supported";
  if (const auto* call = dyn_cast<CallBase>(&inst))
    return problem_of_call(*call);
  return "";
}

/// BIR's data are numbers and addresses.
bool subtracts_addresses(const Constant* constant) {
  const auto* expression = dyn_cast<ConstantExpr>(constant);
  if (expression != nullptr && expression->getOpcode() == Instruction::Sub)
    return true;
  return !isa<GlobalValue, BlockAddress>(constant) &&
         any_of(constant->operands(),
                [](const Use& use) { return subtracts_addresses(cast<Constant>(use)); });
}

/// The instruction's place; where all jumps of a kind share one, that of a jump to it.
DebugLoc location_of(const Instruction& inst) {
  DebugLoc loc = inst.getDebugLoc();
  for (const BasicBlock* before : predecessors(inst.getParent()))
    if (!loc)
      loc = before->getTerminator()->getDebugLoc();
  return loc;
}

std::string place(const Function& function, const DebugLoc& loc, const std::string& input) {
  if (loc && loc.getLine() != 0)
    return (loc->getFilename() + ":" + Twine(loc.getLine()) + ":" + Twine(loc.getCol())).str();
  if (const DISubprogram* sub = function.getSubprogram())
    return (sub->getFilename() + ":" + Twine(sub->getLine()) + ":1").str();
  return input + ":1:1";
}

}  // namespace

std::vector<std::string> unsupported_constructs(const Module& module, const std::string& input) {
  std::vector<std::string> messages;
  auto add = [&](const std::string& where, const std::string& what) {
    std::string message = where + ": error: " + what;
    if (!what.empty() && !is_contained(messages, message))
      messages.push_back(std::move(message));
  };
  for (const Function& function : module) {
    std::string start = place(function, DebugLoc(), input);
    if (isInterruptHandler(function) &&
        (!function.arg_empty() || !function.getReturnType()->isVoidTy()))
      add(start, "an interrupt handler takes no arguments and returns nothing");
    for (const Instruction& inst : instructions(function))
      add(place(function, location_of(inst), input), problem_of(inst));
  }
  for (const GlobalVariable& global : module.globals()) {
    if (global.isThreadLocal())
      add(input + ":1:1", ("thread-local '" + global.getName() + "' is not supported").str());
    if (global.hasInitializer() && subtracts_addresses(global.getInitializer()))
      add(input + ":1:1", ("a difference of addresses in what '" + global.getName() +
                           "' begins with is not supported; compute it where it is used")
                              .str());
  }
  for (const char* list : {"llvm.global_ctors", "llvm.global_dtors"})
    if (const GlobalVariable* functions = module.getGlobalVariable(list))
      add(input + ":1:1",
          "objects and functions that want code before main or after it are not "
          "supported (" +
              functions->getName().drop_front(5).str() + ")");
  if (!module.getModuleInlineAsm().empty())
    add(input + ":1:1", "assembly outside functions is not supported; write it in a .bir file");
  if (!module.alias_empty() || !module.ifunc_empty())
    add(input + ":1:1", "aliases are not supported");
  return messages;
}

}  // namespace finback::compiler
