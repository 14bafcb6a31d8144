include "BfinInstrFormats.td"

//===-- Nodes ------------------------------------------------------------------------------------===//
def SDT_Call : SDTypeProfile<0, -1, [SDTCisVT<0, i32>]>;
def SDT_CallSeqStart : SDCallSeqStart<[SDTCisVT<0, i32>, SDTCisVT<1, i32>]>;
def SDT_CallSeqEnd : SDCallSeqEnd<[SDTCisVT<0, i32>, SDTCisVT<1, i32>]>;
def SDT_Compare : SDTypeProfile<0, 3, [SDTCisVT<0, i32>, SDTCisVT<1, i32>, SDTCisVT<2, i32>]>;
def SDT_BitTest : SDTypeProfile<0, 2, [SDTCisVT<0, i32>, SDTCisVT<1, i32>]>;
def SDT_Branch : SDTypeProfile<0, 2, [SDTCisVT<0, OtherVT>, SDTCisVT<1, i32>]>;
def SDT_Select : SDTypeProfile<1, 3, [SDTCisVT<0, i32>, SDTCisVT<1, i32>, SDTCisVT<2, i32>, SDTCisVT<3, i32>]>;
def SDT_FromCC : SDTypeProfile<1, 0, [SDTCisVT<0, i32>]>;
def SDT_Unary : SDTypeProfile<1, 1, [SDTCisVT<0, i32>, SDTCisVT<1, i32>]>;
def SDT_Binary : SDTypeProfile<1, 2, [SDTCisVT<0, i32>, SDTCisVT<1, i32>, SDTCisVT<2, i32>]>;
def SDT_RotateCC : SDTypeProfile<1, 1, [SDTCisVT<0, i32>, SDTCisVT<1, i32>]>;
def SDT_Result : SDTypeProfile<1, 0, [SDTCisVT<0, i32>]>;
def SDT_Operand : SDTypeProfile<0, 1, [SDTCisVT<0, i32>]>;

def bfin_call : SDNode<"BfinISD::CALL", SDT_Call, [SDNPHasChain, SDNPOptInGlue, SDNPOutGlue, SDNPVariadic]>;
def bfin_tailcall : SDNode<"BfinISD::TAILCALL", SDT_Call, [SDNPHasChain, SDNPOptInGlue, SDNPVariadic]>;
def bfin_ret : SDNode<"BfinISD::RET", SDTNone, [SDNPHasChain, SDNPOptInGlue, SDNPVariadic]>;
def bfin_reti : SDNode<"BfinISD::RETI", SDTNone, [SDNPHasChain, SDNPOptInGlue, SDNPVariadic]>;
def bfin_symbol : SDNode<"BfinISD::SYMBOL", SDT_Unary>;
def bfin_cmp : SDNode<"BfinISD::CMP", SDT_Compare, [SDNPOutGlue]>;
def bfin_bittst : SDNode<"BfinISD::BITTST", SDT_BitTest, [SDNPOutGlue]>;
def bfin_jcc : SDNode<"BfinISD::JCC", SDT_Branch, [SDNPHasChain, SDNPInGlue]>;
def bfin_select : SDNode<"BfinISD::SELECT", SDT_Select, [SDNPInGlue]>;
def bfin_fromcc : SDNode<"BfinISD::FROMCC", SDT_FromCC, [SDNPInGlue]>;
def bfin_rotcc : SDNode<"BfinISD::ROTCC", SDT_RotateCC, [SDNPInGlue]>;
def bfin_notcc : SDNode<"BfinISD::NOTCC", SDTNone, [SDNPInGlue, SDNPOutGlue]>;
def bfin_mulu16 : SDNode<"BfinISD::MULU16", SDT_Binary, [SDNPCommutative]>;
def bfin_mulu16hl : SDNode<"BfinISD::MULU16HL", SDT_Binary>;
def bfin_mulu16hh : SDNode<"BfinISD::MULU16HH", SDT_Binary, [SDNPCommutative]>;
def bfin_mullow : SDNode<"BfinISD::MULLOW", SDT_Binary, [SDNPCommutative]>;
def bfin_sum : SDNode<"BfinISD::SUM", SDT_Binary, [SDNPCommutative]>;
def bfin_sumfits : SDNode<"BfinISD::SUMFITS", SDT_Binary, [SDNPCommutative]>;
def bfin_atleasttwo : SDNode<"BfinISD::ATLEASTTWO", SDT_Unary>;
def bfin_setlo : SDNode<"BfinISD::SETLO", SDT_Binary>;
def bfin_sethi : SDNode<"BfinISD::SETHI", SDT_Binary>;
// Ordered with memory, as all that acts on the system is; the others are selected by BfinISD::SYSTEM.
def bfin_testset : SDNode<"BfinISD::TESTSET", SDT_Operand, [SDNPHasChain, SDNPMayLoad, SDNPMayStore, SDNPSideEffect, SDNPOutGlue]>;

def callseq_start : SDNode<"ISD::CALLSEQ_START", SDT_CallSeqStart, [SDNPHasChain, SDNPOutGlue]>;
def callseq_end : SDNode<"ISD::CALLSEQ_END", SDT_CallSeqEnd, [SDNPHasChain, SDNPOptInGlue, SDNPOutGlue]>;

//===-- Operands ---------------------------------------------------------------------------------===//
def Mem : Operand<i32> {
  let MIOperandInfo = (ops P:$base, i32imm:$displacement);
  let PrintMethod = "printMem";
}
def AddrW : ComplexPattern<iPTR, 2, "selectAddr<4>", [frameindex, add, or]>;
def AddrH : ComplexPattern<iPTR, 2, "selectAddr<2>", [frameindex, add, or]>;
def AddrB : ComplexPattern<iPTR, 2, "selectAddr<1>", [frameindex, add, or]>;

def Target : Operand<OtherVT>;
def Callee : Operand<i32>;
def Half : Operand<i32> { let PrintMethod = "printHalf"; }
def PushD : Operand<i32> { let PrintMethod = "printRegList"; }
def SystemRegister : Operand<i32> { let PrintMethod = "printSystemRegister"; }

def simm7 : ImmLeaf<i32, [{ return isInt<7>(Imm); }]>;
def simm16 : ImmLeaf<i32, [{ return isInt<16>(Imm); }]>;
def uimm16 : ImmLeaf<i32, [{ return isUInt<16>(Imm); }]>;
def uimm5 : ImmLeaf<i32, [{ return isUInt<5>(Imm); }]>;
def uimm4 : ImmLeaf<i32, [{ return isUInt<4>(Imm); }]>;
def one_or_two : ImmLeaf<i32, [{ return Imm == 1 || Imm == 2; }]>;
def one_bit : ImmLeaf<i32, [{ return isPowerOf2_32(static_cast<uint32_t>(Imm)); }]>;
def all_but_one_bit : ImmLeaf<i32, [{ return isPowerOf2_32(~static_cast<uint32_t>(Imm)); }]>;
def bit_number : SDNodeXForm<imm, [{
  return CurDAG->getTargetConstant(Log2_32(static_cast<uint32_t>(N->getZExtValue())), SDLoc(N), MVT::i32);
}]>;
def clear_bit_number : SDNodeXForm<imm, [{
  return CurDAG->getTargetConstant(Log2_32(~static_cast<uint32_t>(N->getZExtValue())), SDLoc(N), MVT::i32);
}]>;
def imm_any : ImmLeaf<i32, [{ return true; }]>;

// A factor that fits a half: a register and which half of it, 1 the high one. A product of two such
// takes one cycle instead of three.
def HalfOf : Operand<i32> {
  let MIOperandInfo = (ops D:$reg, i32imm:$half);
  let PrintMethod = "printHalfOf";
}
def SignedHalf : ComplexPattern<i32, 2, "selectSignedHalf">;
def UnsignedHalf : ComplexPattern<i32, 2, "selectUnsignedHalf">;

//===-- Constants and moves ------------------------------------------------------------------------===//
let isReMaterializable = true, isAsCheapAsAMove = true, isMoveImm = true in {
  def MOVI : BfinInst<4, (outs DP:$rd), (ins i32imm:$v), "$rd = $v (X)", [(set DP:$rd, simm16:$v)]>;
  def MOVU : BfinInst<4, (outs DP:$rd), (ins i32imm:$v), "$rd = $v (Z)", [(set DP:$rd, uimm16:$v)]>;
}
let isReMaterializable = true, Size = 8 in {
  def LI32 : Pseudo<(outs DP:$rd), (ins i32imm:$v), [(set DP:$rd, imm_any:$v)]>;
  def LDSYM : Pseudo<(outs DP:$rd), (ins i32imm:$symbol)>;
}
def : Pat<(bfin_symbol tglobaladdr:$s), (LDSYM tglobaladdr:$s)>;
def : Pat<(bfin_symbol texternalsym:$s), (LDSYM texternalsym:$s)>;
def : Pat<(bfin_symbol tjumptable:$s), (LDSYM tjumptable:$s)>;
def : Pat<(bfin_symbol tconstpool:$s), (LDSYM tconstpool:$s)>;
def : Pat<(bfin_symbol tblockaddress:$s), (LDSYM tblockaddress:$s)>;
def LO16 : BfinInst<4, (outs DP:$rd), (ins Half:$v), "${rd}.L = $v">;
let Constraints = "$old = $rd" in
def HI16 : BfinInst<4, (outs DP:$rd), (ins DP:$old, Half:$v), "${rd}.H = $v">;

def MOV : BfinInst<2, (outs ANY:$rd), (ins ANY:$rs), "$rd = $rs">;

// The address of a frame object; its displacement is known only once the frame is laid out.
def LEA : Pseudo<(outs P:$rd), (ins P:$base, i32imm:$displacement)>;

//===-- Loads and stores ---------------------------------------------------------------------------===//
let mayLoad = true, IssueSlot = MemSlot in {
  def LDW : BfinInst<2, (outs DP:$rd), (ins Mem:$m), "$rd = [$m]", [(set DP:$rd, (load AddrW:$m))]>;
  def LDHZ : BfinInst<2, (outs D:$rd), (ins Mem:$m), "$rd = W[$m] (Z)", [(set D:$rd, (zextloadi16 AddrH:$m))]>;
  def LDHX : BfinInst<2, (outs D:$rd), (ins Mem:$m), "$rd = W[$m] (X)", [(set D:$rd, (sextloadi16 AddrH:$m))]>;
  def LDBZ : BfinInst<2, (outs D:$rd), (ins Mem:$m), "$rd = B[$m] (Z)", [(set D:$rd, (zextloadi8 AddrB:$m))]>;
  def LDBX : BfinInst<2, (outs D:$rd), (ins Mem:$m), "$rd = B[$m] (X)", [(set D:$rd, (sextloadi8 AddrB:$m))]>;
  class LoadStep<RegisterClass rc, string access, string step, string extension>
      : BfinInst<2, (outs rc:$rd, P:$next), (ins P:$base), "$rd = "#access#"[$base"#step#"]"#extension> {
    let Constraints = "$base = $next";
  }
  foreach step = ["Inc", "Dec"] in {
    defvar sign = !if(!eq(step, "Inc"), "++", "--");
    def LDW#step : LoadStep<DP, "", sign, "">;
    def LDHZ#step : LoadStep<D, "W", sign, " (Z)">;
    def LDHX#step : LoadStep<D, "W", sign, " (X)">;
    def LDBZ#step : LoadStep<D, "B", sign, " (Z)">;
    def LDBX#step : LoadStep<D, "B", sign, " (X)">;
  }
}
// Steps by a register, and loads into one half, which have no other step (BfinStrides).
let mayLoad = true, IssueSlot = MemSlot in {
  class LoadStride<string access, string extension>
      : BfinInst<2, (outs D:$rd, P:$next), (ins P:$base, P:$by), "$rd = "#access#"[$base ++ $by]"#extension> {
    let Constraints = "$base = $next";
  }
  def LDWStride : LoadStride<"", "">;
  def LDHZStride : LoadStride<"W", " (Z)">;
  def LDHXStride : LoadStride<"W", " (X)">;
  foreach half = ["LO", "HI"] in
  let Constraints = "$base = $next, $old = $rd" in
  def LD#half#Stride : BfinInst<2, (outs D:$rd, P:$next), (ins P:$base, P:$by, D:$old),
                                "${rd}."#!if(!eq(half, "LO"), "L", "H")#" = W[$base ++ $by]">;
}
def : Pat<(extloadi16 AddrH:$m), (LDHZ Mem:$m)>;
def : Pat<(extloadi8 AddrB:$m), (LDBZ Mem:$m)>;

let mayStore = true, IssueSlot = MemSlot in {
  def STW : BfinInst<2, (outs), (ins DP:$rs, Mem:$m), "[$m] = $rs", [(store DP:$rs, AddrW:$m)]>;
  def STH : BfinInst<2, (outs), (ins D:$rs, Mem:$m), "W[$m] = $rs", [(truncstorei16 D:$rs, AddrH:$m)]>;
  def STB : BfinInst<2, (outs), (ins D:$rs, Mem:$m), "B[$m] = $rs", [(truncstorei8 D:$rs, AddrB:$m)]>;
  class StoreStep<RegisterClass rc, string access, string step>
      : BfinInst<2, (outs P:$next), (ins rc:$rs, P:$base), access#"[$base"#step#"] = $rs"> {
    let Constraints = "$base = $next";
  }
  foreach step = ["Inc", "Dec"] in {
    defvar sign = !if(!eq(step, "Inc"), "++", "--");
    def STW#step : StoreStep<DP, "", sign>;
    def STH#step : StoreStep<D, "W", sign>;
    def STB#step : StoreStep<D, "B", sign>;
  }
}

// Through an I register, which may stand beside another access in a packet (BfinIndexStreams). Halves
// are not extended: the high half of the register stays.
def IndexMem : Operand<i32> {
  let MIOperandInfo = (ops IR:$base, i32imm:$displacement);  // the displacement is 0
  let PrintMethod = "printMem";
}
let mayLoad = true, IssueSlot = IndexSlot in {
  def LDWI : BfinInst<2, (outs D:$rd), (ins IndexMem:$m), "$rd = [$m]">;
  let Constraints = "$old = $rd" in
  def LDLI : BfinInst<2, (outs D:$rd), (ins IndexMem:$m, D:$old), "${rd}.L = W[$m]">;
  foreach step = ["Inc", "Dec"] in {
    defvar sign = !if(!eq(step, "Inc"), "++", "--");
    let Constraints = "$base = $next" in
    def LDWI#step : BfinInst<2, (outs D:$rd, IR:$next), (ins IR:$base), "$rd = [$base"#sign#"]">;
    let Constraints = "$base = $next, $old = $rd" in
    def LDLI#step
        : BfinInst<2, (outs D:$rd, IR:$next), (ins IR:$base, D:$old), "${rd}.L = W[$base"#sign#"]">;
  }
}
let mayStore = true, IssueSlot = IndexSlot in {
  def STWI : BfinInst<2, (outs), (ins D:$rs, IndexMem:$m), "[$m] = $rs">;
  def STHI : BfinInst<2, (outs), (ins D:$rs, IndexMem:$m), "W[$m] = ${rs}.L">;
  foreach step = ["Inc", "Dec"] in {
    defvar sign = !if(!eq(step, "Inc"), "++", "--");
    let Constraints = "$base = $next" in {
      def STWI#step : BfinInst<2, (outs IR:$next), (ins D:$rs, IR:$base), "[$base"#sign#"] = $rs">;
      def STHI#step : BfinInst<2, (outs IR:$next), (ins D:$rs, IR:$base), "W[$base"#sign#"] = ${rs}.L">;
    }
  }
}
// Holds the first slot of a packet of two accesses.
def MNOP : Dsp<(outs), (ins), "MNOP">;

// A count of passes of which the middle end knows that there are two or more (BfinHardwareLoops).
def ATLEASTTWO : Pseudo<(outs DP:$rd), (ins DP:$rs), [(set DP:$rd, (bfin_atleasttwo DP:$rs))]>;

//===-- Arithmetic ---------------------------------------------------------------------------------===//
// Operations that exist in both banks are selected as ..._X; the bank pass picks one of the two.
multiclass BothBanks<string text, SDNode node> {
  def _X : Pseudo<(outs DP:$rd), (ins DP:$ra, DP:$rb), [(set DP:$rd, (node DP:$ra, DP:$rb))]>;
  def "" : BfinInst<2, (outs D:$rd), (ins D:$ra, D:$rb), text>;
}
let isCommutable = true in {
  defm ADD : BothBanks<"$rd = $ra + $rb", add>;
  def ADDP : BfinInst<2, (outs P:$rd), (ins P:$ra, P:$rb), "$rd = $ra + $rb">;
}
defm SUB : BothBanks<"$rd = $ra - $rb", sub>;
let Constraints = "$ra = $rd" in
def SUBP : BfinInst<2, (outs P:$rd), (ins P:$ra, P:$rb), "$rd -= $rb">;
let Constraints = "$ra = $rd", AddedComplexity = 5 in
def ADDI : BfinInst<2, (outs DP:$rd), (ins DP:$ra, i32imm:$v), "$rd += $v",
                    [(set DP:$rd, (add DP:$ra, simm7:$v))]>;

def SHL_X : Pseudo<(outs DP:$rd), (ins DP:$ra, i32imm:$n), [(set DP:$rd, (shl DP:$ra, one_or_two:$n))]>;
def SRL_X : Pseudo<(outs DP:$rd), (ins DP:$ra, i32imm:$n), [(set DP:$rd, (srl DP:$ra, one_or_two:$n))]>;
def SHLP : BfinInst<2, (outs P:$rd), (ins P:$ra, i32imm:$n), "$rd = $ra << $n">;
def SRLP : BfinInst<2, (outs P:$rd), (ins P:$ra, i32imm:$n), "$rd = $ra >> $n">;
def ADDSHLP : BfinInst<2, (outs P:$rd), (ins P:$ra, P:$rb, i32imm:$n), "$rd = $ra + ($rb << $n)">;

class Alu<string text, SDNode node>
    : BfinInst<2, (outs D:$rd), (ins D:$ra, D:$rb), text, [(set D:$rd, (node D:$ra, D:$rb))]>;
let isCommutable = true in {
  def AND : Alu<"$rd = $ra & $rb", and>;
  def OR : Alu<"$rd = $ra | $rb", or>;
  def XOR : Alu<"$rd = $ra ^ $rb", xor>;
}
class AluUnary<string text, list<dag> pattern>
    : BfinInst<2, (outs D:$rd), (ins D:$ra), text, pattern>;
def NEG : AluUnary<"$rd = -$ra", [(set D:$rd, (ineg D:$ra))]>;
def NOT : AluUnary<"$rd = ~$ra", [(set D:$rd, (not D:$ra))]>;
let AddedComplexity = 10 in {
  def ZXB : AluUnary<"$rd = ${ra}.B (Z)", [(set D:$rd, (and D:$ra, 255))]>;
  def ZXH : AluUnary<"$rd = ${ra}.L (Z)", [(set D:$rd, (and D:$ra, 65535))]>;
}
def SXB : AluUnary<"$rd = ${ra}.B (X)", [(set D:$rd, (sext_inreg D:$ra, i8))]>;
def SXH : AluUnary<"$rd = ${ra}.L (X)", [(set D:$rd, (sext_inreg D:$ra, i16))]>;

let Constraints = "$ra = $rd" in {
  let ReadsEarly = true, isCommutable = true in
  def MUL : BfinInst<2, (outs D:$rd), (ins D:$ra, D:$rb), "$rd *= $rb", [(set D:$rd, (mul D:$ra, D:$rb))]>;
  class ShiftByRegister<string text, SDNode node>
      : BfinInst<2, (outs D:$rd), (ins D:$ra, D:$rb), text, [(set D:$rd, (node D:$ra, D:$rb))]>;
  def SHLR : ShiftByRegister<"$rd <<= $rb", shl>;
  def SRLR : ShiftByRegister<"$rd >>= $rb", srl>;
  def SRAR : ShiftByRegister<"$rd >>>= $rb", sra>;
  let AddedComplexity = 8 in {
    def BITSET : BfinInst<2, (outs D:$rd), (ins D:$ra, i32imm:$n), "BITSET($rd, $n)">;
    def BITCLR : BfinInst<2, (outs D:$rd), (ins D:$ra, i32imm:$n), "BITCLR($rd, $n)">;
    def BITTGL : BfinInst<2, (outs D:$rd), (ins D:$ra, i32imm:$n), "BITTGL($rd, $n)">;
  }
}
let AddedComplexity = 8 in {
  def : Pat<(or D:$ra, one_bit:$n), (BITSET D:$ra, (bit_number $n))>;
  def : Pat<(and D:$ra, all_but_one_bit:$n), (BITCLR D:$ra, (clear_bit_number $n))>;
  def : Pat<(xor D:$ra, one_bit:$n), (BITTGL D:$ra, (bit_number $n))>;
}

class ShiftByNumber<string sign, SDNode node>
    : Dsp<(outs D:$rd), (ins D:$ra, i32imm:$n), "$rd = $ra "#sign#" $n", [(set D:$rd, (node D:$ra, uimm5:$n))]> {
  let ShiftsByNumber = true;
}
def SHLI : ShiftByNumber<"<<", shl>;
def SRLI : ShiftByNumber<">>", srl>;
def SRAI : ShiftByNumber<">>>", sra>;
// The two-byte forms, once source and destination have turned out to be one register.
let Constraints = "$ra = $rd" in {
  def SHLI2 : BfinInst<2, (outs D:$rd), (ins D:$ra, i32imm:$n), "$rd <<= $n">;
  def SRLI2 : BfinInst<2, (outs D:$rd), (ins D:$ra, i32imm:$n), "$rd >>= $n">;
  def SRAI2 : BfinInst<2, (outs D:$rd), (ins D:$ra, i32imm:$n), "$rd >>>= $n">;
}

class DspBinary<string text, list<dag> pattern> : Dsp<(outs D:$rd), (ins D:$ra, D:$rb), text, pattern>;
let isCommutable = true in {
  def ADDNS : DspBinary<"$rd = $ra + $rb (NS)", []>;
  def SMAX : DspBinary<"$rd = MAX($ra, $rb)", [(set D:$rd, (smax D:$ra, D:$rb))]>;
  def SMIN : DspBinary<"$rd = MIN($ra, $rb)", [(set D:$rd, (smin D:$ra, D:$rb))]>;
}
let ReadsEarly = true in {
  let AddedComplexity = 12 in
  def MULIS : Dsp<(outs D:$rd), (ins HalfOf:$ra, HalfOf:$rb), "$rd = $ra * $rb (IS)",
                  [(set D:$rd, (mul SignedHalf:$ra, SignedHalf:$rb))]>;
  let AddedComplexity = 11 in
  def MULFU : Dsp<(outs D:$rd), (ins HalfOf:$ra, HalfOf:$rb), "$rd = $ra * $rb (FU)",
                  [(set D:$rd, (mul UnsignedHalf:$ra, UnsignedHalf:$rb))]>;
}
def : Pat<(bfin_mullow D:$ra, D:$rb), (MULIS D:$ra, 0, D:$rb, 0)>;
def : Pat<(bfin_mulu16 D:$ra, D:$rb), (MULFU D:$ra, 0, D:$rb, 0)>;
def : Pat<(bfin_mulu16hl D:$ra, D:$rb), (MULFU D:$ra, 1, D:$rb, 0)>;
def : Pat<(bfin_mulu16hh D:$ra, D:$rb), (MULFU D:$ra, 1, D:$rb, 1)>;
def ABS : Dsp<(outs D:$rd), (ins D:$ra), "$rd = ABS $ra", [(set D:$rd, (abs D:$ra))]>;
def SUBNS : DspBinary<"$rd = $ra - $rb (NS)", []>;
// The count lands in the low half; the high half keeps what it held.
let Constraints = "$old = $rd", ReadsEarly = true in {
  def ONES : Dsp<(outs D:$rd), (ins D:$old, D:$ra), "${rd}.L = ONES $ra">;
}
def : Pat<(ctpop D:$ra), (ONES (MOVI 0), D:$ra)>;

// One half of a word anew.
def PACKLO : DspBinary<"$rd = PACK(${ra}.H, ${rb}.L)", [(set D:$rd, (bfin_setlo D:$ra, D:$rb))]>;
def PACKHI : DspBinary<"$rd = PACK(${rb}.L, ${ra}.L)", [(set D:$rd, (bfin_sethi D:$ra, D:$rb))]>;

// Sums modulo 2^32 whose exact values, summed up over a loop, are known to fit 40 bits, or 32.
def SUM_X : Pseudo<(outs DP:$rd), (ins DP:$ra, DP:$rb), [(set DP:$rd, (bfin_sum DP:$ra, DP:$rb))]>;
def SUMFITS_X : Pseudo<(outs DP:$rd), (ins DP:$ra, DP:$rb), [(set DP:$rd, (bfin_sumfits DP:$ra, DP:$rb))]>;

// Sums of products in the accumulators (BfinAccumulators). The first operand of each product says
// whether it is added (0), taken off (1), or all that the sum is so far (2). Results: the low word, or a sum that is known to fit.
def AddOrTake : Operand<i32> { let PrintMethod = "printAddOrTake"; }
foreach i = 0-1 in {
  defvar accumulator = !cast<Register>("A"#i);
  let Defs = [accumulator] in {
    def CLRA#i : Dsp<(outs), (ins), "A"#i#" = 0">;
    def SETA#i : Dsp<(outs), (ins D:$ra), "A"#i#" = $ra">;
  }
  let Defs = [accumulator], Uses = [accumulator], ReadsEarly = true in {
    def MAC#i : Dsp<(outs), (ins AddOrTake:$op, HalfOf:$ra, HalfOf:$rb), "A"#i#" $op $ra * $rb (IS)">;
    def MACGET#i : Dsp<(outs !cast<RegisterClass>(!if(i, "DOdd", "DEven")):$rd),
                       (ins AddOrTake:$op, HalfOf:$ra, HalfOf:$rb), "$rd = (A"#i#" $op $ra * $rb) (IS)">;
  }
  let Uses = [accumulator] in
  def GETA#i : BfinInst<2, (outs D:$rd), (ins), "$rd = A"#i#".W">;
}
let Defs = [A0, A1] in {
  def CLRAA : Dsp<(outs), (ins), "A1 = A0 = 0">;
  // Both products are of the same two registers.
  let Uses = [A0, A1], ReadsEarly = true in
  def MACMAC : Dsp<(outs), (ins AddOrTake:$op1, HalfOf:$ra1, HalfOf:$rb1, AddOrTake:$op0, HalfOf:$ra0, HalfOf:$rb0),
                   "A1 $op1 $ra1 * $rb1, A0 $op0 $ra0 * $rb0 (IS)">;
  // The same, with the sums, which are known to fit (BfinFetches).
  let Uses = [A0, A1], Defs = [A0, A1, R2, R3], ReadsEarly = true in
  def MACGETS : Dsp<(outs), (ins AddOrTake:$op1, HalfOf:$ra1, HalfOf:$rb1, AddOrTake:$op0, HalfOf:$ra0, HalfOf:$rb0),
                    "R3 = (A1 $op1 $ra1 * $rb1), R2 = (A0 $op0 $ra0 * $rb0) (IS)">;
}

//===-- Conditions ---------------------------------------------------------------------------------===//
foreach number = 0-2 in {
  def cmp_imm_#number : ImmLeaf<i32, [{ return isInt<3>(Imm); }]>;
}
foreach number = 3-4 in {
  def cmp_imm_#number : ImmLeaf<i32, [{ return isUInt<3>(Imm); }]>;
}
// The third operand of a comparison: BfinCC in BfinISelLowering.hpp.
multiclass Compare<string sign, string domain, int number> {
  defvar fits = !cast<ImmLeaf>("cmp_imm_"#number);
  let Defs = [CC] in {
    def _X : Pseudo<(outs), (ins DP:$ra, DP:$rb), [(bfin_cmp DP:$ra, DP:$rb, (i32 number))]>;
    def "" : BfinInst<2, (outs), (ins D:$ra, D:$rb), "CC = $ra "#sign#" $rb"#domain>;
    def P : BfinInst<2, (outs), (ins P:$ra, P:$rb), "CC = $ra "#sign#" $rb"#domain>;
    let AddedComplexity = 5 in
    def I : BfinInst<2, (outs), (ins DP:$ra, i32imm:$v), "CC = $ra "#sign#" $v"#domain,
                     [(bfin_cmp DP:$ra, fits:$v, (i32 number))]>;
  }
}
let isCompare = true in {
  defm CMPEQ : Compare<"==", "", 0>;
  defm CMPLT : Compare<"<", "", 1>;
  defm CMPLE : Compare<"<=", "", 2>;
  defm CMPULT : Compare<"<", " (IU)", 3>;
  defm CMPULE : Compare<"<=", " (IU)", 4>;
  let Defs = [CC] in
  def BITTST : BfinInst<2, (outs), (ins D:$ra, i32imm:$n), "CC = BITTST($ra, $n)", [(bfin_bittst D:$ra, timm:$n)]>;
}
let Uses = [CC] in {
  def FROMCC : BfinInst<2, (outs D:$rd), (ins), "$rd = CC", [(set D:$rd, (bfin_fromcc))]>;
  let Defs = [CC], ShiftsByNumber = true in
  def ROTCC : Dsp<(outs D:$rd), (ins D:$ra), "$rd = ROT $ra BY 1", [(set D:$rd, (bfin_rotcc D:$ra))]>;
  let Defs = [CC] in
  def NOTCC : BfinInst<2, (outs), (ins), "CC = !CC", [(bfin_notcc)]>;
  let Constraints = "$otherwise = $rd" in {
    def MOVT : BfinInst<2, (outs DP:$rd), (ins DP:$then, DP:$otherwise), "IF CC $rd = $then",
                        [(set DP:$rd, (bfin_select DP:$then, DP:$otherwise, (i32 1)))]>;
    def MOVF : BfinInst<2, (outs DP:$rd), (ins DP:$then, DP:$otherwise), "IF !CC $rd = $then",
                        [(set DP:$rd, (bfin_select DP:$then, DP:$otherwise, (i32 0)))]>;
  }
}

//===-- Control ------------------------------------------------------------------------------------===//
def BranchPrediction : Operand<i32> { let PrintMethod = "printPrediction"; }
let isBranch = true, isTerminator = true in {
  let Uses = [CC] in {
    def JCC : BfinInst<2, (outs), (ins Target:$to, BranchPrediction:$bp), "IF CC JUMP $to$bp">;
    def JNCC : BfinInst<2, (outs), (ins Target:$to, BranchPrediction:$bp), "IF !CC JUMP $to$bp">;
  }
  let isBarrier = true in {
    def JUMP : BfinInst<4, (outs), (ins Target:$to), "JUMP $to", [(br bb:$to)]>;
    let isIndirectBranch = true in
    def JUMPR : BfinInst<2, (outs), (ins P:$to), "JUMP ($to)", [(brind P:$to)]>;
  }
}
def : Pat<(bfin_jcc bb:$to, (i32 1)), (JCC bb:$to, 0)>;
def : Pat<(bfin_jcc bb:$to, (i32 0)), (JNCC bb:$to, 0)>;

let isCall = true, Defs = [RETS, SP], Uses = [SP] in {
  def CALL : BfinInst<4, (outs), (ins Callee:$to, variable_ops), "CALL $to">;
  def CALLR : BfinInst<2, (outs), (ins P:$to, variable_ops), "CALL ($to)", [(bfin_call P:$to)]>;
}
def : Pat<(bfin_call tglobaladdr:$to), (CALL tglobaladdr:$to)>;
def : Pat<(bfin_call texternalsym:$to), (CALL texternalsym:$to)>;

let isReturn = true, isTerminator = true, isBarrier = true in {
  def RTS : BfinInst<2, (outs), (ins variable_ops), "RTS", [(bfin_ret)]>;
  def RTI : BfinInst<2, (outs), (ins variable_ops), "RTI", [(bfin_reti)]>;
  let isCall = true, Uses = [SP] in
  def TAILCALL : BfinInst<4, (outs), (ins Callee:$to, variable_ops), "JUMP $to">;
}
def : Pat<(bfin_tailcall tglobaladdr:$to), (TAILCALL tglobaladdr:$to)>;
def : Pat<(bfin_tailcall texternalsym:$to), (TAILCALL texternalsym:$to)>;

let Defs = [SP], Uses = [SP], hasSideEffects = true in {
  def ADJCALLSTACKDOWN : Pseudo<(outs), (ins i32imm:$n, i32imm:$m), [(callseq_start timm:$n, timm:$m)]>;
  def ADJCALLSTACKUP : Pseudo<(outs), (ins i32imm:$n, i32imm:$m), [(callseq_end timm:$n, timm:$m)]>;
  let mayStore = true in {
    def PUSH : BfinInst<2, (outs), (ins ANY:$rs), "[--SP] = $rs">;
    def PUSHM : BfinInst<2, (outs), (ins PushD:$d, i32imm:$p, variable_ops), "[--SP] = $d">;
    let Defs = [SP, FP], Uses = [SP, FP, RETS] in
    def LINK : BfinInst<4, (outs), (ins i32imm:$n), "LINK $n">;
  }
  let mayLoad = true in {
    def POP : BfinInst<2, (outs ANY:$rd), (ins), "$rd = [SP++]">;
    def POPM : BfinInst<2, (outs), (ins PushD:$d, i32imm:$p, variable_ops), "$d = [SP++]">;
    let Defs = [SP, FP, RETS], Uses = [FP] in
    def UNLINK : BfinInst<4, (outs), (ins), "UNLINK">;
  }
}

//===-- Hardware loops -----------------------------------------------------------------------------===//
// Selected by the loop intrinsics, with the counter in a register; what BfinHardwareLoops cannot put
// on LC0 or LC1 turns into an ordinary count down.
let hasSideEffects = true, mayLoad = true, mayStore = true, isNotDuplicable = true in {
  def LOOPSTART : Pseudo<(outs DP:$rd), (ins DP:$n), [(set DP:$rd, (int_start_loop_iterations DP:$n))]>;
  def LOOPDEC : Pseudo<(outs DP:$rd), (ins DP:$n, i32imm:$by),
                       [(set DP:$rd, (int_loop_decrement_reg DP:$n, imm_any:$by))]>;
  // LC register number, count. A terminator, so that it stays behind the copies into the loop.
  let isTerminator = true, Defs = [LC0, LC1, LT0, LT1, LB0, LB1] in
  def LOOPSETUP : Pseudo<(outs), (ins i32imm:$lc, P:$n, i32imm:$least)>;
}
let isBranch = true, isTerminator = true, isNotDuplicable = true, hasSideEffects = true, Size = 0,
    Uses = [LC0, LC1], Defs = [LC0, LC1] in
def ENDLOOP : Pseudo<(outs), (ins Target:$top, i32imm:$lc)>;
let hasSideEffects = true, Defs = [LC0, LC1, LT0, LT1, LB0, LB1] in
def LSETUP : BfinInst<4, (outs), (ins Target:$top, Target:$end, SYS:$lc, P:$n), "LSETUP ($top, $end) $lc = $n">;

//===-- System -------------------------------------------------------------------------------------===//
let hasSideEffects = true, mayLoad = true, mayStore = true in {
  def CSYNC : BfinInst<2, (outs), (ins), "CSYNC">;
  def SSYNC : BfinInst<2, (outs), (ins), "SSYNC">;
  def IDLE : BfinInst<2, (outs), (ins), "IDLE">;
  def NOP : BfinInst<2, (outs), (ins), "NOP">;
  def CLI : BfinInst<2, (outs D:$rd), (ins), "CLI $rd">;
  def STI : BfinInst<2, (outs), (ins D:$rs), "STI $rs">;
  def RAISE : BfinInst<2, (outs), (ins i32imm:$n), "RAISE $n">;
  def EXCPT : BfinInst<2, (outs), (ins i32imm:$n), "EXCPT $n">;
  foreach name = ["PREFETCH", "FLUSH", "FLUSHINV", "IFLUSH"] in
  def CACHE_#name : BfinInst<2, (outs), (ins P:$at), name#" [$at]">;
  def READSYSTEM : BfinInst<2, (outs D:$rd), (ins SystemRegister:$from), "$rd = $from">;
  let Defs = [CC] in  // a part of ASTAT
  def WRITESYSTEM : BfinInst<2, (outs), (ins SystemRegister:$to, D:$rs), "$to = $rs">;
  let Defs = [CC] in
  def TESTSET : BfinInst<2, (outs), (ins P:$at), "TESTSET ($at)", [(bfin_testset P:$at)]>;
}

include "BfinFract.td"
include "BfinRings.td"
