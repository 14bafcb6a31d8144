// Prints one instruction in GNU's Blackfin syntax, without the closing semicolon.
#pragma once

#include <llvm/MC/MCInstPrinter.h>

namespace llvm {

class BfinInstPrinter : public MCInstPrinter {
 public:
  using MCInstPrinter::MCInstPrinter;

  std::pair<const char*, uint64_t> getMnemonic(const MCInst* inst) override;
  void printInst(const MCInst* inst, uint64_t address, StringRef annotation,
                 const MCSubtargetInfo& subtarget, raw_ostream& out) override;
  void printRegName(raw_ostream& out, MCRegister reg) const override;

  // Written by TableGen.
  void printInstruction(const MCInst* inst, uint64_t address, raw_ostream& out);
  static const char* getRegisterName(MCRegister reg);

  void printOperand(const MCInst* inst, unsigned index, raw_ostream& out);
  /// Base register and displacement, without the brackets.
  void printMem(const MCInst* inst, unsigned index, raw_ostream& out);
  /// Sixteen bits of a constant, or a symbol whose half the assembler takes.
  void printHalf(const MCInst* inst, unsigned index, raw_ostream& out);
  /// A register and which half of it: two operands.
  void printHalfOf(const MCInst* inst, unsigned index, raw_ostream& out);
  /// A circular buffer's registers: I0 ++ M0, I0 += M0, L0.
  void printRingByStep(const MCInst* inst, unsigned index, raw_ostream& out);
  void printRingAndStep(const MCInst* inst, unsigned index, raw_ostream& out);
  void printRingLength(const MCInst* inst, unsigned index, raw_ostream& out);
  void printAddOrTake(const MCInst* inst, unsigned index, raw_ostream& out);
  /// The lists of a multiple push or pop: two operands, the lowest D (8: none) and P (6: none).
  void printRegList(const MCInst* inst, unsigned index, raw_ostream& out);
  void printSystemRegister(const MCInst* inst, unsigned index, raw_ostream& out);
  void printPrediction(const MCInst* inst, unsigned index, raw_ostream& out);
};

}  // namespace llvm
