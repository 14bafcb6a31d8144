#include "BfinNamedInstructions.hpp"

#include <llvm/ADT/StringMap.h>
#include <llvm/CodeGen/ISDOpcodes.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/Module.h>

#include "BfinISelLowering.hpp"
#include "BfinMCTargetDesc.hpp"

namespace llvm {
namespace {

constexpr StringRef kPrefix = "__builtin_bfin_";

constexpr auto kNode = BfinNamedInstruction::Kind::node;
constexpr auto kCompute = BfinNamedInstruction::Kind::compute;
constexpr auto kInternal = BfinNamedInstruction::Kind::internal;
constexpr auto kRing = BfinNamedInstruction::Kind::ring;
constexpr auto kCircular = BfinNamedInstruction::Kind::circular;
constexpr auto kSystem = BfinNamedInstruction::Kind::system;

constexpr BfinNamedInstruction kTable[] = {
    // Of the middle end's own passes.
    {"sum", "i:ii", kInternal, BfinISD::SUM},
    {"sum_fits", "i:ii", kInternal, BfinISD::SUMFITS},
    {"at_least_two", "i:i", kInternal, BfinISD::ATLEASTTWO},
    {"mul_low", "i:ii", kInternal, BfinISD::MULLOW},
    {"set_low", "i:ii", kInternal, BfinISD::SETLO},
    {"set_high", "i:ii", kInternal, BfinISD::SETHI},
    {"ring_begin", "p:ppii", kRing, Bfin::RINGBEGIN},
    {"ring_next", "p:p", kRing, Bfin::RINGNEXT},
    {"ring_done", "p:p", kRing, Bfin::RINGDONE},
    // Circular counting.
    {"circindex", "i:iii", kCircular, 0},
    {"circptr", "p:pipi", kCircular, 0},
    // The system.
    {"csync", "v:", kSystem, Bfin::CSYNC},
    {"ssync", "v:", kSystem, Bfin::SSYNC},
    {"idle", "v:", kSystem, Bfin::IDLE},
    {"nop", "v:", kSystem, Bfin::NOP},
    {"cli", "i:", kSystem, Bfin::CLI},
    {"sti", "v:i", kSystem, Bfin::STI},
    {"raise", "v:n", kSystem, Bfin::RAISE},
    {"excpt", "v:n", kSystem, Bfin::EXCPT},
    {"testset", "i:p", kSystem, Bfin::TESTSET},
    {"prefetch", "v:p", kSystem, Bfin::CACHE_PREFETCH},
    {"flush", "v:p", kSystem, Bfin::CACHE_FLUSH},
    {"flushinv", "v:p", kSystem, Bfin::CACHE_FLUSHINV},
    {"iflush", "v:p", kSystem, Bfin::CACHE_IFLUSH},
    {"sysreg_read", "i:r", kSystem, Bfin::READSYSTEM},
    {"sysreg_write", "v:ri", kSystem, Bfin::WRITESYSTEM},
    // Halves.
    {"add_fr1x16", "s:ss", kCompute, Bfin::ADDH_LL},
    {"sub_fr1x16", "s:ss", kCompute, Bfin::SUBH_LL},
    {"mult_fr1x16", "s:ss", kCompute, Bfin::MULT_LL},
    {"multr_fr1x16", "s:ss", kCompute, Bfin::MULTR_LL},
    {"mult_fr1x32", "i:ss", kCompute, Bfin::MULTW_LL},
    {"abs_fr1x16", "s:s", kCompute, Bfin::ABSV},
    {"negate_fr1x16", "s:s", kCompute, Bfin::NEGV},
    {"min_fr1x16", "s:hh", kNode, ISD::SMIN},
    {"max_fr1x16", "s:hh", kNode, ISD::SMAX},
    {"norm_fr1x16", "s:s", kCompute, Bfin::SIGNBITSH_LL},
    {"expadj1x16", "s:ss", kCompute, Bfin::EXPADJH_LL},
    {"shl_fr1x16", "s:ss", kCompute, Bfin::ASHIFTVS},
    {"lshl_fr1x16", "s:ss", kCompute, Bfin::LSHIFTV},
    // Pairs of halves.
    {"compose_2x16", "i:ss", kCompute, Bfin::PACK_LL},
    {"add_fr2x16", "i:ii", kCompute, Bfin::ADDVS},
    {"sub_fr2x16", "i:ii", kCompute, Bfin::SUBVS},
    {"dspaddsubsat", "i:ii", kCompute, Bfin::ADDSUBVS},
    {"dspsubaddsat", "i:ii", kCompute, Bfin::SUBADDVS},
    {"add_i2x16", "i:ii", kCompute, Bfin::ADDV},
    {"sub_i2x16", "i:ii", kCompute, Bfin::SUBV},
    {"add_sub_i2x16", "i:ii", kCompute, Bfin::ADDSUBV},
    {"sub_add_i2x16", "i:ii", kCompute, Bfin::SUBADDV},
    {"mult_fr2x16", "i:ii", kCompute, Bfin::MULVT},
    {"multr_fr2x16", "i:ii", kCompute, Bfin::MULV},
    {"mult_i2x16", "i:ii", kCompute, Bfin::MULVIS},
    {"multu_fr2x16", "i:ii", kCompute, Bfin::MULVFU},
    {"abs_fr2x16", "i:i", kCompute, Bfin::ABSV},
    {"negate_fr2x16", "i:i", kCompute, Bfin::NEGV},
    {"min_fr2x16", "i:ii", kCompute, Bfin::MINV},
    {"max_fr2x16", "i:ii", kCompute, Bfin::MAXV},
    {"shl_fr2x16", "i:is", kCompute, Bfin::ASHIFTVS},
    {"lshl_fr2x16", "i:is", kCompute, Bfin::LSHIFTV},
    {"sum_fr2x16", "s:i", kCompute, Bfin::SUMHL},
    {"diff_hl_fr2x16", "s:i", kCompute, Bfin::DIFFHL},
    {"diff_lh_fr2x16", "s:i", kCompute, Bfin::DIFFLH},
    {"expadj2x16", "s:is", kCompute, Bfin::EXPADJV},
    // Sum and difference at once: of pairs, and of crossed pairs.
    {"both_i2x16", "l:ii", kCompute, Bfin::BOTHV},
    {"both_fr2x16", "l:ii", kCompute, Bfin::BOTHVS},
    {"both_half_2x16", "l:ii", kCompute, Bfin::BOTHVASR},
    {"both_half_co_2x16", "l:ii", kCompute, Bfin::BOTHVCO_ASR},
    {"cross_i2x16", "l:ii", kCompute, Bfin::BOTHX},
    {"cross_fr2x16", "l:ii", kCompute, Bfin::BOTHXS},
    {"cross_half_2x16", "l:ii", kCompute, Bfin::BOTHXASR},
    {"cross_half_co_2x16", "l:ii", kCompute, Bfin::BOTHXCO_ASR},
    {"both_fr1x32", "l:ii", kCompute, Bfin::BOTHW},
    // Words.
    {"add_fr1x32", "i:ii", kNode, ISD::SADDSAT},
    {"sub_fr1x32", "i:ii", kNode, ISD::SSUBSAT},
    {"min_fr1x32", "i:ii", kNode, ISD::SMIN},
    {"max_fr1x32", "i:ii", kNode, ISD::SMAX},
    {"abs_fr1x32", "i:i", kCompute, Bfin::ABSS},
    {"negate_fr1x32", "i:i", kCompute, Bfin::NEGS},
    {"norm_fr1x32", "s:i", kCompute, Bfin::SIGNBITS},
    {"expadj1x32", "s:is", kCompute, Bfin::EXPADJ},
    {"round_fr1x32", "s:i", kCompute, Bfin::RND},
    {"shl_fr1x32", "i:is", kCompute, Bfin::ASHIFTS},
    {"lshl_fr1x32", "i:is", kCompute, Bfin::LSHIFT},
    {"mult_fr1x32x32", "i:ii", kCompute, Bfin::MUL32},
    {"multr_fr1x32x32", "i:ii", kCompute, Bfin::MUL32R},
    {"ones", "i:i", kNode, ISD::CTPOP},
    {"brevadd", "p:pp", kCompute, Bfin::ADDREVERSED},
    // Complex fractions: the imaginary part is the high half.
    {"cmplx_add", "i:ii", kCompute, Bfin::ADDVS},
    {"cmplx_sub", "i:ii", kCompute, Bfin::SUBVS},
    {"cmplx_mul", "i:ii", kCompute, Bfin::CMULW},
    {"cmplx_mac", "i:iii", kCompute, Bfin::CMACW},
    {"cmplx_msu", "i:iii", kCompute, Bfin::CMSUW},
    {"cmplx_mul_s40", "i:ii", kCompute, Bfin::CMUL},
    {"cmplx_mac_s40", "i:iii", kCompute, Bfin::CMAC},
    {"cmplx_msu_s40", "i:iii", kCompute, Bfin::CMSU},
    // Bytes.
    {"align8", "i:ii", kCompute, Bfin::ALIGN8},
    {"align16", "i:ii", kCompute, Bfin::ALIGN16},
    {"align24", "i:ii", kCompute, Bfin::ALIGN24},
    {"bytepack", "i:ii", kCompute, Bfin::BYTEPACK},
    // Four bytes of a pair of words, from where an address's low bits say (video.h).
    {"add_i4x8", "l:lplp", kCompute, Bfin::BYTESUMS},
    {"add_i4x8_r", "l:lplp", kCompute, Bfin::BYTESUMSR},
    {"sub_i4x8", "l:lplp", kCompute, Bfin::BYTEDIFFS},
    {"sub_i4x8_r", "l:lplp", kCompute, Bfin::BYTEDIFFSR},
    {"avg_i4x8", "i:lplp", kCompute, Bfin::AVERAGE},
    {"avg_i4x8_t", "i:lplp", kCompute, Bfin::AVERAGET},
    {"avg_i4x8_r", "i:lplp", kCompute, Bfin::AVERAGER},
    {"avg_i4x8_tr", "i:lplp", kCompute, Bfin::AVERAGETR},
    {"avg_i2x8_lo", "i:lpl", kCompute, Bfin::AVERAGE4RNDL},
    {"avg_i2x8_lot", "i:lpl", kCompute, Bfin::AVERAGE4TL},
    {"avg_i2x8_lor", "i:lpl", kCompute, Bfin::AVERAGE4RNDLR},
    {"avg_i2x8_lotr", "i:lpl", kCompute, Bfin::AVERAGE4TLR},
    {"avg_i2x8_hi", "i:lpl", kCompute, Bfin::AVERAGE4RNDH},
    {"avg_i2x8_hit", "i:lpl", kCompute, Bfin::AVERAGE4TH},
    {"avg_i2x8_hir", "i:lpl", kCompute, Bfin::AVERAGE4RNDHR},
    {"avg_i2x8_hitr", "i:lpl", kCompute, Bfin::AVERAGE4THR},
    {"addclip_lo", "i:lplp", kCompute, Bfin::ADDCLIPLO},
    {"addclip_hi", "i:lplp", kCompute, Bfin::ADDCLIPHI},
    {"addclip_lor", "i:lplp", kCompute, Bfin::ADDCLIPLOR},
    {"addclip_hir", "i:lplp", kCompute, Bfin::ADDCLIPHIR},
    {"byteunpack", "l:lp", kCompute, Bfin::UNPACK},
    {"byteunpackr", "l:lp", kCompute, Bfin::UNPACKR},
    // The choices of a Viterbi decoder.
    {"lvitmax1x16", "l:ii", kCompute, Bfin::VITHASL},
    {"rvitmax1x16", "l:ii", kCompute, Bfin::VITHASR},
    {"lvitmax2x16", "l:iii", kCompute, Bfin::VITVASL},
    {"rvitmax2x16", "l:iii", kCompute, Bfin::VITVASR},
};

bool is_of_type(const Type* type, char letter) {
  switch (letter) {
    case 'v':
      return type->isVoidTy();
    case 'p':
      return type->isPointerTy();
    case 'l':
      return type->isIntegerTy(64);
    case 's':
    case 'h':
      return type->isIntegerTy(16);
    default:
      return type->isIntegerTy(32);
  }
}

bool has_types(const FunctionType& type, StringRef types) {
  const StringRef arguments = types.substr(2);
  if (type.isVarArg() || type.getNumParams() != arguments.size() ||
      !is_of_type(type.getReturnType(), types[0]))
    return false;
  for (const auto& [parameter, letter] : zip(type.params(), arguments))
    if (!is_of_type(parameter, letter))
      return false;
  return true;
}

}  // namespace

const BfinNamedInstruction* findNamedInstruction(StringRef function) {
  static const StringMap<const BfinNamedInstruction*> by_name = [] {
    StringMap<const BfinNamedInstruction*> names;
    for (const BfinNamedInstruction& instruction : kTable)
      names[instruction.name] = &instruction;
    return names;
  }();
  return function.consume_front(kPrefix) ? by_name.lookup(function) : nullptr;
}

bool isNamedInstruction(const Function* function) {
  return function != nullptr && function->isDeclaration() &&
         function->getName().starts_with(kPrefix);
}

std::string problemOfNamedInstruction(const CallBase& call) {
  const StringRef name = call.getCalledFunction()->getName();
  const BfinNamedInstruction* instruction = findNamedInstruction(name);
  if (instruction == nullptr || instruction->kind == kInternal || instruction->kind == kRing)
    return ("there is no instruction behind " + name).str();
  if (!has_types(*call.getFunctionType(), instruction->types))
    return (name + " is declared with other types than finback's headers have").str();
  for (const auto& [argument, letter] : zip(call.args(), instruction->types.substr(2))) {
    const auto* number = dyn_cast<ConstantInt>(argument.get());
    if (letter == 'n' && (number == nullptr || number->getZExtValue() > 15))
      return ("the argument of " + name + " must be a constant from 0 to 15").str();
    if (letter == 'r' &&
        (number == nullptr || number->getZExtValue() >= std::size(kBfinSystemRegisters)))
      return ("the register of " + name + " must be one of sysreg.h's constants").str();
  }
  return "";
}

void describeNamedInstructions(Module& module) {
  for (Function& function : module) {
    const BfinNamedInstruction* instruction =
        isNamedInstruction(&function) ? findNamedInstruction(function.getName()) : nullptr;
    if (instruction == nullptr)
      continue;
    function.setDoesNotThrow();
    if (instruction->kind == kSystem || instruction->kind == kRing)
      continue;
    function.setDoesNotAccessMemory();
    function.setWillReturn();
    function.setNoSync();
    function.setDoesNotFreeMemory();
    function.addFnAttr(Attribute::Speculatable);
  }
}

}  // namespace llvm
