// Inline assembly: constraints, operands as text, registers by name.
#include "BfinInlineAsm.hpp"

#include <llvm/CodeGen/SelectionDAG.h>

#include "BfinMCTargetDesc.hpp"
#include "BfinSubtarget.hpp"

namespace llvm {
namespace {

struct Name {
  const char* ours;
  MCPhysReg reg;
};

// In the order of the front end's r0, r1, ...
constexpr Name kNames[] = {
    {"R0", Bfin::R0},     {"R1", Bfin::R1}, {"R2", Bfin::R2},   {"R3", Bfin::R3},
    {"R4", Bfin::R4},     {"R5", Bfin::R5}, {"R6", Bfin::R6},   {"R7", Bfin::R7},
    {"P0", Bfin::P0},     {"P1", Bfin::P1}, {"P2", Bfin::P2},   {"P3", Bfin::P3},
    {"P4", Bfin::P4},     {"P5", Bfin::P5}, {"LC0", Bfin::LC0}, {"LC1", Bfin::LC1},
    {"RETS", Bfin::RETS},
};

// Nothing lives in these across a statement: that they change needs no saying.
constexpr const char* kScratch[] = {"CC", "ASTAT", "A0",  "A1",  "I0",  "I1", "I2",
                                    "I3", "M0",    "M1",  "M2",  "M3",  "B0", "B1",
                                    "B2", "B3",    "LT0", "LT1", "LB0", "LB1"};

}  // namespace

std::string clobberForClang(StringRef name) {
  for (size_t i = 0; i < std::size(kNames); ++i)
    if (name.equals_insensitive(kNames[i].ours))
      return "r" + std::to_string(i);
  return any_of(kScratch, [&](StringRef scratch) { return name.equals_insensitive(scratch); })
             ? "cc"
             : "";
}

MCRegister registerFromClang(StringRef name) {
  size_t number = 0;
  if (!name.consume_front("r") || name.getAsInteger(10, number) || number >= std::size(kNames))
    return {};
  return kNames[number].reg;
}

TargetLowering::ConstraintType BfinTargetLowering::getConstraintType(StringRef constraint) const {
  if (constraint.size() == 1 &&
      (constraint[0] == kDataConstraint || constraint[0] == kPointerConstraint))
    return C_RegisterClass;
  return TargetLowering::getConstraintType(constraint);
}

std::pair<unsigned, const TargetRegisterClass*> BfinTargetLowering::getRegForInlineAsmConstraint(
    const TargetRegisterInfo* registers, StringRef constraint, MVT type) const {
  if (constraint.size() == 1) {
    switch (constraint[0]) {
      case kDataConstraint:
        return {0, &Bfin::DRegClass};
      case kPointerConstraint:
        return {0, &Bfin::PRegClass};
      case 'r':
        return {0, &Bfin::DPRegClass};
      default:
        break;
    }
  }
  if (constraint.starts_with("{") && constraint.ends_with("}"))
    if (MCRegister reg = registerFromClang(constraint.drop_front().drop_back()))
      return {reg, registers->getMinimalPhysRegClass(reg)};
  return TargetLowering::getRegForInlineAsmConstraint(registers, constraint, type);
}

}  // namespace llvm
