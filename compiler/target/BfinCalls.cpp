// Arguments, calls, results.
#include <llvm/CodeGen/CallingConvLower.h>
#include <llvm/CodeGen/MachineFrameInfo.h>
#include <llvm/CodeGen/SelectionDAG.h>

#include "BfinMachineFunctionInfo.hpp"
#include "BfinNamedLowering.hpp"
#include "BfinSubtarget.hpp"

namespace llvm {

#include "BfinGenCallingConv.inc"

namespace {

constexpr unsigned kHomeBytes = 12;  // the caller's room for R0..R2
constexpr MCPhysReg kArgumentRegisters[] = {Bfin::R0, Bfin::R1, Bfin::R2};

CCAssignFn* places_of(CallingConv::ID convention) {
  return convention == kInRegisters ? CC_BfinInRegisters : CC_Bfin;
}

/// Whether a call in return position may be a jump: the callee then returns to our caller, finds
/// our arguments' homes at its own place (where variadic functions keep theirs), and nothing of
/// ours above them.
bool may_jump(const TargetLowering::CallLoweringInfo& call, SDValue callee,
              ArrayRef<CCValAssign> places, const MachineFunction& function) {
  const bool direct = isa<GlobalAddressSDNode>(callee) || isa<ExternalSymbolSDNode>(callee);
  return call.IsTailCall && !call.IsVarArg && !function.getFunction().isVarArg() && direct &&
         !isInterruptHandler(function.getFunction()) &&
         none_of(call.Outs, [](const ISD::OutputArg& out) { return out.Flags.isByVal(); }) &&
         all_of(places, [](const CCValAssign& place) { return place.isRegLoc(); });
}

}  // namespace

SDValue BfinTargetLowering::LowerFormalArguments(SDValue chain, CallingConv::ID convention,
                                                 bool variadic,
                                                 const SmallVectorImpl<ISD::InputArg>& ins,
                                                 const SDLoc& loc, SelectionDAG& dag,
                                                 SmallVectorImpl<SDValue>& values) const {
  MachineFunction& function = dag.getMachineFunction();
  MachineFrameInfo& frame = function.getFrameInfo();
  SmallVector<CCValAssign, 16> places;
  CCState state(convention, variadic, function, places, *dag.getContext());
  state.AllocateStack(kHomeBytes, Align(4));
  state.AnalyzeFormalArguments(ins, CC_Bfin);
  for (const CCValAssign& place : places) {
    if (place.isRegLoc()) {
      Register reg = function.addLiveIn(place.getLocReg(), &Bfin::DPRegClass);
      values.push_back(dag.getCopyFromReg(chain, loc, reg, MVT::i32));
    } else {
      int index = frame.CreateFixedObject(4, place.getLocMemOffset(), false);
      values.push_back(dag.getLoad(MVT::i32, loc, chain, dag.getFrameIndex(index, MVT::i32),
                                   MachinePointerInfo::getFixedStack(function, index)));
    }
  }
  if (!variadic)
    return chain;
  // The unnamed arguments are read from memory: those in registers go to their homes first.
  unsigned used = state.getFirstUnallocated(kArgumentRegisters);
  auto* info = function.getInfo<BfinMachineFunctionInfo>();
  info->varargs_index = frame.CreateFixedObject(
      4, used < 3 ? 4 * static_cast<int64_t>(used) : static_cast<int64_t>(state.getStackSize()),
      true);
  SmallVector<SDValue, 3> stores;
  for (unsigned i = used; i < 3; ++i) {
    Register reg = function.addLiveIn(kArgumentRegisters[i], &Bfin::DPRegClass);
    int index = frame.CreateFixedObject(4, 4 * static_cast<int64_t>(i), false);
    SDValue value = dag.getCopyFromReg(chain, loc, reg, MVT::i32);
    stores.push_back(
        dag.getStore(chain, loc, value, dag.getFrameIndex(index, MVT::i32), MachinePointerInfo()));
  }
  if (!stores.empty()) {
    stores.push_back(chain);
    chain = dag.getNode(ISD::TokenFactor, loc, MVT::Other, stores);
  }
  return chain;
}

SDValue BfinTargetLowering::LowerCall(CallLoweringInfo& call,
                                      SmallVectorImpl<SDValue>& values) const {
  SelectionDAG& dag = call.DAG;
  const SDLoc& loc = call.DL;
  MachineFunction& function = dag.getMachineFunction();
  SDValue chain = call.Chain;
  SDValue callee = call.Callee;
  if (auto* global = dyn_cast<GlobalAddressSDNode>(callee)) {
    if (lowerNamedInstruction(global->getGlobal()->getName(), call, values, chain)) {
      call.IsTailCall = false;
      return chain;
    }
    callee = dag.getTargetGlobalAddress(global->getGlobal(), loc, MVT::i32, global->getOffset());
  } else if (auto* symbol = dyn_cast<ExternalSymbolSDNode>(callee)) {
    callee = dag.getTargetExternalSymbol(symbol->getSymbol(), MVT::i32);
  }

  SmallVector<CCValAssign, 16> places;
  CCState state(call.CallConv, call.IsVarArg, function, places, *dag.getContext());
  state.AllocateStack(kHomeBytes, Align(4));
  state.AnalyzeCallOperands(call.Outs, places_of(call.CallConv));
  unsigned bytes = static_cast<unsigned>(alignTo(state.getStackSize(), 4));
  call.IsTailCall = may_jump(call, callee, places, function);
  if (!call.IsTailCall)
    chain = dag.getCALLSEQ_START(chain, bytes, 0, loc);

  SmallVector<SDValue, 8> stores;
  SmallVector<std::pair<Register, SDValue>, 4> in_registers;
  SDValue stack;
  for (const auto& [place, value] : zip(places, call.OutVals)) {
    if (place.isRegLoc()) {
      in_registers.emplace_back(place.getLocReg(), value);
      continue;
    }
    if (!stack)
      stack = dag.getCopyFromReg(chain, loc, Bfin::SP, MVT::i32);
    SDValue address = dag.getNode(ISD::ADD, loc, MVT::i32, stack,
                                  dag.getConstant(place.getLocMemOffset(), loc, MVT::i32));
    stores.push_back(dag.getStore(chain, loc, value, address,
                                  MachinePointerInfo::getStack(function, place.getLocMemOffset())));
  }
  if (!stores.empty())
    chain = dag.getNode(ISD::TokenFactor, loc, MVT::Other, stores);

  SDValue glue;
  for (const auto& [reg, value] : in_registers) {
    chain = dag.getCopyToReg(chain, loc, reg, value, glue);
    glue = chain.getValue(1);
  }
  SmallVector<SDValue, 8> operands = {chain, callee};
  for (const auto& [reg, value] : in_registers)
    operands.push_back(dag.getRegister(reg, MVT::i32));
  if (call.IsTailCall) {
    if (glue)
      operands.push_back(glue);
    function.getFrameInfo().setHasTailCall();
    return dag.getNode(BfinISD::TAILCALL, loc, MVT::Other, operands);
  }
  const TargetRegisterInfo* registers = function.getSubtarget().getRegisterInfo();
  operands.push_back(dag.getRegisterMask(registers->getCallPreservedMask(function, call.CallConv)));
  if (glue)
    operands.push_back(glue);
  chain = dag.getNode(BfinISD::CALL, loc, dag.getVTList(MVT::Other, MVT::Glue), operands);
  glue = chain.getValue(1);
  chain = dag.getCALLSEQ_END(chain, bytes, 0, glue, loc);
  glue = chain.getValue(1);

  SmallVector<CCValAssign, 4> results;
  CCState result_state(call.CallConv, call.IsVarArg, function, results, *dag.getContext());
  result_state.AnalyzeCallResult(call.Ins, RetCC_Bfin);
  for (const CCValAssign& place : results) {
    chain = dag.getCopyFromReg(chain, loc, place.getLocReg(), MVT::i32, glue).getValue(1);
    glue = chain.getValue(2);
    values.push_back(chain.getValue(0));
  }
  return chain;
}

bool BfinTargetLowering::CanLowerReturn(CallingConv::ID convention, MachineFunction& function,
                                        bool variadic, const SmallVectorImpl<ISD::OutputArg>& outs,
                                        LLVMContext& context) const {
  SmallVector<CCValAssign, 4> places;
  CCState state(convention, variadic, function, places, context);
  return state.CheckReturn(outs, RetCC_Bfin);
}

SDValue BfinTargetLowering::LowerReturn(SDValue chain, CallingConv::ID convention, bool variadic,
                                        const SmallVectorImpl<ISD::OutputArg>& outs,
                                        const SmallVectorImpl<SDValue>& values, const SDLoc& loc,
                                        SelectionDAG& dag) const {
  MachineFunction& function = dag.getMachineFunction();
  SmallVector<CCValAssign, 4> places;
  CCState state(convention, variadic, function, places, *dag.getContext());
  state.AnalyzeReturn(outs, RetCC_Bfin);
  SDValue glue;
  SmallVector<SDValue, 4> operands = {chain};
  for (const auto& [place, value] : zip(places, values)) {
    chain = dag.getCopyToReg(chain, loc, place.getLocReg(), value, glue);
    glue = chain.getValue(1);
    operands.push_back(dag.getRegister(place.getLocReg(), MVT::i32));
  }
  operands[0] = chain;
  if (glue)
    operands.push_back(glue);
  bool handler = isInterruptHandler(function.getFunction());
  return dag.getNode(handler ? BfinISD::RETI : BfinISD::RET, loc, MVT::Other, operands);
}

}  // namespace llvm
