// The tables that TableGen writes: registers, instructions, subtarget.
#pragma once

#include <llvm/MC/MCAsmInfo.h>
#include <llvm/MC/MCInstrDesc.h>

#define GET_REGINFO_ENUM
#include "BfinGenRegisterInfo.inc"

#define GET_INSTRINFO_ENUM
#define GET_INSTRINFO_MC_HELPER_DECLS
#include "BfinGenInstrInfo.inc"

#define GET_SUBTARGETINFO_ENUM
#include "BfinGenSubtargetInfo.inc"

namespace llvm {

/// What an instruction may be packed as; BfinInstrFormats.td writes these two fields.
namespace BfinII {
enum Slot : unsigned { kAlone = 0, kDspSlot = 1, kMemSlot = 2, kIndexSlot = 3 };
inline unsigned getSlot(const MCInstrDesc& desc) { return desc.TSFlags & 3; }
inline bool readsEarly(const MCInstrDesc& desc) { return (desc.TSFlags & 4) != 0; }
inline bool shiftsByNumber(const MCInstrDesc& desc) { return (desc.TSFlags & 8) != 0; }
}  // namespace BfinII

class BfinMCAsmInfo : public MCAsmInfo {
 public:
  BfinMCAsmInfo();
};

void registerBfinMC();

}  // namespace llvm
