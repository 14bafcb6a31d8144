// Calls of named instructions on their way through selection: to nodes, two nodes to one where an
// instruction gives both results, and to machine instructions in the form that reads the halves
// where they stand.
#include "BfinNamedLowering.hpp"

#include <llvm/CodeGen/MachineFrameInfo.h>
#include <llvm/CodeGen/SelectionDAG.h>

#include "BfinNamedInstructions.hpp"
#include "BfinSubtarget.hpp"

#define GET_INSTRMAP_INFO
#include "BfinGenInstrInfo.inc"

namespace llvm {
namespace {

using Values = SmallVector<SDValue, 6>;

/// A shift by the low half of a register, and its forms by a number.
struct Shift {
  unsigned by_register;
  unsigned left;
  unsigned right;
  int64_t most;
  bool arithmetic;
};
constexpr Shift kShifts[] = {
    {Bfin::ASHIFTVS, Bfin::SHLVS, Bfin::SRAV, 15, true},
    {Bfin::LSHIFTV, Bfin::SHLV, Bfin::SRLV, 15, false},
    {Bfin::ASHIFTS, Bfin::SHLS, Bfin::SRAI, 31, true},
    {Bfin::LSHIFT, Bfin::SHLI, Bfin::SRLI, 31, false},
};

/// Two instructions on the same operands that one instruction does. A sum's operands may be
/// exchanged.
struct Both {
  unsigned first;
  unsigned second;
  unsigned together;
  bool commutes;
};
constexpr Both kBoth[] = {
    {Bfin::ADDV, Bfin::SUBV, Bfin::BOTHV, true},
    {Bfin::ADDVS, Bfin::SUBVS, Bfin::BOTHVS, true},
    {Bfin::ADDSUBV, Bfin::SUBADDV, Bfin::BOTHX, false},
    {Bfin::ADDSUBVS, Bfin::SUBADDVS, Bfin::BOTHXS, false},
};

/// The sum of a complex product, in the form of the two accumulators: imaginary and real part, each
/// in a high half.
void split_sum(unsigned opcode, Values& arguments, SelectionDAG& dag, const SDLoc& loc) {
  if (opcode == Bfin::MUL32R)
    arguments.insert(arguments.begin(), dag.getConstant(0x40000000, loc, MVT::i32));
  if (opcode != Bfin::CMAC && opcode != Bfin::CMACW && opcode != Bfin::CMSU &&
      opcode != Bfin::CMSUW)
    return;
  const SDValue sum = arguments[0];
  arguments[0] =
      dag.getNode(ISD::AND, loc, MVT::i32, sum, dag.getConstant(0xffff0000, loc, MVT::i32));
  arguments.insert(arguments.begin() + 1,
                   dag.getNode(ISD::SHL, loc, MVT::i32, sum, dag.getConstant(16, loc, MVT::i32)));
}

void lower_computation(const BfinNamedInstruction& instruction, Values arguments,
                       TargetLowering::CallLoweringInfo& call, SmallVectorImpl<SDValue>& values) {
  SelectionDAG& dag = call.DAG;
  const SDLoc& loc = call.DL;
  uint64_t halves = 0;
  for (const auto& [number, letter] : enumerate(instruction.types.substr(2)))
    halves |= uint64_t{letter == 's'} << number;
  split_sum(instruction.opcode, arguments, dag, loc);
  Values operands = {dag.getTargetConstant(instruction.opcode, loc, MVT::i32),
                     dag.getTargetConstant(halves, loc, MVT::i32)};
  operands.append(arguments);
  const SDVTList types =
      call.Ins.size() == 2 ? dag.getVTList(MVT::i32, MVT::i32) : dag.getVTList(MVT::i32);
  const SDValue node = dag.getNode(BfinISD::COMPUTE, loc, types, operands);
  for (unsigned i = 0; i < call.Ins.size(); ++i)
    values.push_back(node.getValue(i));
  if (instruction.types[0] == 's')
    values[0] =
        dag.getNode(ISD::SIGN_EXTEND_INREG, loc, MVT::i32, node, dag.getValueType(MVT::i16));
}

void lower_action(const BfinNamedInstruction& instruction, const Values& arguments,
                  TargetLowering::CallLoweringInfo& call, SmallVectorImpl<SDValue>& values,
                  SDValue& chain) {
  SelectionDAG& dag = call.DAG;
  const SDLoc& loc = call.DL;
  if (instruction.opcode == Bfin::TESTSET) {
    chain = dag.getNode(BfinISD::TESTSET, loc, dag.getVTList(MVT::Other, MVT::Glue), chain,
                        arguments[0]);
    values.push_back(dag.getNode(BfinISD::FROMCC, loc, MVT::i32, chain.getValue(1)));
    return;
  }
  Values operands = {chain, dag.getTargetConstant(instruction.opcode, loc, MVT::i32)};
  operands.append(arguments);
  if (call.Ins.empty()) {
    chain = dag.getNode(BfinISD::SYSTEM, loc, MVT::Other, operands);
    return;
  }
  values.push_back(
      dag.getNode(BfinISD::SYSTEM, loc, dag.getVTList(MVT::i32, MVT::Other), operands));
  chain = values[0].getValue(1);
}

/// The value whose low half is that of `value`: what only extends is left out.
SDValue without_extension(SDValue value) {
  for (;;) {
    const unsigned opcode = value.getOpcode();
    const bool extended = ((opcode == ISD::SIGN_EXTEND_INREG || opcode == ISD::AssertSext ||
                            opcode == ISD::AssertZext) &&
                           cast<VTSDNode>(value.getOperand(1))->getVT() == MVT::i16) ||
                          (opcode == ISD::AND && isa<ConstantSDNode>(value.getOperand(1)) &&
                           (value.getConstantOperandVal(1) & 0xffff) == 0xffff);
    if (!extended)
      return value;
    value = value.getOperand(0);
  }
}

/// Takes the register whose high half `value` is; false when it is none.
bool take_high(SDValue& value) {
  if ((value.getOpcode() != ISD::SRL && value.getOpcode() != ISD::SRA) ||
      !isa<ConstantSDNode>(value.getOperand(1)) || value.getConstantOperandVal(1) != 16)
    return false;
  value = value.getOperand(0);
  return true;
}

/// The instruction that reads the halves where they stand, for one that reads low halves.
unsigned use_halves(unsigned opcode, uint64_t halves, Values& arguments) {
  bool high[2] = {};
  const bool has_forms =
      Bfin::getBfinHalves(static_cast<uint16_t>(opcode), Bfin::HalvesRead_HL) >= 0;
  const bool second_too = has_forms && opcode != Bfin::EXPADJH_LL;
  for (unsigned i = 0; i < arguments.size(); ++i) {
    if ((halves >> i & 1) == 0)
      continue;
    arguments[i] = without_extension(arguments[i]);
    if (i < 2 && (i == 0 ? has_forms : second_too))
      high[i] = take_high(arguments[i]);
  }
  if (!high[0] && !high[1])
    return opcode;
  const Bfin::HalvesRead read = !high[1]  ? Bfin::HalvesRead_HL
                                : high[0] ? Bfin::HalvesRead_HH
                                          : Bfin::HalvesRead_LH;
  return static_cast<unsigned>(Bfin::getBfinHalves(static_cast<uint16_t>(opcode), read));
}

/// A shift by a known number.
unsigned use_number(unsigned opcode, Values& arguments, SelectionDAG& dag, const SDLoc& loc) {
  const auto* shift = find_if(kShifts, [&](const Shift& one) { return one.by_register == opcode; });
  const auto* amount =
      shift == std::end(kShifts) ? nullptr : dyn_cast<ConstantSDNode>(arguments[1]);
  if (amount == nullptr)
    return opcode;
  const int64_t left = SignExtend64<6>(amount->getZExtValue());
  const int64_t number =
      left < 0 && shift->arithmetic ? std::min(-left, shift->most) : std::abs(left);
  if (number > shift->most)
    return opcode;
  arguments[1] = dag.getTargetConstant(static_cast<uint64_t>(number), loc, MVT::i32);
  return left > 0 ? shift->left : shift->right;
}

/// Instructions on the pairs R1:0 and R3:2 and the index registers: the arguments go there, and
/// what is left to hand over is the glue.
void use_fixed_registers(Values& arguments, SelectionDAG& dag, const SDLoc& loc) {
  constexpr MCPhysReg kRegisters[] = {Bfin::R0, Bfin::R1, Bfin::I0, Bfin::R2, Bfin::R3, Bfin::I1};
  SDValue glue;
  for (const auto& [reg, argument] : zip(kRegisters, arguments))
    glue = dag.getCopyToReg(dag.getEntryNode(), loc, reg, argument, glue).getValue(1);
  arguments = {glue};
}

/// The other of two computations on the same operands; null when there is none.
SDNode* partner(SDNode* node, unsigned opcode, bool exchanged) {
  const SDValue first = node->getOperand(exchanged ? 3 : 2);
  const SDValue second = node->getOperand(exchanged ? 2 : 3);
  for (SDNode* user : first->uses())
    if (user->getOpcode() == BfinISD::COMPUTE && user->getConstantOperandVal(0) == opcode &&
        user->getOperand(2) == first && user->getOperand(3) == second)
      return user;
  return nullptr;
}

}  // namespace

bool lowerNamedInstruction(StringRef name, TargetLowering::CallLoweringInfo& call,
                           SmallVectorImpl<SDValue>& values, SDValue& chain) {
  const BfinNamedInstruction* instruction = findNamedInstruction(name);
  if (instruction == nullptr)
    return false;
  SelectionDAG& dag = call.DAG;
  const SDLoc& loc = call.DL;
  Values arguments;
  const SDValue* value = call.OutVals.begin();
  for (const char letter : instruction->types.substr(2)) {
    SDValue argument = *value++;
    if (letter == 'n' || letter == 'r')
      argument =
          dag.getTargetConstant(cast<ConstantSDNode>(argument)->getZExtValue(), loc, MVT::i32);
    else if (letter == 'h')
      argument =
          dag.getNode(ISD::SIGN_EXTEND_INREG, loc, MVT::i32, argument, dag.getValueType(MVT::i16));
    arguments.push_back(argument);
    if (letter == 'l')
      arguments.push_back(*value++);
  }
  switch (instruction->kind) {
    case BfinNamedInstruction::Kind::node:
    case BfinNamedInstruction::Kind::internal:
      values.push_back(dag.getNode(instruction->opcode, loc, MVT::i32, arguments));
      break;
    case BfinNamedInstruction::Kind::compute:
      lower_computation(*instruction, arguments, call, values);
      break;
    case BfinNamedInstruction::Kind::circular:
      return false;
    case BfinNamedInstruction::Kind::ring:
    case BfinNamedInstruction::Kind::system:
      lower_action(*instruction, arguments, call, values, chain);
      break;
  }
  return true;
}

SDValue combineComputation(SDNode* node, TargetLowering::DAGCombinerInfo& info) {
  for (const Both& both : kBoth) {
    if (node->getConstantOperandVal(0) != both.first)
      continue;
    SDNode* second = partner(node, both.second, /*exchanged=*/false);
    if (second == nullptr && both.commutes)
      second = partner(node, both.second, /*exchanged=*/true);
    if (second == nullptr)
      return SDValue();
    SelectionDAG& dag = info.DAG;
    const SDLoc loc(node);
    const SDValue together =
        dag.getNode(BfinISD::COMPUTE, loc, dag.getVTList(MVT::i32, MVT::i32),
                    {dag.getTargetConstant(both.together, loc, MVT::i32), node->getOperand(1),
                     second->getOperand(2), second->getOperand(3)});
    info.CombineTo(second, together.getValue(1));
    return together.getValue(0);
  }
  return SDValue();
}

SDValue combineSaturatedHalves(SDNode* node, SelectionDAG& dag) {
  const auto is_by_16 = [](SDValue value) {
    return isa<ConstantSDNode>(value.getOperand(1)) && value.getConstantOperandVal(1) == 16;
  };
  const SDValue sum = node->getOperand(0);
  const bool adds = sum.getOpcode() == ISD::SADDSAT;
  if (node->getValueType(0) != MVT::i32 || !is_by_16(SDValue(node, 0)) ||
      (!adds && sum.getOpcode() != ISD::SSUBSAT) || any_of(sum->op_values(), [&](SDValue operand) {
        return operand.getOpcode() != ISD::SHL || !is_by_16(operand);
      }))
    return SDValue();
  const SDLoc loc(node);
  const SDValue pairs =
      dag.getNode(BfinISD::COMPUTE, loc, MVT::i32,
                  {dag.getTargetConstant(adds ? Bfin::ADDVS : Bfin::SUBVS, loc, MVT::i32),
                   dag.getTargetConstant(0, loc, MVT::i32), sum.getOperand(0).getOperand(0),
                   sum.getOperand(1).getOperand(0)});
  if (node->getOpcode() == ISD::SRA)
    return dag.getNode(ISD::SIGN_EXTEND_INREG, loc, MVT::i32, pairs, dag.getValueType(MVT::i16));
  return dag.getNode(ISD::AND, loc, MVT::i32, pairs, dag.getConstant(0xffff, loc, MVT::i32));
}

SDNode* selectComputation(SDNode* node, SelectionDAG& dag) {
  const SDLoc loc(node);
  Values arguments(node->op_begin() + 2, node->op_end());
  unsigned opcode = static_cast<unsigned>(node->getConstantOperandVal(0));
  opcode = use_halves(opcode, node->getConstantOperandVal(1), arguments);
  opcode = use_number(opcode, arguments, dag, loc);
  const auto& instructions = *dag.getSubtarget().getInstrInfo();
  const MCInstrDesc& description = instructions.get(opcode);
  if (is_contained(description.implicit_uses(), Bfin::I0))
    use_fixed_registers(arguments, dag, loc);
  // The half that is not written may be anything.
  if (description.getNumOperands() > description.getNumDefs() + arguments.size())
    arguments.insert(arguments.begin(),
                     SDValue(dag.getMachineNode(TargetOpcode::IMPLICIT_DEF, loc, MVT::i32), 0));
  return dag.getMachineNode(opcode, loc, node->getVTList(), arguments);
}

SDNode* selectAction(SDNode* node, SelectionDAG& dag) {
  Values operands(node->op_begin() + 2, node->op_end());
  operands.push_back(node->getOperand(0));
  return dag.getMachineNode(static_cast<unsigned>(node->getConstantOperandVal(1)), SDLoc(node),
                            node->getVTList(), operands);
}

}  // namespace llvm
