// Registers only: additions, logic and shifts in a hardware loop.
    .text
    .global __start
__start:
    P0.L = 0x9680;  // 10 million times
    P0.H = 0x0098;
    R0 = 1 (X); R1 = 3 (X); R2 = 5 (X); R3 = 7 (X); R4 = 0 (X); R5 = 11 (X);
    LSETUP (first, last) LC0 = P0;
first:
    R0 = R0 + R1;
    R2 = R2 ^ R0;
    R3 = R3 - R1;
    R4 = R4 | R2;
    R5 = R5 & R3;
    R1 += 3;
    R4 >>= 1;
last:
    R5 = R0 + R2;
    HLT;
