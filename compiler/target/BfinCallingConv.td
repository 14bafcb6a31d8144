// The public Blackfin ABI: three words in registers, each with a home in the caller's frame; the rest
// above those twelve bytes. A hidden result pointer travels in P0.
def CC_Bfin : CallingConv<[
  CCIfType<[i1, i8, i16], CCPromoteToType<i32>>,
  CCIf<"ArgFlags.isSRet()", CCAssignToReg<[P0]>>,
  CCIfType<[i32], CCAssignToReg<[R0, R1, R2]>>,
  CCAssignToStack<4, 4>
]>;

// Units of the runtime that only compiled code calls, all in registers (kInRegisters).
def CC_BfinInRegisters : CallingConv<[
  CCIfType<[i32], CCAssignToReg<[R0, R1, R2, R3, P0, P1]>>
]>;

def RetCC_Bfin : CallingConv<[
  CCIfType<[i1, i8, i16], CCPromoteToType<i32>>,
  CCIfType<[i32], CCAssignToReg<[R0, R1]>>
]>;

def CSR_Bfin : CalleeSavedRegs<(add R7, R6, R5, R4, P5, P4, P3)>;
// FP is kept by LINK and UNLINK, not by the multiple push, yet survives a call all the same.
def CSR_BfinCall : CalleeSavedRegs<(add CSR_Bfin, FP)>;
// An interrupt handler may find anything live.
def CSR_BfinInterrupt : CalleeSavedRegs<(add R7, R6, R5, R4, R3, R2, R1, R0, P5, P4, P3, P2, P1, P0)>;
