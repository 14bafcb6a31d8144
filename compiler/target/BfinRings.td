// Circular buffers: the index register, the step, the base and the length of one number are one
// register to allocation. A ring begins where its loop does and ends behind it, where its length
// becomes 0 again (BfinRings).

// As selected: pointers, in any register. What begins a ring takes the first address, the base, the
// length and the step in bytes.
let hasSideEffects = true in {
  def RINGBEGIN : Pseudo<(outs DP:$rd), (ins DP:$start, DP:$base, DP:$bytes, DP:$step)>;
  def RINGNEXT : Pseudo<(outs DP:$rd), (ins DP:$ring)>;
  def RINGDONE : Pseudo<(outs DP:$rd), (ins DP:$ring)>;
}

def RingByStep : RegisterOperand<RING, "printRingByStep">;   // I0 ++ M0
def RingAndStep : RegisterOperand<RING, "printRingAndStep">; // I0 += M0
def RingLength : RegisterOperand<RING, "printRingLength">;   // L0

// The registers of a ring that begins, in one piece to all passes before allocation: nothing may
// move a part of them out of an outer loop, where the ring would not be theirs alone. Length and step
// are the numbers where there is no register.
let hasSideEffects = true, Size = 16 in
def RINGLOAD : Pseudo<(outs RING:$ring), (ins DP:$start, DP:$base, DP:$bytes, i32imm:$known_bytes,
                                              DP:$step, i32imm:$known_step)>;
let isMoveImm = true in {
  def SETLENGTH : BfinInst<4, (outs LR:$rd), (ins i32imm:$v), "$rd = $v (Z)">;
  def SETSTEP : BfinInst<4, (outs MR:$rd), (ins i32imm:$v), "$rd = $v (X)">;
}
let Constraints = "$ring = $next" in {
  let IssueSlot = MemSlot in
  def RINGADD : BfinInst<2, (outs RING:$next), (ins RingAndStep:$ring), "$ring">;
  let hasSideEffects = true in
  def RINGEND : BfinInst<4, (outs RING:$next), (ins RingLength:$ring), "$ring = 0 (X)">;
}

let mayLoad = true, IssueSlot = IndexSlot in {
  def LDWR : BfinInst<2, (outs D:$rd), (ins RING:$base), "$rd = [$base]">;
  let Constraints = "$old = $rd" in
  def LDLR : BfinInst<2, (outs D:$rd), (ins RING:$base, D:$old), "${rd}.L = W[$base]">;
  let Constraints = "$base = $next" in
  def LDWRStep : BfinInst<2, (outs D:$rd, RING:$next), (ins RingByStep:$base), "$rd = [$base]">;
  foreach step = ["Inc", "Dec"] in {
    defvar sign = !if(!eq(step, "Inc"), "++", "--");
    let Constraints = "$base = $next" in
    def LDWR#step : BfinInst<2, (outs D:$rd, RING:$next), (ins RING:$base), "$rd = [$base"#sign#"]">;
    let Constraints = "$base = $next, $old = $rd" in
    def LDLR#step
        : BfinInst<2, (outs D:$rd, RING:$next), (ins RING:$base, D:$old), "${rd}.L = W[$base"#sign#"]">;
  }
}
let mayStore = true, IssueSlot = IndexSlot in {
  def STWR : BfinInst<2, (outs), (ins D:$rs, RING:$base), "[$base] = $rs">;
  def STHR : BfinInst<2, (outs), (ins D:$rs, RING:$base), "W[$base] = ${rs}.L">;
  let Constraints = "$base = $next" in {
    def STWRStep : BfinInst<2, (outs RING:$next), (ins D:$rs, RingByStep:$base), "[$base] = $rs">;
    foreach step = ["Inc", "Dec"] in {
      defvar sign = !if(!eq(step, "Inc"), "++", "--");
      def STWR#step : BfinInst<2, (outs RING:$next), (ins D:$rs, RING:$base), "[$base"#sign#"] = $rs">;
      def STHR#step : BfinInst<2, (outs RING:$next), (ins D:$rs, RING:$base), "W[$base"#sign#"] = ${rs}.L">;
    }
  }
}
