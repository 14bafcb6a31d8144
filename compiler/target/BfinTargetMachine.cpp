#include "BfinTargetMachine.hpp"

#include <llvm/CodeGen/Passes.h>
#include <llvm/CodeGen/TargetLoweringObjectFileImpl.h>
#include <llvm/CodeGen/TargetPassConfig.h>

#include "Bfin.hpp"
#include "BfinMachineFunctionInfo.hpp"
#include "BfinTargetTransformInfo.hpp"

namespace llvm {

Target& getBfinTarget() {
  static Target target;
  return target;
}

void initializeBfinTarget() {
  // No triple names this machine: an unknown architecture never matches.
  TargetRegistry::RegisterTarget(
      getBfinTarget(), "bfin", "Blackfin (BIR text)", "Bfin",
      [](Triple::ArchType) { return false; }, false);
  RegisterTargetMachine<BfinTargetMachine> machine(getBfinTarget());
  registerBfinMC();
}

BfinTargetMachine::BfinTargetMachine(const Target& target, const Triple& triple, StringRef cpu,
                                     StringRef features, const TargetOptions& options,
                                     std::optional<Reloc::Model>, std::optional<CodeModel::Model>,
                                     CodeGenOptLevel level, bool)
    : LLVMTargetMachine(target, kDataLayout, triple, cpu, features, options, Reloc::Static,
                        CodeModel::Small, level),
      objects_(std::make_unique<TargetLoweringObjectFileELF>()),
      subtarget_(triple, cpu, features, *this) {
  initAsmInfo();
}

BfinTargetMachine::~BfinTargetMachine() = default;

TargetTransformInfo BfinTargetMachine::getTargetTransformInfo(const Function& function) const {
  return TargetTransformInfo(BfinTTIImpl(this, function));
}

MachineFunctionInfo* BfinTargetMachine::createMachineFunctionInfo(
    BumpPtrAllocator& allocator, const Function& function,
    const TargetSubtargetInfo* subtarget) const {
  return BfinMachineFunctionInfo::create<BfinMachineFunctionInfo>(allocator, function, subtarget);
}

namespace {

class BfinPassConfig : public TargetPassConfig {
 public:
  BfinPassConfig(BfinTargetMachine& machine, PassManagerBase& passes)
      : TargetPassConfig(machine, passes) {}

  BfinTargetMachine& machine() const { return getTM<BfinTargetMachine>(); }

  void addCodeGenPrepare() override {
    // Bytes that live across blocks are widened once, where they are loaded.
    addPass(createTypePromotionLegacyPass());
    TargetPassConfig::addCodeGenPrepare();
  }

  bool addPreISel() override {
    addPass(createBfinSameSteps());
    if (getOptLevel() != CodeGenOptLevel::None)
      addPass(createHardwareLoopsLegacyPass());
    return false;
  }

  bool addInstSelector() override {
    addPass(createBfinISelDag(machine(), getOptLevel()));
    return false;
  }

  void addMachineSSAOptimization() override {
    addPass(createBfinRings());
    addPass(createBfinHardwareLoops());
    addPass(createBfinAccumulators());
    addPass(createBfinStrides());
    addPass(createBfinSteps());
    addPass(createBfinBankSelect());
    addPass(createBfinKeptHalves());
    TargetPassConfig::addMachineSSAOptimization();
  }

  void addPreRegAlloc() override {
    addPass(createBfinUnrollLoops());
    addPass(createBfinFetches());
    addPass(createBfinRotateLoops());
    addPass(createBfinKeptIndices());
    addPass(createBfinFetches());
    addPass(&OptimizePHIsID);
    addPass(&DeadMachineInstructionElimID);
  }

  void addPreEmitPass() override {
    addPass(createBfinIndexStreams());
    addPass(createBfinSearchLoops());
    addPass(createBfinPackets());
    addPass(createBfinLoopLayout());
    addPass(createBfinLateForms());  // behind the layout, which writes branches anew
    addPass(&BranchRelaxationPassID);
  }
};

}  // namespace

TargetPassConfig* BfinTargetMachine::createPassConfig(PassManagerBase& passes) {
  return new BfinPassConfig(*this, passes);
}

}  // namespace llvm
