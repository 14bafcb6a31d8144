// The Blackfin-like target of Finback: the tables' root. Text output only (BIR), so there is no
// encoding anywhere; what each instruction costs stands in BfinSchedule.td.
include "llvm/Target/Target.td"

include "BfinRegisterInfo.td"
include "BfinSchedule.td"
include "BfinCallingConv.td"
include "BfinInstrInfo.td"

// Every instruction states its own side effects: nothing is guessed from its pattern.
def BfinInstrInfo : InstrInfo {
  let guessInstructionProperties = false;
}

def BfinAsmWriter : AsmWriter {
  string AsmWriterClassName = "InstPrinter";
  bit isMCAsmWriter = true;
}

def Bfin : Target {
  let InstructionSet = BfinInstrInfo;
  let AssemblyWriters = [BfinAsmWriter];
}

def : ProcessorModel<"bf561", BfinModel, []>;
