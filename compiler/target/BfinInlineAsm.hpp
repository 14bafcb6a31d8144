// The registers of inline assembly, by the names under which they travel through clang
// (driver/assembly.hpp).
#pragma once

#include <llvm/ADT/StringRef.h>
#include <llvm/MC/MCRegister.h>
#include <string>

namespace llvm {

/// A data register, in C "d".
constexpr char kDataConstraint = 'l';
/// A pointer register.
constexpr char kPointerConstraint = 'a';

/// The name of a clobber for clang; "" where it is none of ours.
std::string clobberForClang(StringRef name);
/// The register behind such a name, "r8"; none for others.
MCRegister registerFromClang(StringRef name);

}  // namespace llvm
