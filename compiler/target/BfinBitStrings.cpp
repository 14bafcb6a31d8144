// Strings of flags: bits = 2 * bits + (a < b), as a census has them. The middle end writes them as
// an OR of shifted flags and a shifted rest; here they become one rotation through CC for each
// flag, instead of a copy of CC, a shift and an OR.
#include <llvm/CodeGen/SelectionDAG.h>

#include "BfinISelLowering.hpp"

namespace llvm {

namespace {

constexpr unsigned kMostTerms = 8;

/// An OR's terms: flags at their bits, and one value shifted beyond all of them.
struct BitString {
  SmallVector<std::pair<unsigned, SDValue>, kMostTerms> flags;
  SDValue rest;
  unsigned rest_bit = 0;
  bool is_one = true;
};

void collect(SDValue value, unsigned bit, bool is_root, BitString& string) {
  if (string.flags.size() >= kMostTerms) {
    string.is_one = false;
  } else if (value.getOpcode() == ISD::OR && (is_root || value.hasOneUse())) {
    collect(value.getOperand(0), bit, false, string);
    collect(value.getOperand(1), bit, false, string);
  } else if (value.getOpcode() == ISD::SHL && value.hasOneUse() &&
             isa<ConstantSDNode>(value.getOperand(1)) &&
             bit + value.getConstantOperandVal(1) < 32) {
    collect(value.getOperand(0), bit + unsigned(value.getConstantOperandVal(1)), false, string);
  } else if (value.getOpcode() == BfinISD::FROMCC && value.hasOneUse()) {
    string.flags.emplace_back(bit, value);
  } else {
    string.is_one = string.is_one && !string.rest;
    string.rest = value;
    string.rest_bit = bit;
  }
}

/// Do the terms share no bit? Flags from the highest on.
bool sort_terms(BitString& string) {
  llvm::sort(string.flags, [](const auto& a, const auto& b) { return a.first > b.first; });
  for (size_t i = 1; i < string.flags.size(); ++i)
    if (string.flags[i].first == string.flags[i - 1].first)
      return false;
  return !string.rest || string.rest_bit > string.flags.front().first;
}

}  // namespace

SDValue combineBfinBitString(SDNode* node, TargetLowering::DAGCombinerInfo& info) {
  // Flags are in CC once comparisons are lowered.
  if (node->getOpcode() != ISD::OR || node->getValueType(0) != MVT::i32 ||
      !info.isAfterLegalizeDAG())
    return SDValue();
  BitString string;
  collect(SDValue(node, 0), 0, true, string);
  if (!string.is_one || string.flags.size() + (string.rest ? 1 : 0) < 2 || string.flags.empty() ||
      !sort_terms(string))
    return SDValue();
  SelectionDAG& dag = info.DAG;
  const SDLoc loc(node);
  const auto shifted = [&](SDValue value, unsigned by) {
    return by == 0
               ? value
               : dag.getNode(ISD::SHL, loc, MVT::i32, value, dag.getConstant(by, loc, MVT::i32));
  };
  auto flag = string.flags.begin();
  SDValue bits = string.rest;
  unsigned bit = string.rest_bit;
  if (!bits) {
    bits = flag->second;
    bit = flag++->first;
  }
  for (; flag != string.flags.end(); ++flag) {
    bits = shifted(bits, bit - flag->first - 1);
    bits = dag.getNode(BfinISD::ROTCC, loc, MVT::i32, bits, flag->second.getOperand(0));
    bit = flag->first;
  }
  return shifted(bits, bit);
}

}  // namespace llvm
