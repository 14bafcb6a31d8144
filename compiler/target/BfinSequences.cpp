// What several instructions compute together, in the accumulators: written out once registers are
// allocated.
#include <llvm/CodeGen/MachineInstrBuilder.h>

#include "BfinInstrInfo.hpp"

namespace llvm {
namespace {

/// Writes the parts of one sequence before it.
class Writer {
 public:
  Writer(MachineInstr& whole, const BfinInstrInfo& tii) : whole_(whole), tii_(tii) {}

  /// An instruction on operands of the whole; a result among them comes first.
  void part(unsigned opcode, std::initializer_list<unsigned> operands) {
    auto inst = BuildMI(*whole_.getParent(), whole_, whole_.getDebugLoc(), tii_.get(opcode));
    const MCInstrDesc& description = tii_.get(opcode);
    unsigned results = description.getNumDefs();
    for (const unsigned number : operands) {
      const Register reg = whole_.getOperand(number).getReg();
      inst.addReg(reg, results > 0 ? RegState::Define : 0);
      if (results == 1 &&
          description.getOperandConstraint(description.getNumDefs(), MCOI::TIED_TO) == 0)
        inst.addReg(reg, RegState::Undef);
      results -= results > 0 ? 1 : 0;
    }
  }

 private:
  MachineInstr& whole_;
  const BfinInstrInfo& tii_;
};

/// sum + a b or sum - a b, the sum's parts in two registers.
void write_complex_sum(Writer& writer, unsigned products, unsigned get) {
  writer.part(Bfin::SETA1, {1});
  writer.part(Bfin::SETA0, {2});
  writer.part(products, {3, 4});
  writer.part(get, {0, 3, 4});
}

/// Behind the product of the low halves: (a b) >> 31, of which A0 holds the high halves' part.
void write_wide_product(Writer& writer, unsigned a, unsigned b) {
  writer.part(Bfin::A1DOWN16, {});
  writer.part(Bfin::CROSSHIGHS, {a, b});
  writer.part(Bfin::CROSS, {b, a});
  writer.part(Bfin::A1DOWN15, {});
  writer.part(Bfin::SUMOFBOTH, {0});
}

/// The old history, with nothing above it.
void write_history(Writer& writer, unsigned old) {
  writer.part(Bfin::CLRA0, {});
  writer.part(Bfin::SETLOWA0, {old});
}

void write_choice_of_half(Writer& writer, unsigned choose) {
  write_history(writer, 3);
  writer.part(choose, {0, 2});
  writer.part(Bfin::GETA0, {1});
}

void write_choice_of_halves(Writer& writer, unsigned choose) {
  write_history(writer, 4);
  writer.part(choose, {0, 2, 3});
  writer.part(Bfin::GETA0, {1});
}

}  // namespace

bool BfinInstrInfo::expandSequence(MachineInstr& inst) const {
  Writer writer(inst, *this);
  switch (inst.getOpcode()) {
    case Bfin::CMUL:
    case Bfin::CMULW:
      writer.part(inst.getOpcode() == Bfin::CMUL ? Bfin::CSET : Bfin::CSETW, {1, 2});
      writer.part(Bfin::CGET, {0, 1, 2});
      break;
    case Bfin::CMAC:
      write_complex_sum(writer, Bfin::CADD, Bfin::CGET);
      break;
    case Bfin::CMACW:
      write_complex_sum(writer, Bfin::CADDW, Bfin::CGET);
      break;
    case Bfin::CMSU:
      write_complex_sum(writer, Bfin::CSUB, Bfin::CGETS);
      break;
    case Bfin::CMSUW:
      write_complex_sum(writer, Bfin::CSUBW, Bfin::CGETS);
      break;
    case Bfin::MUL32:
      writer.part(Bfin::LOWS, {1, 2});
      write_wide_product(writer, 1, 2);
      break;
    case Bfin::MUL32R:
      writer.part(Bfin::SETA1, {1});
      writer.part(Bfin::LOWSADD, {2, 3});
      write_wide_product(writer, 2, 3);
      break;
    case Bfin::VITHASL:
      write_choice_of_half(writer, Bfin::VITMAXHASL);
      break;
    case Bfin::VITHASR:
      write_choice_of_half(writer, Bfin::VITMAXHASR);
      break;
    case Bfin::VITVASL:
      write_choice_of_halves(writer, Bfin::VITMAXVASL);
      break;
    case Bfin::VITVASR:
      write_choice_of_halves(writer, Bfin::VITMAXVASR);
      break;
    default:
      return false;
  }
  inst.eraseFromParent();
  return true;
}

}  // namespace llvm
