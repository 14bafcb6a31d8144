#include "BfinISelLowering.hpp"

#include <llvm/CodeGen/MachineFrameInfo.h>
#include <llvm/CodeGen/MachineFunction.h>
#include <llvm/CodeGen/SelectionDAG.h>
#include <llvm/IR/Constants.h>

#include "BfinMachineFunctionInfo.hpp"
#include "BfinNamedLowering.hpp"
#include "BfinSubtarget.hpp"

namespace llvm {

BfinTargetLowering::BfinTargetLowering(const TargetMachine& machine, const BfinSubtarget& subtarget)
    : TargetLowering(machine) {
  addRegisterClass(MVT::i32, &Bfin::DPRegClass);
  computeRegisterProperties(subtarget.getRegisterInfo());
  setStackPointerRegisterToSaveRestore(Bfin::SP);
  setBooleanContents(ZeroOrOneBooleanContent);
  setMinFunctionAlignment(Align(2));
  // What lies across two fetches in a function then does so wherever the function lies.
  setPrefFunctionAlignment(Align(8));
  setMinStackArgumentAlignment(Align(4));
  setSchedulingPreference(Sched::RegPressure);
  // A table costs about fourteen cycles, most of them the jump's; so do three compares in a row.
  setMinimumJumpTableEntries(8);
  setMaxAtomicSizeInBitsSupported(32);
  MaxStoresPerMemcpy = MaxStoresPerMemcpyOptSize = 8;
  MaxStoresPerMemmove = MaxStoresPerMemmoveOptSize = 4;
  MaxStoresPerMemset = MaxStoresPerMemsetOptSize = 8;

  for (unsigned op :
       {ISD::BR_CC, ISD::SELECT_CC, ISD::SETCC, ISD::GlobalAddress, ISD::ExternalSymbol,
        ISD::ConstantPool, ISD::JumpTable, ISD::BlockAddress, ISD::UMUL_LOHI, ISD::MULHU, ISD::ABS,
        ISD::SHL_PARTS, ISD::SRL_PARTS, ISD::SRA_PARTS})
    setOperationAction(op, MVT::i32, Custom);
  for (unsigned op : {ISD::VASTART, ISD::ATOMIC_FENCE, ISD::TRAP})
    setOperationAction(op, MVT::Other, Custom);
  for (unsigned op :
       {ISD::SELECT, ISD::SDIVREM, ISD::UDIVREM, ISD::SMUL_LOHI, ISD::MULHS, ISD::ROTL, ISD::ROTR,
        ISD::BSWAP, ISD::BITREVERSE, ISD::CTLZ, ISD::CTTZ, ISD::CTLZ_ZERO_UNDEF,
        ISD::CTTZ_ZERO_UNDEF, ISD::DYNAMIC_STACKALLOC, ISD::UMIN, ISD::UMAX})
    setOperationAction(op, MVT::i32, Expand);
  for (unsigned op : {ISD::BRCOND, ISD::BR_JT, ISD::VAARG, ISD::VACOPY, ISD::VAEND, ISD::STACKSAVE,
                      ISD::STACKRESTORE})
    setOperationAction(op, MVT::Other, Expand);
  for (unsigned op : {ISD::SDIV, ISD::UDIV, ISD::SREM, ISD::UREM})
    setOperationAction(op, MVT::i32, LibCall);
  for (unsigned op : {ISD::CTPOP, ISD::SMIN, ISD::SMAX, ISD::SADDSAT, ISD::SSUBSAT})
    setOperationAction(op, MVT::i32, Legal);
  // Products that may overflow are computed in place: the runtime has no function for them.
  for (RTLIB::Libcall call : {RTLIB::MUL_I64, RTLIB::MUL_I128, RTLIB::MULO_I64})
    setLibcallName(call, nullptr);
  setOperationAction(ISD::SIGN_EXTEND_INREG, MVT::i1, Expand);
  for (unsigned extension : {ISD::EXTLOAD, ISD::ZEXTLOAD, ISD::SEXTLOAD})
    setLoadExtAction(extension, MVT::i32, MVT::i1, Promote);
  setTargetDAGCombine({ISD::MUL, ISD::OR, ISD::SRA, ISD::SRL});
  for (MVT type : {MVT::i8, MVT::i16, MVT::i32})
    for (unsigned mode : {ISD::POST_INC, ISD::POST_DEC}) {
      setIndexedLoadAction(mode, type, Legal);
      setIndexedStoreAction(mode, type, Legal);
    }
}

/// (a + b)(a - b) of halves, into which the middle end turns a*a - b*b, back to that: products of
/// halves are three times as fast, and fit the accumulators.
static SDValue combine_product(SDNode* product, SelectionDAG& dag) {
  SDValue sum = product->getOperand(0);
  SDValue difference = product->getOperand(1);
  if (sum.getOpcode() == ISD::SUB)
    std::swap(sum, difference);
  if (sum.getOpcode() != ISD::ADD || difference.getOpcode() != ISD::SUB)
    return SDValue();
  SDValue a = difference.getOperand(0);
  SDValue b = difference.getOperand(1);
  const bool same = (sum.getOperand(0) == a && sum.getOperand(1) == b) ||
                    (sum.getOperand(0) == b && sum.getOperand(1) == a);
  if (!same || product->getValueType(0) != MVT::i32 || dag.ComputeNumSignBits(a) <= 16 ||
      dag.ComputeNumSignBits(b) <= 16)
    return SDValue();
  SDLoc loc(product);
  SDNodeFlags exact;
  exact.setNoSignedWrap(true);
  return dag.getNode(ISD::SUB, loc, MVT::i32, dag.getNode(ISD::MUL, loc, MVT::i32, a, a, exact),
                     dag.getNode(ISD::MUL, loc, MVT::i32, b, b, exact), exact);
}

SDValue BfinTargetLowering::PerformDAGCombine(SDNode* node, DAGCombinerInfo& info) const {
  switch (node->getOpcode()) {
    case ISD::MUL:
      return combine_product(node, info.DAG);
    case ISD::SRA:
    case ISD::SRL:
      return combineSaturatedHalves(node, info.DAG);
    case BfinISD::COMPUTE:
      return combineComputation(node, info);
    default:
      return combineBfinBitString(node, info);
  }
}

const char* BfinTargetLowering::getTargetNodeName(unsigned opcode) const {
  static constexpr const char* kNames[] = {
      "CALL",   "TAILCALL", "RET",        "RETI",  "SYMBOL", "CMP",      "BITTST",   "JCC",
      "SELECT", "FROMCC",   "ROTCC",      "NOTCC", "MULU16", "MULU16HL", "MULU16HH", "MULLOW",
      "SUM",    "SUMFITS",  "ATLEASTTWO", "SETLO", "SETHI",  "TESTSET",  "COMPUTE",  "SYSTEM"};
  unsigned index = opcode - BfinISD::CALL;
  return opcode >= BfinISD::CALL && index < std::size(kNames) ? kNames[index] : nullptr;
}

/// What has no result and takes its place in `op`'s chain.
static SDValue system_instruction(unsigned opcode, SDValue op, ArrayRef<SDValue> arguments,
                                  SelectionDAG& dag) {
  SDLoc loc(op);
  SmallVector<SDValue, 3> operands = {op.getOperand(0),
                                      dag.getTargetConstant(opcode, loc, MVT::i32)};
  operands.append(arguments.begin(), arguments.end());
  return dag.getNode(BfinISD::SYSTEM, loc, MVT::Other, operands);
}

SDValue BfinTargetLowering::LowerOperation(SDValue op, SelectionDAG& dag) const {
  switch (op.getOpcode()) {
    case ISD::GlobalAddress:
    case ISD::ExternalSymbol:
    case ISD::ConstantPool:
    case ISD::JumpTable:
    case ISD::BlockAddress:
      return lower_symbol(op, dag);
    case ISD::BR_CC:
      return lower_branch(op, dag);
    case ISD::SELECT_CC:
      return lower_select(op, dag);
    case ISD::SETCC:
      return lower_setcc(op, dag);
    case ISD::UMUL_LOHI:
    case ISD::MULHU:
      return lower_wide_product(op, dag);
    case ISD::ABS:
      // The machine's own saturates, C's smallest integer stays itself.
      return dag.ComputeNumSignBits(op.getOperand(0)) > 1 ? op : expandABS(op.getNode(), dag);
    case ISD::SHL_PARTS:
    case ISD::SRL_PARTS:
    case ISD::SRA_PARTS: {
      SDValue low;
      SDValue high;
      expandShiftParts(op.getNode(), low, high, dag);
      return dag.getMergeValues({low, high}, SDLoc(op));
    }
    case ISD::VASTART:
      return lower_va_start(op, dag);
    case ISD::ATOMIC_FENCE:
      return lower_fence(op, dag);
    case ISD::TRAP:
      return system_instruction(Bfin::EXCPT, op, {dag.getTargetConstant(15, SDLoc(op), MVT::i32)},
                                dag);
    default:
      report_fatal_error("no lowering for a selection node");
  }
}

SDValue BfinTargetLowering::lower_symbol(SDValue op, SelectionDAG& dag) const {
  SDLoc loc(op);
  SDValue target;
  int64_t offset = 0;
  if (auto* global = dyn_cast<GlobalAddressSDNode>(op)) {
    target = dag.getTargetGlobalAddress(global->getGlobal(), loc, MVT::i32);
    offset = global->getOffset();
  } else if (auto* symbol = dyn_cast<ExternalSymbolSDNode>(op)) {
    target = dag.getTargetExternalSymbol(symbol->getSymbol(), MVT::i32);
  } else if (auto* table = dyn_cast<JumpTableSDNode>(op)) {
    target = dag.getTargetJumpTable(table->getIndex(), MVT::i32);
  } else if (auto* block = dyn_cast<BlockAddressSDNode>(op)) {
    target = dag.getTargetBlockAddress(block->getBlockAddress(), MVT::i32);
    offset = block->getOffset();
  } else {
    auto* pool = cast<ConstantPoolSDNode>(op);
    target = dag.getTargetConstantPool(pool->getConstVal(), MVT::i32, pool->getAlign());
    offset = pool->getOffset();
  }
  SDValue address = dag.getNode(BfinISD::SYMBOL, loc, MVT::i32, target);
  if (offset != 0)
    address = dag.getNode(ISD::ADD, loc, MVT::i32, address, dag.getConstant(offset, loc, MVT::i32));
  return address;
}

namespace {

struct Condition {
  SDValue glue;
  bool sense = true;
};

/// A test of one bit against zero, which needs no mask in a register.
bool match_bit_test(SDValue left, SDValue right, ISD::CondCode code, SDValue& value,
                    unsigned& bit) {
  if ((code != ISD::SETEQ && code != ISD::SETNE) || left.getOpcode() != ISD::AND)
    return false;
  auto* mask = dyn_cast<ConstantSDNode>(left.getOperand(1));
  if (mask == nullptr || !mask->getAPIntValue().isPowerOf2())
    return false;
  bool against_zero = isNullConstant(right);
  bool against_mask = isa<ConstantSDNode>(right) &&
                      cast<ConstantSDNode>(right)->getAPIntValue() == mask->getAPIntValue();
  if (!against_zero && !against_mask)
    return false;
  value = left.getOperand(0);
  bit = mask->getAPIntValue().logBase2();
  return true;
}

/// Brings a comparison with a constant to a form whose constant is one lower, where only that one
/// fits the instruction (x < 4 is x <= 3), and greater-than to a negated less-or-equal.
void normalise(SDValue& left, SDValue& right, ISD::CondCode& code, SelectionDAG& dag,
               const SDLoc& loc) {
  if (isa<ConstantSDNode>(left)) {
    std::swap(left, right);
    code = ISD::getSetCCSwappedOperands(code);
  }
  auto* constant = dyn_cast<ConstantSDNode>(right);
  if (constant == nullptr)
    return;
  int64_t value = constant->getSExtValue();
  auto lower = [&](ISD::CondCode to) {
    code = to;
    right = dag.getConstant(static_cast<uint32_t>(value - 1), loc, MVT::i32);
  };
  if (code == ISD::SETLT && value == 4)
    lower(ISD::SETLE);
  else if (code == ISD::SETGE && value == 4)
    lower(ISD::SETGT);
  else if (code == ISD::SETULT && value == 8)
    lower(ISD::SETULE);
  else if (code == ISD::SETUGE && value == 8)
    lower(ISD::SETUGT);
}

Condition compare(SDValue left, SDValue right, ISD::CondCode code, SelectionDAG& dag,
                  const SDLoc& loc) {
  SDValue value;
  unsigned bit = 0;
  if (match_bit_test(left, right, code, value, bit)) {
    bool set_means_true = (code == ISD::SETNE) == isNullConstant(right);
    return {dag.getNode(BfinISD::BITTST, loc, MVT::Glue, value,
                        dag.getTargetConstant(bit, loc, MVT::i32)),
            set_means_true};
  }
  normalise(left, right, code, dag, loc);
  bool sense = true;
  bool constant = isa<ConstantSDNode>(right);
  switch (code) {
    case ISD::SETNE:
      code = ISD::SETEQ;
      sense = false;
      break;
    case ISD::SETGE:
    case ISD::SETUGE:
      code = code == ISD::SETGE ? ISD::SETLT : ISD::SETULT;
      sense = false;
      break;
    case ISD::SETGT:
    case ISD::SETUGT:
      if (constant) {
        code = code == ISD::SETGT ? ISD::SETLE : ISD::SETULE;
        sense = false;
      } else {
        std::swap(left, right);
        code = code == ISD::SETGT ? ISD::SETLT : ISD::SETULT;
      }
      break;
    default:
      break;
  }
  BfinCC test = kEqual;
  switch (code) {
    case ISD::SETEQ:
      test = kEqual;
      break;
    case ISD::SETLT:
      test = kLess;
      break;
    case ISD::SETLE:
      test = kLessEqual;
      break;
    case ISD::SETULT:
      test = kBelow;
      break;
    case ISD::SETULE:
      test = kBelowEqual;
      break;
    default:
      report_fatal_error("no comparison for a condition code");
  }
  return {
      dag.getNode(BfinISD::CMP, loc, MVT::Glue, left, right, dag.getConstant(test, loc, MVT::i32)),
      sense};
}

ISD::CondCode condition_code(SDValue node) { return cast<CondCodeSDNode>(node)->get(); }

}  // namespace

SDValue BfinTargetLowering::lower_branch(SDValue op, SelectionDAG& dag) const {
  SDLoc loc(op);
  Condition test =
      compare(op.getOperand(2), op.getOperand(3), condition_code(op.getOperand(1)), dag, loc);
  return dag.getNode(BfinISD::JCC, loc, MVT::Other, op.getOperand(0), op.getOperand(4),
                     dag.getConstant(test.sense, loc, MVT::i32), test.glue);
}

SDValue BfinTargetLowering::lower_select(SDValue op, SelectionDAG& dag) const {
  SDLoc loc(op);
  Condition test =
      compare(op.getOperand(0), op.getOperand(1), condition_code(op.getOperand(4)), dag, loc);
  return dag.getNode(BfinISD::SELECT, loc, MVT::i32, op.getOperand(2), op.getOperand(3),
                     dag.getConstant(test.sense, loc, MVT::i32), test.glue);
}

SDValue BfinTargetLowering::lower_setcc(SDValue op, SelectionDAG& dag) const {
  SDLoc loc(op);
  Condition test =
      compare(op.getOperand(0), op.getOperand(1), condition_code(op.getOperand(2)), dag, loc);
  if (!test.sense)
    test.glue = dag.getNode(BfinISD::NOTCC, loc, MVT::Glue, test.glue);
  return dag.getNode(BfinISD::FROMCC, loc, MVT::i32, test.glue);
}

/// 32 x 32 -> 64 unsigned out of four products of halves.
SDValue BfinTargetLowering::lower_wide_product(SDValue op, SelectionDAG& dag) const {
  SDLoc loc(op);
  SDValue a = op.getOperand(0);
  SDValue b = op.getOperand(1);
  auto node = [&](unsigned opcode, SDValue x, SDValue y) {
    return dag.getNode(opcode, loc, MVT::i32, x, y);
  };
  SDValue sixteen = dag.getConstant(16, loc, MVT::i32);
  SDValue low_mask = dag.getConstant(0xffff, loc, MVT::i32);
  SDValue ll = node(BfinISD::MULU16, a, b);
  SDValue hl = node(BfinISD::MULU16HL, a, b);
  SDValue lh = node(BfinISD::MULU16HL, b, a);
  SDValue hh = node(BfinISD::MULU16HH, a, b);
  // Neither sum can pass 32 bits: (2^16-1)^2 + 2 (2^16-1) = 2^32 - 1.
  SDValue t = node(ISD::ADD, hl, node(ISD::SRL, ll, sixteen));
  SDValue u = node(ISD::ADD, lh, node(ISD::AND, t, low_mask));
  SDValue high =
      node(ISD::ADD, node(ISD::ADD, hh, node(ISD::SRL, t, sixteen)), node(ISD::SRL, u, sixteen));
  if (op.getOpcode() == ISD::MULHU)
    return high;
  SDValue low = node(ISD::MUL, a, b);
  return dag.getMergeValues({low, high}, loc);
}

SDValue BfinTargetLowering::lower_va_start(SDValue op, SelectionDAG& dag) const {
  const auto* info = dag.getMachineFunction().getInfo<BfinMachineFunctionInfo>();
  SDValue first = dag.getFrameIndex(info->varargs_index, MVT::i32);
  const Value* list = cast<SrcValueSDNode>(op.getOperand(2))->getValue();
  return dag.getStore(op.getOperand(0), SDLoc(op), first, op.getOperand(1),
                      MachinePointerInfo(list));
}

SDValue BfinTargetLowering::lower_fence(SDValue op, SelectionDAG& dag) const {
  // Within one core, program order is kept; towards the other core, SSYNC drains the writes.
  auto scope = static_cast<SyncScope::ID>(op.getConstantOperandVal(2));
  if (scope == SyncScope::SingleThread)
    return dag.getNode(ISD::MEMBARRIER, SDLoc(op), MVT::Other, op.getOperand(0));
  return system_instruction(Bfin::SSYNC, op, {}, dag);
}

bool BfinTargetLowering::isLegalAddressingMode(const DataLayout& layout, const AddrMode& mode,
                                               Type* type, unsigned, Instruction*) const {
  if (mode.BaseGV != nullptr || mode.Scale != 0)
    return mode.BaseGV == nullptr && mode.Scale == 1 && !mode.HasBaseReg && mode.BaseOffs == 0;
  int64_t size = type->isSized() ? static_cast<int64_t>(layout.getTypeStoreSize(type)) : 1;
  size = std::clamp<int64_t>(size, 1, 4);
  return mode.BaseOffs % size == 0 && mode.BaseOffs >= -32767 * size &&
         mode.BaseOffs <= 32767 * size;
}

/// A shift and a sum are faster than a product and its factor in a register.
bool BfinTargetLowering::decomposeMulByConstant(LLVMContext&, EVT type, SDValue factor) const {
  const auto* constant = dyn_cast<ConstantSDNode>(factor);
  if (type != MVT::i32 || constant == nullptr)
    return false;
  const APInt& value = constant->getAPIntValue();
  return (value - 1).isPowerOf2() || (value + 1).isPowerOf2() || (1 - value).isPowerOf2() ||
         (-1 - value).isPowerOf2();
}

bool BfinTargetLowering::isTruncateFree(Type* from, Type* to) const {
  return from->isIntegerTy() && to->isIntegerTy() &&
         from->getPrimitiveSizeInBits() > to->getPrimitiveSizeInBits();
}

bool BfinTargetLowering::isZExtFree(SDValue value, EVT to) const {
  if (auto* load = dyn_cast<LoadSDNode>(value)) {
    EVT memory = load->getMemoryVT();
    return (memory == MVT::i8 || memory == MVT::i16) && load->getExtensionType() != ISD::SEXTLOAD;
  }
  return TargetLowering::isZExtFree(value, to);
}

bool BfinTargetLowering::getPostIndexedAddressParts(SDNode* access, SDNode* step, SDValue& base,
                                                    SDValue& offset, ISD::MemIndexedMode& mode,
                                                    SelectionDAG& dag) const {
  EVT memory;
  if (auto* load = dyn_cast<LoadSDNode>(access)) {
    memory = load->getMemoryVT();
  } else if (auto* store = dyn_cast<StoreSDNode>(access)) {
    memory = store->getMemoryVT();
    // Which value [P0++] = P0 writes is not worth knowing.
    if (store->getValue() == store->getBasePtr())
      return false;
  } else {
    return false;
  }
  if (memory != MVT::i8 && memory != MVT::i16 && memory != MVT::i32)
    return false;
  if (step->getOpcode() != ISD::ADD && step->getOpcode() != ISD::SUB)
    return false;
  auto* amount = dyn_cast<ConstantSDNode>(step->getOperand(1));
  if (amount == nullptr)
    return false;
  int64_t bytes = amount->getSExtValue();
  if (step->getOpcode() == ISD::SUB)
    bytes = -bytes;
  auto size = static_cast<int64_t>(memory.getStoreSize().getFixedValue());
  if (bytes != size && bytes != -size)
    return false;
  base = step->getOperand(0);
  offset = dag.getConstant(size, SDLoc(step), MVT::i32);
  mode = bytes > 0 ? ISD::POST_INC : ISD::POST_DEC;
  return true;
}

}  // namespace llvm
