// The named instructions in selection: see BfinNamedInstructions.hpp.
#pragma once

#include <llvm/CodeGen/SelectionDAGNodes.h>
#include <llvm/CodeGen/TargetLowering.h>

namespace llvm {

/// A call of a function that is an instruction: its results. False when `name` is none.
bool lowerNamedInstruction(StringRef name, TargetLowering::CallLoweringInfo& call,
                           SmallVectorImpl<SDValue>& values, SDValue& chain);
/// A BfinISD::COMPUTE joined with another one that has the same operands; none: nothing to join.
SDValue combineComputation(SDNode* node, TargetLowering::DAGCombinerInfo& info);
/// A saturating sum or difference of shorts, which comes as one of words, shifted up before and
/// down behind it; none: `node` is no such shift.
SDValue combineSaturatedHalves(SDNode* node, SelectionDAG& dag);
/// The machine instruction of a BfinISD::COMPUTE.
SDNode* selectComputation(SDNode* node, SelectionDAG& dag);
/// The machine instruction of a BfinISD::SYSTEM.
SDNode* selectAction(SDNode* node, SelectionDAG& dag);

}  // namespace llvm
