// The functions that are instructions: declarations whose names begin with __builtin_bfin_. One
// table says which there are, what they take and what they become; the diagnostics, the attributes
// of the declarations and selection read it. The headers of compiler/include declare the same
// (tests/compiler/named_instructions_test.cpp compiles every one of them).
#pragma once

#include <llvm/ADT/StringRef.h>
#include <llvm/IR/InstrTypes.h>

namespace llvm {

struct BfinNamedInstruction {
  enum class Kind : uint8_t {
    node,      ///< `opcode` is a node that selection knows anyway
    internal,  ///< the same, for the middle end's passes alone
    ring,      ///< `opcode` is a step of a circular buffer's life, for the middle end's pass alone
    circular,  ///< CircularBuffers leaves none
    compute,   ///< `opcode` is an instruction that only computes
    system,    ///< `opcode` is an instruction that is ordered with all accesses of memory
  };

  StringRef name;  ///< what follows __builtin_bfin_
  /// Result and arguments: v nothing, i a word, p an address, l two words, as one long long, s a
  /// half of which only 16 bits are read or written, h a half that is read with its sign, n a
  /// constant from 0 to 15, r a constant that names a system register.
  StringRef types;
  Kind kind;
  unsigned opcode;
};

/// Null when the function is none of them.
const BfinNamedInstruction* findNamedInstruction(StringRef function);
/// Whether a declaration claims to be one.
bool isNamedInstruction(const Function* function);
/// What is wrong with a call, in words; empty when it can be compiled.
std::string problemOfNamedInstruction(const CallBase& call);
/// The declarations of a module learn what their instructions do.
void describeNamedInstructions(Module& module);

/// By the numbers of sysreg.h.
inline constexpr const char* kBfinSystemRegisters[] = {
    "ASTAT", "SEQSTAT", "SYSCFG", "RETI", "RETX", "RETN", "RETE", "USP", "CYCLES", "CYCLES2"};

}  // namespace llvm
