# macros, conditionals, repetition
    .macro load reg:req, value=5, rest:vararg
    .if (\value) & ~0x7fff
    \reg\().L = ((\value) & 0xffff);
    \reg\().H = (((\value) >> 16) & 0xffff);
    .else
    \reg = \value;
    .endif
    .endm
    .set count, 3
    .text
    .global _start
_start:
    load R0, 0x12345678
    load reg=R1
    .rept count
    R0 += 1;
    .endr
    .irp r, R2, R3
    \r = 0;
    .endr
1:  CC = R0 == R1;
    IF CC JUMP 1b;
    IF !CC JUMP 2f;
    NOP;
2:  P0.L = data + 4;
    P0.H = data + 4;
    R5 = [P0++] || NOP;
    DBGA (R0.L, 0x567b);
    HLT;
    .ifdef MISSING
    nonsense
    .endif
    .data
data:
    .dd 1, 2, 'a', data - 4, (1 << 4) + 2 * 3
    .byte 1, 2
    .align 4
    .fill 3, 2, 7
