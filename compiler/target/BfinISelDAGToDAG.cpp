// Selection: what TableGen's patterns cannot say (addresses, stepping accesses).
#include <llvm/CodeGen/SelectionDAGISel.h>

#include "Bfin.hpp"
#include "BfinNamedLowering.hpp"
#include "BfinTargetMachine.hpp"

#define DEBUG_TYPE "bfin-isel"

namespace llvm {
namespace {

class BfinDAGToDAGISel : public SelectionDAGISel {
 public:
  BfinDAGToDAGISel(BfinTargetMachine& machine, CodeGenOptLevel level)
      : SelectionDAGISel(machine, level) {}

 private:
#include "BfinGenDAGISel.inc"

  void Select(SDNode* node) override;

  /// Base and displacement of an access of Size bytes.
  template <int Size>
  bool selectAddr(SDValue address, SDValue& base, SDValue& displacement) {
    SDLoc loc(address);
    auto set = [&](SDValue from, int64_t offset) {
      base = from;
      if (auto* frame = dyn_cast<FrameIndexSDNode>(from))
        base = CurDAG->getTargetFrameIndex(frame->getIndex(), MVT::i32);
      displacement = CurDAG->getTargetConstant(static_cast<uint64_t>(offset), loc, MVT::i32);
      return true;
    };
    if (CurDAG->isBaseWithConstantOffset(address)) {
      int64_t offset = cast<ConstantSDNode>(address.getOperand(1))->getSExtValue();
      constexpr int64_t kReach = int64_t{32767} * Size;
      if (offset % Size == 0 && offset >= -kReach && offset <= kReach)
        return set(address.getOperand(0), offset);
    }
    return set(address, 0);
  }

  bool select_half(SDValue value, unsigned half, SDValue& reg, SDValue& number) {
    reg = value;
    number = CurDAG->getTargetConstant(half, SDLoc(value), MVT::i32);
    return true;
  }

  static bool is_shift_by_16(SDValue value, unsigned opcode) {
    return value.getOpcode() == opcode && isa<ConstantSDNode>(value.getOperand(1)) &&
           value.getConstantOperandVal(1) == 16;
  }

  /// A factor of a signed product of halves, and in which half of which register it is found.
  bool selectSignedHalf(SDValue value, SDValue& reg, SDValue& half) {
    if (CurDAG->ComputeNumSignBits(value) <= 16)
      return false;
    if (is_shift_by_16(value, ISD::SRA))
      return select_half(value.getOperand(0), 1, reg, half);
    if (value.getOpcode() == ISD::SIGN_EXTEND_INREG &&
        cast<VTSDNode>(value.getOperand(1))->getVT() == MVT::i16)
      value = value.getOperand(0);
    return select_half(value, 0, reg, half);
  }

  bool selectUnsignedHalf(SDValue value, SDValue& reg, SDValue& half) {
    if (!CurDAG->MaskedValueIsZero(value, APInt::getHighBitsSet(32, 16)))
      return false;
    if (is_shift_by_16(value, ISD::SRL))
      return select_half(value.getOperand(0), 1, reg, half);
    if (value.getOpcode() == ISD::AND && isa<ConstantSDNode>(value.getOperand(1)) &&
        value.getConstantOperandVal(1) == 0xffff)
      value = value.getOperand(0);
    return select_half(value, 0, reg, half);
  }

  /// "m": the address in a register.
  bool SelectInlineAsmMemoryOperand(const SDValue& op, InlineAsm::ConstraintCode,
                                    std::vector<SDValue>& operands) override {
    SDValue address = op;
    if (auto* frame = dyn_cast<FrameIndexSDNode>(op)) {
      SDLoc loc(op);
      address =
          SDValue(CurDAG->getMachineNode(Bfin::LEA, loc, MVT::i32,
                                         CurDAG->getTargetFrameIndex(frame->getIndex(), MVT::i32),
                                         CurDAG->getTargetConstant(0, loc, MVT::i32)),
                  0);
    }
    operands.push_back(address);
    return false;
  }

  bool select_stepping_load(SDNode* node);
  bool select_stepping_store(SDNode* node);
};

unsigned stepping_load_opcode(const LoadSDNode& load, bool up) {
  bool sign = load.getExtensionType() == ISD::SEXTLOAD;
  switch (load.getMemoryVT().getSimpleVT().SimpleTy) {
    case MVT::i32:
      return up ? Bfin::LDWInc : Bfin::LDWDec;
    case MVT::i16:
      if (sign)
        return up ? Bfin::LDHXInc : Bfin::LDHXDec;
      return up ? Bfin::LDHZInc : Bfin::LDHZDec;
    case MVT::i8:
      if (sign)
        return up ? Bfin::LDBXInc : Bfin::LDBXDec;
      return up ? Bfin::LDBZInc : Bfin::LDBZDec;
    default:
      return 0;
  }
}

bool BfinDAGToDAGISel::select_stepping_load(SDNode* node) {
  auto* load = cast<LoadSDNode>(node);
  if (load->getAddressingMode() == ISD::UNINDEXED)
    return false;
  unsigned opcode = stepping_load_opcode(*load, load->getAddressingMode() == ISD::POST_INC);
  if (opcode == 0)
    return false;
  MachineSDNode* inst = CurDAG->getMachineNode(opcode, SDLoc(node), MVT::i32, MVT::i32, MVT::Other,
                                               load->getBasePtr(), load->getChain());
  CurDAG->setNodeMemRefs(inst, {load->getMemOperand()});
  ReplaceNode(node, inst);
  return true;
}

bool BfinDAGToDAGISel::select_stepping_store(SDNode* node) {
  auto* store = cast<StoreSDNode>(node);
  if (store->getAddressingMode() == ISD::UNINDEXED)
    return false;
  bool up = store->getAddressingMode() == ISD::POST_INC;
  unsigned opcode = 0;
  switch (store->getMemoryVT().getSimpleVT().SimpleTy) {
    case MVT::i32:
      opcode = up ? Bfin::STWInc : Bfin::STWDec;
      break;
    case MVT::i16:
      opcode = up ? Bfin::STHInc : Bfin::STHDec;
      break;
    case MVT::i8:
      opcode = up ? Bfin::STBInc : Bfin::STBDec;
      break;
    default:
      return false;
  }
  MachineSDNode* inst =
      CurDAG->getMachineNode(opcode, SDLoc(node), MVT::i32, MVT::Other, store->getValue(),
                             store->getBasePtr(), store->getChain());
  CurDAG->setNodeMemRefs(inst, {store->getMemOperand()});
  ReplaceNode(node, inst);
  return true;
}

void BfinDAGToDAGISel::Select(SDNode* node) {
  if (node->isMachineOpcode()) {
    node->setNodeId(-1);
    return;
  }
  SDLoc loc(node);
  switch (node->getOpcode()) {
    case ISD::LOAD:
      if (select_stepping_load(node))
        return;
      break;
    case ISD::STORE:
      if (select_stepping_store(node))
        return;
      break;
    case BfinISD::COMPUTE:
      ReplaceNode(node, selectComputation(node, *CurDAG));
      return;
    case BfinISD::SYSTEM:
      ReplaceNode(node, selectAction(node, *CurDAG));
      return;
    case ISD::FrameIndex: {
      int index = cast<FrameIndexSDNode>(node)->getIndex();
      SDValue zero = CurDAG->getTargetConstant(0, loc, MVT::i32);
      ReplaceNode(node, CurDAG->getMachineNode(Bfin::LEA, loc, MVT::i32,
                                               CurDAG->getTargetFrameIndex(index, MVT::i32), zero));
      return;
    }
    default:
      break;
  }
  SelectCode(node);
}

class BfinDAGToDAGISelLegacy : public SelectionDAGISelLegacy {
 public:
  static char ID;
  BfinDAGToDAGISelLegacy(BfinTargetMachine& machine, CodeGenOptLevel level)
      : SelectionDAGISelLegacy(ID, std::make_unique<BfinDAGToDAGISel>(machine, level)) {}
};

char BfinDAGToDAGISelLegacy::ID = 0;

}  // namespace

FunctionPass* createBfinISelDag(BfinTargetMachine& machine, CodeGenOptLevel level) {
  return new BfinDAGToDAGISelLegacy(machine, level);
}

}  // namespace llvm
