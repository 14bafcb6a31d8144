// Which nodes the machine has, and how the others become those.
#pragma once

#include <llvm/CodeGen/TargetLowering.h>

namespace llvm {

class BfinSubtarget;

namespace BfinISD {
enum NodeType : unsigned {
  FIRST_NUMBER = ISD::BUILTIN_OP_END,
  CALL,
  TAILCALL,
  RET,
  RETI,
  SYMBOL,
  CMP,     ///< lhs, rhs, BfinCC -> glue carrying CC
  BITTST,  ///< value, bit -> glue
  JCC,     ///< chain, block, sense, glue
  SELECT,  ///< then, otherwise, sense, glue
  FROMCC,  ///< glue -> 0 or 1
  ROTCC,   ///< value, glue -> 2 value + (0 or 1)
  NOTCC,
  MULU16,    ///< low half x low half, unsigned
  MULU16HL,  ///< high half x low half
  MULU16HH,
  MULLOW,      ///< signed product of the low halves; the product's low half is wanted
  SUM,         ///< as ADD; exact sums fit 40 bits
  SUMFITS,     ///< as ADD; exact sums fit 32 bits
  ATLEASTTWO,  ///< the same number, of which it is known that it is 2 or more
  SETLO,       ///< a word, and what its low half becomes
  SETHI,
  TESTSET,
  COMPUTE,  ///< opcode, arguments that are halves (bit by bit), arguments -> results
  SYSTEM,   ///< chain, opcode, arguments -> results, chain
};
}  // namespace BfinISD

/// The comparisons that set CC; the numbers stand in BfinInstrInfo.td.
enum BfinCC : unsigned { kEqual = 0, kLess = 1, kLessEqual = 2, kBelow = 3, kBelowEqual = 4 };

class BfinTargetLowering : public TargetLowering {
 public:
  BfinTargetLowering(const TargetMachine& machine, const BfinSubtarget& subtarget);

  const char* getTargetNodeName(unsigned opcode) const override;
  SDValue LowerOperation(SDValue op, SelectionDAG& dag) const override;
  SDValue PerformDAGCombine(SDNode* node, DAGCombinerInfo& info) const override;
  EVT getSetCCResultType(const DataLayout&, LLVMContext&, EVT) const override { return MVT::i32; }
  bool isOffsetFoldingLegal(const GlobalAddressSDNode*) const override { return false; }
  bool isLegalAddressingMode(const DataLayout& layout, const AddrMode& mode, Type* type,
                             unsigned address_space, Instruction* inst) const override;
  bool isLegalICmpImmediate(int64_t value) const override { return isInt<3>(value); }
  bool isLegalAddImmediate(int64_t value) const override { return isInt<7>(value); }
  bool decomposeMulByConstant(LLVMContext&, EVT type, SDValue factor) const override;
  bool isTruncateFree(Type* from, Type* to) const override;
  bool isZExtFree(SDValue value, EVT to) const override;
  bool getPostIndexedAddressParts(SDNode* access, SDNode* step, SDValue& base, SDValue& offset,
                                  ISD::MemIndexedMode& mode, SelectionDAG& dag) const override;
  // BfinInlineAsm.cpp.
  ConstraintType getConstraintType(StringRef constraint) const override;
  std::pair<unsigned, const TargetRegisterClass*> getRegForInlineAsmConstraint(
      const TargetRegisterInfo* registers, StringRef constraint, MVT type) const override;
  /// Two words have no store of their own: as one value they would only lose what is known of them.
  bool canMergeStoresTo(unsigned, EVT type, const MachineFunction&) const override {
    return type.getSizeInBits() <= 32;
  }
  bool allowsMemoryAccess(LLVMContext& context, const DataLayout& layout, EVT type, unsigned space,
                          Align align, MachineMemOperand::Flags flags,
                          unsigned* fast) const override {
    return type.getSizeInBits() <= 32 &&
           TargetLowering::allowsMemoryAccess(context, layout, type, space, align, flags, fast);
  }
  bool shouldConvertConstantLoadToIntImm(const APInt&, Type*) const override { return true; }

 private:
  SDValue LowerFormalArguments(SDValue chain, CallingConv::ID convention, bool variadic,
                               const SmallVectorImpl<ISD::InputArg>& ins, const SDLoc& loc,
                               SelectionDAG& dag, SmallVectorImpl<SDValue>& values) const override;
  SDValue LowerCall(CallLoweringInfo& call, SmallVectorImpl<SDValue>& values) const override;
  bool CanLowerReturn(CallingConv::ID convention, MachineFunction& function, bool variadic,
                      const SmallVectorImpl<ISD::OutputArg>& outs,
                      LLVMContext& context) const override;
  SDValue LowerReturn(SDValue chain, CallingConv::ID convention, bool variadic,
                      const SmallVectorImpl<ISD::OutputArg>& outs,
                      const SmallVectorImpl<SDValue>& values, const SDLoc& loc,
                      SelectionDAG& dag) const override;

  SDValue lower_symbol(SDValue op, SelectionDAG& dag) const;
  SDValue lower_branch(SDValue op, SelectionDAG& dag) const;
  SDValue lower_select(SDValue op, SelectionDAG& dag) const;
  SDValue lower_setcc(SDValue op, SelectionDAG& dag) const;
  SDValue lower_wide_product(SDValue op, SelectionDAG& dag) const;
  SDValue lower_va_start(SDValue op, SelectionDAG& dag) const;
  SDValue lower_fence(SDValue op, SelectionDAG& dag) const;
};

/// An OR of flags and of what stands above them, by rotations through CC; nothing if it is none.
SDValue combineBfinBitString(SDNode* node, TargetLowering::DAGCombinerInfo& info);

}  // namespace llvm
