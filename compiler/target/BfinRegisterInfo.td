// Registers. Halves (R0.L) are no sub-registers: what writes a half ties the other half's old
// value.
class BfinReg<string name> : Register<name> {
  let Namespace = "Bfin";
}

foreach i = 0 - 7 in {
  def R #i : BfinReg<"R" #i>;
}
foreach i = 0 - 5 in { def P #i : BfinReg<"P" #i>; }
def SP : BfinReg<"SP">;
def FP : BfinReg<"FP">;
foreach i = 0 - 3 in {
  def I #i : BfinReg<"I" #i>;
  def M #i : BfinReg<"M" #i>;
  def B #i : BfinReg<"B" #i>;
  def L#i : BfinReg<"L" #i>;
}
// What a circular buffer takes, as one register: printed as its index register.
let Namespace = "Bfin" in {
  def sub_i : SubRegIndex<32, 0>;
  def sub_m : SubRegIndex<32, 32>;
  def sub_b : SubRegIndex<32, 64>;
  def sub_l : SubRegIndex<32, 96>;
}
foreach i = 0 - 3 in {
  let Namespace = "Bfin", SubRegIndices = [sub_i, sub_m, sub_b, sub_l], CoveredBySubRegs = true in
  def RING #i : RegisterWithSubRegs<"I" #i, [!cast<Register>("I" #i), !cast<Register>("M" #i),
                                             !cast<Register>("B" #i), !cast<Register>("L" #i)]>;
}
foreach i = 0 - 1 in {
  def A #i : BfinReg<"A" #i>;
  def A #i #W : BfinReg<"A" #i #".W">;
  def A #i #X : BfinReg<"A" #i #".X">;
  def LC #i : BfinReg<"LC" #i>;
  def LT #i : BfinReg<"LT" #i>;
  def LB #i : BfinReg<"LB" #i>;
}
def CC : BfinReg<"CC">;
def ASTAT : BfinReg<"ASTAT">;
def RETS : BfinReg<"RETS">;
def RETI : BfinReg<"RETI">;

// Scratch registers first, then the callee-saved ones from the top, because a multiple push saves
// R7 down to some register.
def D : RegisterClass<"Bfin", [i32], 32, (add R0, R1, R2, R3, R7, R6, R5, R4)>;
// Results of A0 and of A1.
def DEven : RegisterClass<"Bfin", [i32], 32, (add R0, R2, R6, R4)>;
def DOdd : RegisterClass<"Bfin", [i32], 32, (add R1, R3, R7, R5)>;
def P : RegisterClass<"Bfin", [i32], 32, (add P0, P1, P2, P5, P4, P3, SP, FP)>;
// Selection works on this union; the bank pass then says which of the two a value lives in.
def DP : RegisterClass<"Bfin", [i32], 32, (add D, P)>;
def IR : RegisterClass<"Bfin", [i32], 32, (add I0, I1, I2, I3)>;
def MR : RegisterClass<"Bfin", [i32], 32, (add M0, M1, M2, M3)>;
def BR : RegisterClass<"Bfin", [i32], 32, (add B0, B1, B2, B3)>;
def LR : RegisterClass<"Bfin", [i32], 32, (add L0, L1, L2, L3)>;
// From the top: instructions on bytes want I0 and I1.
def RING : RegisterClass<"Bfin", [untyped], 32, (add RING3, RING2, RING1, RING0)> { let Size = 128; }

let isAllocatable = false in {
  def CCR : RegisterClass<"Bfin", [i32], 32, (add CC)>;
  def SYS : RegisterClass<"Bfin", [i32], 32,
                          (add BR, LR, A0, A1, A0W, A0X, A1W, A1X, LC0, LC1,
                           LT0, LT1, LB0, LB1, ASTAT, RETS, RETI)>;
  def ANY : RegisterClass<"Bfin", [i32], 32, (add DP, IR, MR, SYS)>;
}
