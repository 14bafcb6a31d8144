// Fractions, pairs of halves, complex numbers, bytes: instructions that C reaches by name
// (BfinNamedInstructions.cpp), and some of them by patterns. An instruction that reads halves is
// written with low ones; getBfinHalves gives its forms with high ones. One that writes a half alone
// ties the other half's old value, which those who select it leave undefined.

class ReadsHalves<string base, string halves> {
  string HalvesBase = base;
  string HalvesRead = halves;
}
def getBfinHalves : InstrMapping {
  let FilterClass = "ReadsHalves";
  let RowFields = ["HalvesBase"];
  let ColFields = ["HalvesRead"];
  let KeyCol = ["LL"];
  let ValueCols = [["LH"], ["HL"], ["HH"]];
}

class DspUnary<string text> : Dsp<(outs D:$rd), (ins D:$ra), text>;
class DspIntoHalf<dag operands, string text> : Dsp<(outs D:$rd), !con((ins D:$old), operands), text> {
  let Constraints = "$old = $rd";
}

//===-- Halves -----------------------------------------------------------------------------------===//
foreach a = ["L", "H"] in {
  foreach b = ["L", "H"] in {
    defvar halves = a#b;
    defvar operands = (ins D:$ra, D:$rb);
    def ADDH_#halves : DspIntoHalf<operands, "${rd}.L = ${ra}."#a#" + ${rb}."#b#" (S)">, ReadsHalves<"ADDH", halves>;
    def SUBH_#halves : DspIntoHalf<operands, "${rd}.L = ${ra}."#a#" - ${rb}."#b#" (S)">, ReadsHalves<"SUBH", halves>;
    def PACK_#halves : DspBinary<"$rd = PACK(${ra}."#a#", ${rb}."#b#")", []>, ReadsHalves<"PACK", halves>;
    let ReadsEarly = true in {
      def MULT_#halves : DspIntoHalf<operands, "${rd}.L = ${ra}."#a#" * ${rb}."#b#" (T)">, ReadsHalves<"MULT", halves>;
      def MULTR_#halves : DspIntoHalf<operands, "${rd}.L = ${ra}."#a#" * ${rb}."#b>, ReadsHalves<"MULTR", halves>;
      def MULTW_#halves : DspBinary<"$rd = ${ra}."#a#" * ${rb}."#b, []>, ReadsHalves<"MULTW", halves>;
    }
  }
  let ReadsEarly = true in {
    def SIGNBITSH_#a#"L" : DspIntoHalf<(ins D:$ra), "${rd}.L = SIGNBITS ${ra}."#a>, ReadsHalves<"SIGNBITSH", a#"L">;
    def EXPADJH_#a#"L" : DspIntoHalf<(ins D:$ra, D:$rb), "${rd}.L = EXPADJ(${ra}."#a#", ${rb}.L)">, ReadsHalves<"EXPADJH", a#"L">;
  }
}
def SUMHL : DspIntoHalf<(ins D:$ra), "${rd}.L = ${ra}.H + ${ra}.L (S)">;
def DIFFHL : DspIntoHalf<(ins D:$ra), "${rd}.L = ${ra}.H - ${ra}.L (S)">;
def DIFFLH : DspIntoHalf<(ins D:$ra), "${rd}.L = ${ra}.L - ${ra}.H (S)">;
def RND : DspIntoHalf<(ins D:$ra), "${rd}.L = $ra (RND)">;
let ReadsEarly = true in {
  def SIGNBITS : DspIntoHalf<(ins D:$ra), "${rd}.L = SIGNBITS $ra">;
  def EXPADJ : DspIntoHalf<(ins D:$ra, D:$rb), "${rd}.L = EXPADJ($ra, ${rb}.L)">;
  def EXPADJV : DspIntoHalf<(ins D:$ra, D:$rb), "${rd}.L = EXPADJ($ra, ${rb}.L) (V)">;
}

//===-- Pairs of halves --------------------------------------------------------------------------===//
let isCommutable = true in {
  def ADDV : DspBinary<"$rd = $ra +\\|+ $rb", []>;
  def ADDVS : DspBinary<"$rd = $ra +\\|+ $rb (S)", []>;
  def MAXV : DspBinary<"$rd = MAX($ra, $rb) (V)", []>;
  def MINV : DspBinary<"$rd = MIN($ra, $rb) (V)", []>;
}
def SUBV : DspBinary<"$rd = $ra -\\|- $rb", []>;
def SUBVS : DspBinary<"$rd = $ra -\\|- $rb (S)", []>;
def ADDSUBV : DspBinary<"$rd = $ra +\\|- $rb", []>;
def ADDSUBVS : DspBinary<"$rd = $ra +\\|- $rb (S)", []>;
def SUBADDV : DspBinary<"$rd = $ra -\\|+ $rb", []>;
def SUBADDVS : DspBinary<"$rd = $ra -\\|+ $rb (S)", []>;
def ABSV : DspUnary<"$rd = ABS $ra (V)">;
def NEGV : DspUnary<"$rd = -$ra (V)">;
let ReadsEarly = true in {
  def ASHIFTVS : DspBinary<"$rd = ASHIFT $ra BY ${rb}.L (V, S)", []>;
  def LSHIFTV : DspBinary<"$rd = LSHIFT $ra BY ${rb}.L (V)", []>;
}
class DspShift<string text> : Dsp<(outs D:$rd), (ins D:$ra, i32imm:$n), text> {
  let ShiftsByNumber = true;
}
def SHLVS : DspShift<"$rd = $ra << $n (V, S)">;
def SHLV : DspShift<"$rd = $ra << $n (V)">;
def SRAV : DspShift<"$rd = $ra >>> $n (V)">;
def SRLV : DspShift<"$rd = $ra >> $n (V)">;

foreach mode = ["", "T", "IS", "FU"] in {
  defvar option = !if(!empty(mode), "", " ("#mode#")");
  let ReadsEarly = true in
  def MULV#mode : DspBinary<"${rd}.H = ${ra}.H * ${rb}.H, ${rd}.L = ${ra}.L * ${rb}.L"#option, []>;
}

// Two results, of both lanes each. CO exchanges the second one's halves, ASR halves all.
class DspTwice<string first, string second, string option>
    : Dsp<(outs D:$rd, D:$re), (ins D:$ra, D:$rb), "$rd = $ra "#first#" $rb, $re = $ra "#second#" $rb"#option>;
foreach mode = ["", "S", "ASR", "CO_ASR"] in {
  defvar option = !if(!empty(mode), "", " ("#!subst("_", ", ", mode)#")");
  def BOTHV#mode : DspTwice<"+\\|+", "-\\|-", option>;
  def BOTHX#mode : DspTwice<"+\\|-", "-\\|+", option>;
}
def BOTHW : DspTwice<"+", "-", " (S)">;

//===-- Words ------------------------------------------------------------------------------------===//
let isCommutable = true in
def ADDS : DspBinary<"$rd = $ra + $rb (S)", [(set D:$rd, (saddsat D:$ra, D:$rb))]>;
def SUBS : DspBinary<"$rd = $ra - $rb (S)", [(set D:$rd, (ssubsat D:$ra, D:$rb))]>;
def ABSS : DspUnary<"$rd = ABS $ra">;
def NEGS : DspUnary<"$rd = -$ra (S)">;
let ReadsEarly = true in {
  def ASHIFTS : DspBinary<"$rd = ASHIFT $ra BY ${rb}.L (S)", []>;
  def LSHIFT : DspBinary<"$rd = LSHIFT $ra BY ${rb}.L", []>;
}
def SHLS : DspShift<"$rd = $ra << $n (S)">;

// An addition whose carry runs to the right.
let Constraints = "$ra = $rd" in
def ADDREVERSED : BfinInst<2, (outs P:$rd), (ins P:$ra, P:$rb), "$rd += $rb (BREV)">;

//===-- Bytes ------------------------------------------------------------------------------------===//
let ReadsEarly = true in {
  foreach n = [8, 16, 24] in
  def ALIGN#n : DspBinary<"$rd = ALIGN"#n#"($ra, $rb)", []>;
  def BYTEPACK : DspBinary<"$rd = BYTEPACK($ra, $rb)", []>;
}

// Four bytes of each of two pairs of words, R1:0 and R3:2, beginning where the low bits of I0 and I1
// say; (R) exchanges the words.
class BytesOfPairs<dag results, string text> : Dsp<results, (ins), text> {
  let Uses = [R0, R1, R2, R3, I0, I1];
  let ReadsEarly = true;
}
foreach reverse = ["", "R"] in {
  defvar more = !if(!empty(reverse), "", ", R");
  defvar only = !if(!empty(reverse), "", " (R)");
  def AVERAGE#reverse : BytesOfPairs<(outs D:$rd), "$rd = BYTEOP1P(R1:0, R3:2)"#only>;
  def AVERAGET#reverse : BytesOfPairs<(outs D:$rd), "$rd = BYTEOP1P(R1:0, R3:2) (T"#more#")">;
  let Uses = [R0, R1, R2, R3, I0] in
  foreach mode = ["RNDL", "RNDH", "TL", "TH"] in
  def AVERAGE4#mode#reverse : BytesOfPairs<(outs D:$rd), "$rd = BYTEOP2P(R1:0, R3:2) ("#mode#more#")">;
  foreach mode = ["LO", "HI"] in
  def ADDCLIP#mode#reverse : BytesOfPairs<(outs D:$rd), "$rd = BYTEOP3P(R1:0, R3:2) ("#mode#more#")">;
  def BYTESUMS#reverse : BytesOfPairs<(outs D:$rd, D:$re), "($rd, $re) = BYTEOP16P(R1:0, R3:2)"#only>;
  def BYTEDIFFS#reverse : BytesOfPairs<(outs D:$rd, D:$re), "($rd, $re) = BYTEOP16M(R1:0, R3:2)"#only>;
  let Uses = [R0, R1, I0] in
  def UNPACK#reverse : BytesOfPairs<(outs D:$rd, D:$re), "($rd, $re) = BYTEUNPACK R1:0"#only>;
}

//===-- In the accumulators ------------------------------------------------------------------------===//
// Complex products: A1 takes the imaginary part, A0 the real one, each with two products.
let ReadsEarly = true in {
  let Defs = [A0, A1] in {
    def CSET : Dsp<(outs), (ins D:$ra, D:$rb), "A1 = ${ra}.L * ${rb}.H, A0 = ${ra}.L * ${rb}.L">;
    def CSETW : Dsp<(outs), (ins D:$ra, D:$rb), "A1 = ${ra}.L * ${rb}.H, A0 = ${ra}.L * ${rb}.L (W32)">;
    let Uses = [A0, A1] in {
      def CADD : Dsp<(outs), (ins D:$ra, D:$rb), "A1 += ${ra}.L * ${rb}.H, A0 += ${ra}.L * ${rb}.L">;
      def CADDW : Dsp<(outs), (ins D:$ra, D:$rb), "A1 += ${ra}.L * ${rb}.H, A0 += ${ra}.L * ${rb}.L (W32)">;
      def CSUB : Dsp<(outs), (ins D:$ra, D:$rb), "A1 -= ${ra}.L * ${rb}.H, A0 -= ${ra}.L * ${rb}.L">;
      def CSUBW : Dsp<(outs), (ins D:$ra, D:$rb), "A1 -= ${ra}.L * ${rb}.H, A0 -= ${ra}.L * ${rb}.L (W32)">;
      def CGET : DspBinary<"${rd}.H = (A1 += ${ra}.H * ${rb}.L), ${rd}.L = (A0 -= ${ra}.H * ${rb}.H)", []>;
      def CGETS : DspBinary<"${rd}.H = (A1 -= ${ra}.H * ${rb}.L), ${rd}.L = (A0 += ${ra}.H * ${rb}.H)", []>;
    }
  }
  // 32 by 32 bits: A1 collects all but the product of the high halves, which is A0's.
  let Defs = [A1] in {
    def LOWS : Dsp<(outs), (ins D:$ra, D:$rb), "A1 = ${ra}.L * ${rb}.L (FU)">;
    let Uses = [A1] in {
      def LOWSADD : Dsp<(outs), (ins D:$ra, D:$rb), "A1 += ${ra}.L * ${rb}.L (FU)">;
      def CROSS : Dsp<(outs), (ins D:$ra, D:$rb), "A1 += ${ra}.H * ${rb}.L (M)">;
    }
  }
  let Defs = [A0, A1], Uses = [A1] in
  def CROSSHIGHS : Dsp<(outs), (ins D:$ra, D:$rb), "A1 += ${ra}.H * ${rb}.L (M), A0 = ${ra}.H * ${rb}.H">;
}
let Defs = [A1], Uses = [A1] in {
  def A1DOWN16 : Dsp<(outs), (ins), "A1 = A1 >> 16">;
  def A1DOWN15 : Dsp<(outs), (ins), "A1 = A1 >>> 15">;
}
let Defs = [A0], Uses = [A0, A1] in
def SUMOFBOTH : Dsp<(outs D:$rd), (ins), "$rd = (A0 += A1)">;
// A0 has the history of choices; its low word is all of it that counts.
let Defs = [A0], Uses = [A0] in
def SETLOWA0 : BfinInst<2, (outs), (ins D:$ra), "A0.W = $ra">;
let Defs = [A0], Uses = [A0], ReadsEarly = true in
foreach side = ["ASL", "ASR"] in {
  def VITMAXH#side : DspIntoHalf<(ins D:$ra), "${rd}.L = VIT_MAX($ra) ("#side#")">;
  def VITMAXV#side : DspBinary<"$rd = VIT_MAX($ra, $rb) ("#side#")", []>;
}

// Whole sequences until allocation is done, so that nothing gets between their parts; then
// BfinInstrInfo::expandPostRAPseudo writes them out.
class Sequence<dag outs, dag ins, int parts> : Pseudo<outs, ins> {
  let Size = !mul(4, parts);
  let IssueSlot = DspSlot;
  let Defs = [A0, A1];
}
foreach wide = ["", "W"] in {
  def CMUL#wide : Sequence<(outs D:$rd), (ins D:$ra, D:$rb), 2>;
  def CMAC#wide : Sequence<(outs D:$rd), (ins D:$im, D:$re, D:$ra, D:$rb), 4>;
  def CMSU#wide : Sequence<(outs D:$rd), (ins D:$im, D:$re, D:$ra, D:$rb), 4>;
}
def MUL32 : Sequence<(outs D:$rd), (ins D:$ra, D:$rb), 6>;
def MUL32R : Sequence<(outs D:$rd), (ins D:$half, D:$ra, D:$rb), 7>;
foreach side = ["ASL", "ASR"] in {
  def VITH#side : Sequence<(outs D:$rd, D:$history), (ins D:$ra, D:$old), 4>;
  def VITV#side : Sequence<(outs D:$rd, D:$history), (ins D:$ra, D:$rb, D:$old), 4>;
}

//===-- Patterns -----------------------------------------------------------------------------------===//
def low_half : PatLeaf<(i32 D:$a), [{
  return CurDAG->MaskedValueIsZero(SDValue(N, 0), APInt::getHighBitsSet(32, 16));
}]>;
let AddedComplexity = 20 in {
  def : Pat<(or (shl D:$a, (i32 16)), (and D:$b, 65535)), (PACK_LL D:$a, D:$b)>;
  def : Pat<(or (shl D:$a, (i32 16)), (srl D:$b, (i32 16))), (PACK_LH D:$a, D:$b)>;
  def : Pat<(or (and D:$a, 0xffff0000), (and D:$b, 65535)), (PACK_HL D:$a, D:$b)>;
  def : Pat<(or (and D:$a, 0xffff0000), (srl D:$b, (i32 16))), (PACK_HH D:$a, D:$b)>;
}
let AddedComplexity = 15 in
def : Pat<(or (shl D:$a, (i32 16)), low_half:$b), (PACK_LL D:$a, D:$b)>;
