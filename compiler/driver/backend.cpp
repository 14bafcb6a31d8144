#include "backend.hpp"

#include <llvm/CodeGen/MachineModuleInfo.h>
#include <llvm/CodeGen/Passes.h>
#include <llvm/CodeGen/TargetPassConfig.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/LegacyPassManager.h>
#include <llvm/MC/MCInstPrinter.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Support/raw_ostream.h>

#include "../middle/AbsoluteDifferences.hpp"
#include "../middle/CircularBuffers.hpp"
#include "../middle/NarrowProducts.hpp"
#include "../middle/PairWords.hpp"
#include "../middle/Products.hpp"
#include "../middle/SaturatedShifts.hpp"
#include "../middle/VectorLoops.hpp"
#include "../target/Bfin.hpp"
#include "../target/BfinAsmPrinter.hpp"
#include "../target/BfinMCTargetDesc.hpp"
#include "../target/BfinMachineFunctionInfo.hpp"
#include "../target/BfinNamedInstructions.hpp"
#include "../target/BfinTargetMachine.hpp"
#include "../target/BirStreamer.hpp"

namespace finback::compiler {
namespace {

using namespace llvm;

void mark_handlers(Module& module) {
  const GlobalVariable* annotations = module.getGlobalVariable("llvm.global.annotations");
  const auto* entries = annotations == nullptr || !annotations->hasInitializer()
                            ? nullptr
                            : dyn_cast<ConstantArray>(annotations->getInitializer());
  if (entries == nullptr)
    return;
  for (const Use& use : entries->operands()) {
    const auto* entry = cast<ConstantStruct>(use.get());
    auto* function = dyn_cast<Function>(entry->getOperand(0)->stripPointerCasts());
    const auto* text = dyn_cast<GlobalVariable>(entry->getOperand(1)->stripPointerCasts());
    const auto* data =
        text == nullptr ? nullptr : dyn_cast<ConstantDataArray>(text->getInitializer());
    if (function == nullptr || data == nullptr || data->getAsCString() != "interrupt")
      continue;
    function->addFnAttr(kInterruptAttribute);
    // A vector table or core start-up names it, not C.
    function->addFnAttr(Attribute::NoInline);
  }
}

/// String literals and other unnamed constants get names that say what they are.
void name_private_data(Module& module) {
  for (GlobalVariable& global : module.globals()) {
    if (!global.hasPrivateLinkage())
      continue;
    std::string name = global.getName().str();
    if (StringRef(name).starts_with(".str"))
      name = "literal" + name.substr(4);
    for (char& c : name)
      if (c == '.')
        c = '_';
    global.setName(StringRef(name).ltrim('_'));
    global.setLinkage(GlobalValue::InternalLinkage);
  }
}

/// The stack is aligned to words. What wants more gets room to spare, and the first address in it
/// that will do.
void align_locals(Module& module) {
  const Align kStack(4);
  SmallVector<AllocaInst*, 8> locals;
  for (Function& function : module)
    for (Instruction& inst : instructions(function))
      if (auto* local = dyn_cast<AllocaInst>(&inst); local != nullptr && local->getAlign() > kStack)
        locals.push_back(local);
  for (AllocaInst* local : locals) {
    const Align align = local->getAlign();
    const std::optional<TypeSize> size = local->getAllocationSize(module.getDataLayout());
    if (!size)
      report_fatal_error("a local array of variable size cannot be aligned to more than 4 bytes");
    IRBuilder<> builder(local->getNextNode());
    auto* bytes = ArrayType::get(builder.getInt8Ty(), size->getFixedValue() + align.value() - 4);
    AllocaInst* room = builder.CreateAlloca(bytes, nullptr, local->getName());
    room->setAlignment(kStack);
    Value* from = builder.CreatePtrAdd(room, builder.getInt32(uint32_t(align.value() - 4)));
    Value* address = builder.CreateAnd(builder.CreatePtrToInt(from, builder.getInt32Ty()),
                                       builder.getInt32(~uint32_t(align.value() - 1)));
    Value* aligned = builder.CreateIntToPtr(address, builder.getPtrTy());
    local->replaceUsesWithIf(aligned, [](const Use& use) {
      const auto* user = dyn_cast<IntrinsicInst>(use.getUser());
      return user == nullptr || !user->isLifetimeStartOrEnd();
    });
    for (User* user : make_early_inc_range(local->users()))
      cast<Instruction>(user)->eraseFromParent();
    local->eraseFromParent();
  }
}

/// Each access of up to a word is one for the machine, too. What else an atomic one promises is
/// said by fences: nothing is moved across it by the compiler, nor by the write buffers.
void lower_atomics(Module& module) {
  SmallVector<Instruction*, 8> accesses;
  for (Function& function : module)
    for (Instruction& inst : instructions(function))
      if (inst.isAtomic() && (isa<LoadInst>(inst) || isa<StoreInst>(inst)))
        accesses.push_back(&inst);
  for (Instruction* access : accesses) {
    auto* load = dyn_cast<LoadInst>(access);
    auto* store = dyn_cast<StoreInst>(access);
    const AtomicOrdering order = load != nullptr ? load->getOrdering() : store->getOrdering();
    const SyncScope::ID scope = load != nullptr ? load->getSyncScopeID() : store->getSyncScopeID();
    const bool strict = order == AtomicOrdering::SequentiallyConsistent;
    if (store != nullptr && isReleaseOrStronger(order))
      IRBuilder<>(access).CreateFence(AtomicOrdering::Release, scope);
    if (load != nullptr ? isAcquireOrStronger(order) : strict)
      IRBuilder<>(access->getNextNode())
          .CreateFence(strict ? order : AtomicOrdering::Acquire, scope);
    if (load != nullptr) {
      load->setAtomic(AtomicOrdering::NotAtomic);
      load->setVolatile(true);
    } else {
      store->setAtomic(AtomicOrdering::NotAtomic);
      store->setVolatile(true);
    }
  }
}

OptimizationLevel middle_end_level(char level) {
  switch (level) {
    case '0':
      return OptimizationLevel::O0;
    case '1':
      return OptimizationLevel::O1;
    case '3':
      return OptimizationLevel::O3;
    case 's':
      return OptimizationLevel::Os;
    default:
      return OptimizationLevel::O2;
  }
}

void run_middle_end(Module& module, TargetMachine& machine, char level) {
  PipelineTuningOptions tuning;
  tuning.LoopVectorization = false;
  tuning.SLPVectorization = false;
  PassBuilder builder(&machine, tuning);
  LoopAnalysisManager loops;
  FunctionAnalysisManager functions;
  CGSCCAnalysisManager components;
  ModuleAnalysisManager modules;
  builder.registerModuleAnalyses(modules);
  builder.registerCGSCCAnalyses(components);
  builder.registerFunctionAnalyses(functions);
  builder.registerLoopAnalyses(loops);
  builder.crossRegisterProxies(loops, functions, components, modules);
  builder.registerLateLoopOptimizationsEPCallback([](LoopPassManager& passes, OptimizationLevel) {
    passes.addPass(AbsoluteDifferencesPass());
  });
  builder.registerVectorizerStartEPCallback(
      [](FunctionPassManager& passes, OptimizationLevel target) {
        if (target != OptimizationLevel::O2 && target != OptimizationLevel::O3)
          return;
        passes.addPass(ProductsPass());
        passes.addPass(VectorLoopsPass());
      });
  builder.registerOptimizerLastEPCallback([](ModulePassManager& passes, OptimizationLevel target) {
    FunctionPassManager each;
    if (target != OptimizationLevel::O0) {
      each.addPass(NarrowProductsPass());
      each.addPass(SaturatedShiftsPass());
      each.addPass(PairWordsPass());
    }
    each.addPass(CircularBuffersPass());
    passes.addPass(createModuleToFunctionPassAdaptor(std::move(each)));
  });
  OptimizationLevel target = middle_end_level(level);
  ModulePassManager passes = target == OptimizationLevel::O0
                                 ? builder.buildO0DefaultPipeline(target)
                                 : builder.buildPerModuleDefaultPipeline(target);
  passes.run(module, modules);
}

std::unique_ptr<BfinTargetMachine> make_machine(const Module& module) {
  TargetOptions options;
  // What C says is never reached is caught when it is; a call that does not return needs no guard.
  options.TrapUnreachable = true;
  options.NoTrapAfterNoreturn = true;
  // The code generator works alike at every level; -O0 only spares the middle end.
  auto* machine = static_cast<BfinTargetMachine*>(getBfinTarget().createTargetMachine(
      module.getTargetTriple(), "bf561", "", options, Reloc::Static, CodeModel::Small,
      CodeGenOptLevel::Default));
  return std::unique_ptr<BfinTargetMachine>(machine);
}

}  // namespace

void prepare(Module& module) {
  mark_handlers(module);
  describeNamedInstructions(module);
}

std::string generate(Module& module, const Options& options) {
  std::unique_ptr<BfinTargetMachine> machine = make_machine(module);
  run_middle_end(module, *machine, options.level);
  align_locals(module);
  lower_atomics(module);
  name_private_data(module);  // the middle end makes tables of its own
  std::string text;
  raw_string_ostream out(text);
  if (options.emit_llvm) {
    module.print(out, nullptr);
    return text;
  }
  legacy::PassManager passes;
  passes.add(new TargetLibraryInfoWrapperPass(Triple(module.getTargetTriple())));
  auto* machine_module = new MachineModuleInfoWrapperPass(machine.get());
  machine_module->getMMI().getContext().setUseNamesOnTempLabels(true);
  TargetPassConfig* config = machine->createPassConfig(passes);
  config->setDisableVerify(!options.verify);
  passes.add(config);
  passes.add(machine_module);
  if (config->addISelPasses())
    report_fatal_error("the code generator has no instruction selector");
  config->addMachinePasses();
  config->setInitialized();
  std::unique_ptr<MCInstPrinter> printer(getBfinTarget().createMCInstPrinter(
      machine->getTargetTriple(), 0, *machine->getMCAsmInfo(), *machine->getMCInstrInfo(),
      *machine->getMCRegisterInfo()));
  passes.add(createBfinAsmPrinter(
      *machine, std::make_unique<BirStreamer>(machine_module->getMMI().getContext(), out,
                                              std::move(printer))));
  passes.add(createFreeMachineFunctionPass());
  passes.run(module);
  return text;
}

}  // namespace finback::compiler
