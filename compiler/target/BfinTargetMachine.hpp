// The target machine: data layout, pass pipeline.
#pragma once

#include <llvm/Target/TargetMachine.h>
#include <memory>

#include "BfinSubtarget.hpp"

namespace llvm {

class BfinTargetMachine : public LLVMTargetMachine {
 public:
  BfinTargetMachine(const Target& target, const Triple& triple, StringRef cpu, StringRef features,
                    const TargetOptions& options, std::optional<Reloc::Model> relocation,
                    std::optional<CodeModel::Model> code_model, CodeGenOptLevel level, bool jit);
  ~BfinTargetMachine() override;

  /// Little-endian ILP32, everything aligned to words at most.
  static constexpr const char* kDataLayout =
      "e-m:o-p:32:32-i64:32-f64:32-v64:32-v128:32-a:0:32-n32-S32";

  const BfinSubtarget* getSubtargetImpl() const { return &subtarget_; }
  const BfinSubtarget* getSubtargetImpl(const Function&) const override { return &subtarget_; }
  TargetPassConfig* createPassConfig(PassManagerBase& passes) override;
  TargetTransformInfo getTargetTransformInfo(const Function& function) const override;
  TargetLoweringObjectFile* getObjFileLowering() const override { return objects_.get(); }
  MachineFunctionInfo* createMachineFunctionInfo(
      BumpPtrAllocator& allocator, const Function& function,
      const TargetSubtargetInfo* subtarget) const override;

 private:
  std::unique_ptr<TargetLoweringObjectFile> objects_;
  BfinSubtarget subtarget_;
};

}  // namespace llvm
