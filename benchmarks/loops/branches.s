// Branches that go both ways, calls and returns: a shift register decides.
    .text
    .global __start
__start:
    P0.L = 0x8480;  // 2 million times
    P0.H = 0x001E;
    R0.L = 0x1234; R0.H = 0x5678;
    R1 = 0 (X); R2 = 0 (X); R3 = 0 (X);
again:
    CC = BITTST (R0, 0);
    R0 >>= 1;
    IF !CC JUMP even;
    BITTGL (R0, 31);
    BITTGL (R0, 21);
    BITTGL (R0, 1);
    R1 += 1;
    CALL visit;
    JUMP next;
even:
    R2 += 1;
    CC = BITTST (R0, 3);
    IF CC JUMP next (BP);
    R3 += 1;
next:
    P0 += -1;
    CC = P0 == 0;
    IF !CC JUMP again (BP);
    HLT;

visit:
    CC = R1 < R2;
    IF CC R4 = R1;
    R5 = R1 + R2;
    RTS;
