// What the scheduler knows. Latencies between particular pairs (ALU result to multiplier, data to
// pointer register) are not a property of one instruction: BfinSubtarget::adjustSchedDependency.
def BfinModel : SchedMachineModel {
  let IssueWidth = 1;
  let MicroOpBufferSize = 0;
  let LoadLatency = 1;
  let HighLatency = 3;
  let MispredictPenalty = 8;
  let CompleteModel = false;
}
