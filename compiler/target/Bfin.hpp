// The back end's own passes and its registration.
// Models: selection, allocation, frames, hardware loops and packets of a BF561-like core, as text.
// Does not model: encodings, relocations, object files, debug information beyond source lines.
// Source: hardware.md 1.2-1.6 (rules and cycles), the public Blackfin ABI, GNU as syntax.
#pragma once

#include <llvm/MC/TargetRegistry.h>

namespace llvm {

class AsmPrinter;
class BfinTargetMachine;
class FunctionPass;
class MCStreamer;
class raw_ostream;

/// The one Target; no triple selects it, the driver takes it directly.
Target& getBfinTarget();
/// Registers the target machine, the MC tables and the printer. Call once.
void initializeBfinTarget();

FunctionPass* createBfinISelDag(BfinTargetMachine& machine, CodeGenOptLevel level);
/// On LLVM's IR: one register for counters and pointers that step alike.
FunctionPass* createBfinSameSteps();
/// Circular buffers in I, M, B and L registers, while their loops run.
FunctionPass* createBfinRings();
/// Decides which loops of the machine code run on LC0 and LC1; turns the others into count downs.
FunctionPass* createBfinHardwareLoops();
/// Keeps sums of products in A0 and A1 while their loop runs.
FunctionPass* createBfinAccumulators();
/// Accesses that step by a register, or by themselves, instead of a sum of their own.
FunctionPass* createBfinStrides();
/// Lets accesses step their pointers in loops, where distances from the pointer were left.
FunctionPass* createBfinSteps();
/// Loads for a loop's next pass at the end of the present one.
FunctionPass* createBfinRotateLoops();
/// Sums that come to their registers with their last products, behind loops.
FunctionPass* createBfinFetches();
/// Gives every virtual register its bank, data or pointer, where the copies cost least.
FunctionPass* createBfinBankSelect();
/// Before allocation: short loops of products within others, written out.
FunctionPass* createBfinUnrollLoops();
/// Spares the zero before each count of ones in a loop.
FunctionPass* createBfinKeptHalves();
/// Pointers that outer loops go on with stay in the I registers of inner ones.
FunctionPass* createBfinKeptIndices();
/// After allocation and layout: writes LSETUP and its labels.
FunctionPass* createBfinLoopLayout();
/// After allocation: pointers of small loops in I registers, for two accesses a packet.
FunctionPass* createBfinIndexStreams();
/// After allocation: several rounds at a time of loops that look for something.
FunctionPass* createBfinSearchLoops();
/// After allocation: the final order of each block, in packets.
FunctionPass* createBfinPackets();
/// Shorter forms and the branch predictions.
FunctionPass* createBfinLateForms();

}  // namespace llvm
