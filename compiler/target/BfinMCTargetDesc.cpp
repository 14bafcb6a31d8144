#include "BfinMCTargetDesc.hpp"

#include <llvm/MC/MCInstrInfo.h>
#include <llvm/MC/MCRegisterInfo.h>
#include <llvm/MC/MCSubtargetInfo.h>
#include <llvm/MC/TargetRegistry.h>

#include "Bfin.hpp"
#include "BfinInstPrinter.hpp"

#define GET_INSTRINFO_MC_DESC
#define ENABLE_INSTR_PREDICATE_VERIFIER
#include "BfinGenInstrInfo.inc"

#define GET_SUBTARGETINFO_MC_DESC
#include "BfinGenSubtargetInfo.inc"

#define GET_REGINFO_MC_DESC
#include "BfinGenRegisterInfo.inc"

namespace llvm {

BfinMCAsmInfo::BfinMCAsmInfo() {
  CodePointerSize = 4;
  CalleeSaveStackSlotSize = 4;
  CommentString = "//";
  PrivateGlobalPrefix = ".L";
  PrivateLabelPrefix = ".L";
  Data64bitsDirective = nullptr;
  HasDotTypeDotSizeDirective = false;
  // Lines are written by the printer itself; there are no DWARF sections.
  SupportsDebugInformation = false;
  UsesELFSectionDirectiveForBSS = true;
  // Inline assembly goes into the text as it is; who loads it checks it.
  UseIntegratedAssembler = false;
  MaxInstLength = 8;
  SeparatorString = ";";
}

static MCAsmInfo* create_asm_info(const MCRegisterInfo&, const Triple&, const MCTargetOptions&) {
  return new BfinMCAsmInfo();
}

static MCInstrInfo* create_instr_info() {
  auto* info = new MCInstrInfo();
  InitBfinMCInstrInfo(info);
  return info;
}

static MCRegisterInfo* create_register_info(const Triple&) {
  auto* info = new MCRegisterInfo();
  InitBfinMCRegisterInfo(info, Bfin::RETS);
  return info;
}

static MCSubtargetInfo* create_subtarget_info(const Triple& triple, StringRef cpu,
                                              StringRef features) {
  return createBfinMCSubtargetInfoImpl(triple, cpu, cpu, features);
}

static MCInstPrinter* create_inst_printer(const Triple&, unsigned, const MCAsmInfo& asm_info,
                                          const MCInstrInfo& instrs, const MCRegisterInfo& regs) {
  return new BfinInstPrinter(asm_info, instrs, regs);
}

void registerBfinMC() {
  Target& target = getBfinTarget();
  TargetRegistry::RegisterMCAsmInfo(target, create_asm_info);
  TargetRegistry::RegisterMCInstrInfo(target, create_instr_info);
  TargetRegistry::RegisterMCRegInfo(target, create_register_info);
  TargetRegistry::RegisterMCSubtargetInfo(target, create_subtarget_info);
  TargetRegistry::RegisterMCInstPrinter(target, create_inst_printer);
}

}  // namespace llvm
