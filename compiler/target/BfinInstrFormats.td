// One format for all: text, size in bytes, and the slot of a packet that the instruction can fill.
class Slot<bits<2> v> {
  bits<2> Value = v;
}
def Alone : Slot<0>;   // never in parallel
def DspSlot : Slot<1>; // slot 0: 32-bit arithmetic
def MemSlot : Slot<2>; // slot 1: a 16-bit load or store through a P register
def IndexSlot : Slot<3>; // slot 1 or 2: one through an I register

class BfinInst<int bytes, dag outs, dag ins, string text, list<dag> pattern = []> : Instruction {
  let Namespace = "Bfin";
  let OutOperandList = outs;
  let InOperandList = ins;
  let AsmString = text;
  let Pattern = pattern;
  let Size = bytes;
  let hasSideEffects = false;
  let mayLoad = false;
  let mayStore = false;

  Slot IssueSlot = Alone;
  bit ReadsEarly = false; // wants its operands in EX1: an ALU result just before costs a stall
  bit ShiftsByNumber = false; // never beside a store of a P register: anomaly 05000074
  let TSFlags{1-0} = IssueSlot.Value;
  let TSFlags{2} = ReadsEarly;
  let TSFlags{3} = ShiftsByNumber;
}

class Pseudo<dag outs, dag ins, list<dag> pattern = []> : BfinInst<4, outs, ins, "", pattern> {
  let isPseudo = true;
  let isCodeGenOnly = true;
}

// A 32-bit DSP operation.
class Dsp<dag outs, dag ins, string text, list<dag> pattern = []>
    : BfinInst<4, outs, ins, text, pattern> {
  let IssueSlot = DspSlot;
}
