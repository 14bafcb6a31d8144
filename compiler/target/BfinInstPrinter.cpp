#include "BfinInstPrinter.hpp"

#include <llvm/MC/MCAsmInfo.h>
#include <llvm/MC/MCExpr.h>
#include <llvm/MC/MCInst.h>
#include <llvm/Support/raw_ostream.h>

#include "BfinMCTargetDesc.hpp"
#include "BfinNamedInstructions.hpp"

namespace llvm {

#include "BfinGenAsmWriter.inc"

void BfinInstPrinter::printInst(const MCInst* inst, uint64_t address, StringRef,
                                const MCSubtargetInfo&, raw_ostream& out) {
  printInstruction(inst, address, out);
}

void BfinInstPrinter::printRegName(raw_ostream& out, MCRegister reg) const {
  out << getRegisterName(reg);
}

void BfinInstPrinter::printOperand(const MCInst* inst, unsigned index, raw_ostream& out) {
  const MCOperand& operand = inst->getOperand(index);
  if (operand.isReg())
    out << getRegisterName(operand.getReg());
  else if (operand.isImm())
    out << operand.getImm();
  else
    operand.getExpr()->print(out, &MAI);
}

void BfinInstPrinter::printMem(const MCInst* inst, unsigned index, raw_ostream& out) {
  printOperand(inst, index, out);
  int64_t displacement = inst->getOperand(index + 1).getImm();
  if (displacement > 0)
    out << " + " << displacement;
  else if (displacement < 0)
    out << " - " << -displacement;
}

void BfinInstPrinter::printHalf(const MCInst* inst, unsigned index, raw_ostream& out) {
  const MCOperand& operand = inst->getOperand(index);
  if (operand.isImm())
    out << (operand.getImm() & 0xffff);
  else
    operand.getExpr()->print(out, &MAI);
}

void BfinInstPrinter::printHalfOf(const MCInst* inst, unsigned index, raw_ostream& out) {
  printOperand(inst, index, out);
  out << (inst->getOperand(index + 1).getImm() != 0 ? ".H" : ".L");
}

/// The register of the ring's number that `letter` names.
static void print_of_ring(char letter, const char* ring, raw_ostream& out) {
  out << letter << ring[1];
}

void BfinInstPrinter::printRingByStep(const MCInst* inst, unsigned index, raw_ostream& out) {
  const char* ring = getRegisterName(inst->getOperand(index).getReg());
  out << ring << " ++ ";
  print_of_ring('M', ring, out);
}

void BfinInstPrinter::printRingAndStep(const MCInst* inst, unsigned index, raw_ostream& out) {
  const char* ring = getRegisterName(inst->getOperand(index).getReg());
  out << ring << " += ";
  print_of_ring('M', ring, out);
}

void BfinInstPrinter::printRingLength(const MCInst* inst, unsigned index, raw_ostream& out) {
  print_of_ring('L', getRegisterName(inst->getOperand(index).getReg()), out);
}

void BfinInstPrinter::printAddOrTake(const MCInst* inst, unsigned index, raw_ostream& out) {
  static constexpr const char* kSigns[] = {"+=", "-=", "="};
  out << kSigns[inst->getOperand(index).getImm()];
}

void BfinInstPrinter::printRegList(const MCInst* inst, unsigned index, raw_ostream& out) {
  int64_t lowest_d = inst->getOperand(index).getImm();
  int64_t lowest_p = inst->getOperand(index + 1).getImm();
  out << '(';
  if (lowest_d < 8)
    out << "R7:" << lowest_d;
  if (lowest_d < 8 && lowest_p < 6)
    out << ", ";
  if (lowest_p < 6)
    out << "P5:" << lowest_p;
  out << ')';
}

void BfinInstPrinter::printPrediction(const MCInst* inst, unsigned index, raw_ostream& out) {
  if (inst->getOperand(index).getImm() != 0)
    out << " (BP)";
}

void BfinInstPrinter::printSystemRegister(const MCInst* inst, unsigned index, raw_ostream& out) {
  out << kBfinSystemRegisters[static_cast<size_t>(inst->getOperand(index).getImm())];
}

}  // namespace llvm
