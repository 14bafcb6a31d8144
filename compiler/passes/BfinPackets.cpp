// The last order of each block, in packets (PacketDag).
#include <llvm/CodeGen/MachineFunctionPass.h>
#include <llvm/CodeGen/MachineLoopInfo.h>
#include <llvm/InitializePasses.h>

#include "../target/Bfin.hpp"
#include "PacketDag.hpp"

namespace llvm {
namespace {

class BfinPackets : public MachineFunctionPass {
 public:
  static char ID;
  BfinPackets() : MachineFunctionPass(ID) {
    initializeMachineLoopInfoWrapperPassPass(*PassRegistry::getPassRegistry());
  }
  StringRef getPassName() const override { return "Blackfin packets"; }
  void getAnalysisUsage(AnalysisUsage& usage) const override {
    usage.addRequired<AAResultsWrapperPass>();
    usage.addRequired<MachineLoopInfoWrapperPass>();
    usage.setPreservesCFG();
    MachineFunctionPass::getAnalysisUsage(usage);
  }
  bool runOnMachineFunction(MachineFunction& function) override {
    PacketDag dag(function, &getAnalysis<MachineLoopInfoWrapperPass>().getLI(),
                  &getAnalysis<AAResultsWrapperPass>().getAAResults());
    for (MachineBasicBlock& block : function)
      dag.run(block);
    return true;
  }
};

char BfinPackets::ID = 0;

}  // namespace

FunctionPass* createBfinPackets() { return new BfinPackets(); }

}  // namespace llvm
