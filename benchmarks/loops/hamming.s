// The heart of census matching: packed census words of two rows, XOR, population count, a running
// sum, and a store; two loads and a store ride along.
    .text
    .global __start
__start:
    P5.L = 0x86A0; P5.H = 1;  // 100,000 rows of 128 words
again:
    I0.L = left; I0.H = left;
    I1.L = right; I1.H = right;
    P1.L = scores; P1.H = scores;
    P0 = 128 (X);
    R7 = 0 (X);
    R3 = [I0++];
    R4 = [I1++];
    R2 = 0 (X);
    LSETUP (first, last) LC0 = P0;
first:
    R5 = R3 ^ R4;
    R2.L = ONES R5 || R3 = [I0++] || NOP;
    R7 = R7 + R2 (NS) || R4 = [I1++];
last:
    MNOP || W[P1++] = R7 || NOP;
    P5 += -1;
    CC = P5 == 0;
    IF !CC JUMP again (BP);
    HLT;

    .data
    .align 4
left:
    .fill 132, 4, 0x12345678
right:
    .fill 132, 4, 0x9abcdef0
scores:
    .space 512
