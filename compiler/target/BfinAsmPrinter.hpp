// Machine code and globals to BIR, through BirStreamer.
#pragma once

#include <llvm/CodeGen/AsmPrinter.h>
#include <memory>

namespace llvm {

class BirStreamer;

/// The pass that prints; it owns the streamer.
AsmPrinter* createBfinAsmPrinter(TargetMachine& machine, std::unique_ptr<BirStreamer> streamer);

}  // namespace llvm
