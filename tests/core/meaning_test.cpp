// What each instruction of the table does: registers, flags and memory after small programs with
// hand-worked results, on the engine. Every entry on thousands of states: tests/instructions.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sstream>

#include "core_harness.hpp"

namespace finback::core {
namespace {

// `code` runs with P0 = I0 = b, P1 = I1 = b + 8, P2 = M0 = 4, where b is the address of 64 bytes
// that begin with the words 0x84838281, 0x11223344, 0x7FFFFFFF, 0xFFFF8000 and zeros; R0-R7 are 0.
// `expected`: "R1=0x5 P1=b+4 CC=1 A0=-2 [4]=0x7" (a word of the buffer).
struct Meaning {
  const char* code;
  const char* expected;
};

constexpr Meaning kMemory[] = {
    {"R1 = [P0];", "R1=0x84838281 P0=b"},
    {"R1 = [P0++];", "R1=0x84838281 P0=b+4"},
    {"R1 = [P1--];", "R1=0x7FFFFFFF P1=b+4"},
    {"R1 = [P0 + 4];", "R1=0x11223344"},
    {"R1 = [P1 + -4];", "R1=0x11223344"},
    {"FP = P1; R1 = [FP - 8]; P3 = [FP - 4];", "R1=0x84838281 P3=0x11223344"},
    {"R1 = [P0++P2];", "R1=0x84838281 P0=b+4"},
    {"R1 = [I0];", "R1=0x84838281"},
    {"R1 = [I0++]; R2 = [I0--]; R3 = [I0++M0]; R4 = [I0];",
     "R1=0x84838281 R2=0x11223344 R3=0x84838281 R4=0x11223344"},
    {"P3 = [P0]; P4 = [P0++]; P5 = [P0--];", "P3=0x84838281 P4=0x84838281 P5=0x11223344 P0=b"},
    {"P3 = [P0 + 4]; P4 = [P1 + -8];", "P3=0x11223344 P4=0x84838281"},
    {"R1 = W[P0] (Z); R2 = W[P0] (X);", "R1=0x8281 R2=0xFFFF8281"},
    {"R1 = W[P0++] (Z); R2 = W[P0++] (X);", "R1=0x8281 R2=0xFFFF8483 P0=b+4"},
    {"R1 = W[P1--] (Z); R2 = W[P1--] (X);", "R1=0xFFFF R2=0x1122 P1=b+4"},
    {"R1 = W[P0 + 2] (Z); R2 = W[P0 + 2] (X);", "R1=0x8483 R2=0xFFFF8483"},
    {"R1 = W[P1 + -8] (Z); R2 = W[P1 + -8] (X);", "R1=0x8281 R2=0xFFFF8281"},
    {"R1 = W[P0++P2] (Z); R2 = W[P0++P2] (X);", "R1=0x8281 R2=0x3344 P0=b+8"},
    {"R1 = -1 (X); R2 = -1 (X); R1.L = W[P0]; R2.H = W[P0];", "R1=0xFFFF8281 R2=0x8281FFFF"},
    {"R1.L = W[P0++P2]; R2.H = W[P0++P2];", "R1=0x8281 R2=0x33440000 P0=b+8"},
    {"R1.L = W[I0]; R1.H = W[I0];", "R1=0x82818281"},
    {"R1.L = W[I0++]; R1.H = W[I0++];", "R1=0x84838281"},
    {"R1.L = W[I1--]; R1.H = W[I1--];", "R1=0x1122FFFF"},
    {"R1 = B[P0] (Z); R2 = B[P0] (X);", "R1=0x81 R2=0xFFFFFF81"},
    {"R1 = B[P0++] (Z); R2 = B[P0++] (X);", "R1=0x81 R2=0xFFFFFF82 P0=b+2"},
    {"R1 = B[P1--] (Z); R2 = B[P1--] (X);", "R1=0xFF R2=0x11 P1=b+6"},
    {"R1 = B[P0 + 3] (Z); R2 = B[P0 + 3] (X);", "R1=0x84 R2=0xFFFFFF84"},
    {"R1 = 9 (X); [P0] = R1;", "[0]=9"},
    {"R1 = 9 (X); [P0++] = R1; [P0--] = R1;", "[0]=9 [4]=9 P0=b"},
    {"R1 = 9 (X); [P0 + 4] = R1; [P1 + -8] = R1;", "[0]=9 [4]=9"},
    {"FP = P1; R1 = 9 (X); [FP - 8] = R1; [FP - 4] = P2;", "[0]=9 [4]=4"},
    {"R1 = 9 (X); [P0++P2] = R1;", "[0]=9 P0=b+4"},
    {"R1 = 9 (X); [I0] = R1; [I0++] = R1; [I0--] = R1; [I0++M0] = R1; R2 = I0;",
     "[0]=9 [4]=9 R2=b+4"},
    {"[P0] = P2; [P0++] = P2; [P0--] = P2; [P0 + 8] = P2; [P1 + -4] = P2;",
     "[0]=4 [4]=4 [8]=4 P0=b"},
    {"R1 = 0x1234 (X); W[P0] = R1;", "[0]=0x84831234"},
    {"R1 = 0x1234 (X); W[P0++] = R1; W[P0--] = R1;", "[0]=0x12341234 P0=b"},
    {"R1 = 0x1234 (X); W[P0 + 2] = R1; W[P1 + -4] = R1;", "[0]=0x12348281 [4]=0x11221234"},
    {"R1.L = 0x1234; R1.H = 0x5678; W[P0] = R1.L; W[P1] = R1.H;", "[0]=0x84831234 [8]=0x7FFF5678"},
    {"R1.L = 0x1234; R1.H = 0x5678; W[P0++P2] = R1.L; W[P0++P2] = R1.H;",
     "[0]=0x84831234 [4]=0x11225678"},
    {"R1.L = 0x1234; R1.H = 0x5678; W[I0] = R1.L; W[I1] = R1.H;", "[0]=0x84831234 [8]=0x7FFF5678"},
    {"R1.L = 0x1234; R1.H = 0x5678; W[I0++] = R1.L; W[I0++] = R1.H;", "[0]=0x56781234"},
    {"R1.L = 0x1234; R1.H = 0x5678; W[I1--] = R1.L; W[I1--] = R1.H;",
     "[8]=0x7FFF1234 [4]=0x56783344"},
    {"R1 = 0x1F5 (X); B[P0] = R1;", "[0]=0x848382F5"},
    {"R1 = 7 (X); B[P0++] = R1; B[P0++] = R1; B[P0--] = R1;", "[0]=0x84070707 P0=b+1"},
    {"R1 = 7 (X); B[P0 + 3] = R1;", "[0]=0x07838281"},
    {"R1 = 5 (X); [--SP] = R1; [--SP] = P2; R2 = [SP++]; P3 = [SP++];", "R2=4 P3=5"},
    {"R1 = 5 (X); RETS = R1; [--SP] = RETS; RETS = R0; RETS = [SP++]; R2 = RETS;", "R2=5"},
    {"R7 = 7 (X); R6 = 6 (X); P5 = 5 (X); R1 = SP; [--SP] = (R7:6, P5:5); R2 = SP; R7 = 0 (X); P5 "
     "= 0 (X); "
     "(R7:6, P5:5) = [SP++]; R3 = SP; R3 = R3 - R1; R2 = R2 - R1;",
     "R7=7 R6=6 P5=5 R3=0 R2=-12"},
    {"R7 = 7 (X); [--SP] = (R7:7); R7 = 0 (X); R1 = [SP]; (R7:7) = [SP++];", "R7=7 R1=7"},
    {"P5 = 3 (X); [--SP] = (P5:5); P5 = 0 (X); (P5:5) = [SP++];", "P5=3"},
    {"R1 = SP; LINK 8; R2 = SP; R3 = FP; UNLINK; R4 = SP; R4 = R4 - R1; R2 = R2 - R1; R3 = R3 - "
     "R1;",
     "R4=0 R2=-16 R3=-8"},
    {"P3.L = 0; P3.H = 0xFEB0; TESTSET (P3); R1 = CC; TESTSET (P3); R2 = CC; R3 = B[P3] (Z);",
     "R1=1 R2=0 R3=0x80"},
};

constexpr Meaning kMoves[] = {
    {"R1 = 5 (X); R2 = R1; P3 = P2; R3 = P2; P4 = R1;", "R2=5 P3=4 R3=4 P4=5"},
    {"R1 = 5 (X); M1 = R1; R2 = M1; B3 = R1; R3 = B3; LC0 = R1; R4 = LC0; R5 = 0 (X); LC0 = R5;",
     "R2=5 R3=5 R4=5"},
    {"R1 = 0x21 (X); ASTAT = R1; R2 = ASTAT; R3 = CC;", "R2=0x21 R3=1"},
    {"R1 = -2 (X); A0.W = R1; R2 = 0x7F (X); A0.X = R2; R3 = A0.X; R4 = A0.W;", "R3=0x7F R4=-2"},
    {"R1 = -64 (X); R2 = 63; P3 = -64 (X); P4 = 63;", "R1=-64 R2=63 P3=-64 P4=63"},
    {"R1 = -32768 (X); R2 = 32767; P3 = -32768 (X); P4 = 32767;",
     "R1=-32768 R2=32767 P3=-32768 P4=32767"},
    {"R1 = 65535 (Z); P3 = 65535 (Z);", "R1=65535 P3=65535"},
    {"R1.L = 0x1234; R1.H = 0xABCD; P3.L = 0x5678; P3.H = 0x9ABC;", "R1=0xABCD1234 P3=0x9ABC5678"},
    {"R1.L = 0x80F0; R1.H = 7; R2 = R1.L (Z); R3 = R1.L (X); R4 = R1.B (Z); R5 = R1.B (X);",
     "R2=0x80F0 R3=0xFFFF80F0 R4=0xF0 R5=0xFFFFFFF0"},
    {"CC = R0 == R0; R1 = 1 (X); R2 = 2 (X); IF CC R3 = R1; IF !CC R4 = R1; IF CC R5 = P2; IF !CC "
     "R6 = P2;",
     "R3=1 R4=0 R5=4 R6=0"},
    {"CC = R0 == R0; R1 = 1 (X); P3 = 0 (X); P4 = 0 (X); P5 = 0 (X); IF CC P3 = R1; IF !CC P4 = "
     "R1; IF CC P5 = P2; IF !CC P0 = P2;",
     "P3=1 P4=0 P5=4 P0=b"},
    {"R1 = 3 (X); CC = R1 == R0;", "CC=0 AZ=0 AN=0 AC0=1"},
    {"R1 = 3 (X); CC = R1 == 3;", "CC=1 AZ=1 AN=0 AC0=1"},
    {"R1 = -1 (X); CC = R1 < R0;", "CC=1 AN=1"},
    {"R1 = -1 (X); CC = R1 < -2;", "CC=0"},
    {"R1 = -1 (X); CC = R1 <= R0;", "CC=1"},
    {"R1 = -1 (X); CC = R1 <= -1;", "CC=1"},
    {"R1 = -1 (X); CC = R1 < R0 (IU);", "CC=0 AC0=1"},
    {"R1 = 6 (X); CC = R1 < 7 (IU);", "CC=1"},
    {"R1 = -1 (X); CC = R0 <= R1 (IU);", "CC=1 AC0=0"},
    {"R1 = 7 (X); CC = R1 <= 7 (IU);", "CC=1"},
    {"CC = P0 == P0;", "CC=1"},
    {"CC = P2 == 3;", "CC=0"},
    {"CC = P2 < P2;", "CC=0"},
    {"CC = P2 < -1;", "CC=0"},
    {"CC = P2 <= P2;", "CC=1"},
    {"CC = P2 <= 3;", "CC=0"},
    {"CC = P2 < P0 (IU);", "CC=1"},
    {"CC = P2 < 5 (IU);", "CC=1"},
    {"CC = P0 <= P2 (IU);", "CC=0"},
    {"CC = P2 <= 4 (IU);", "CC=1"},
    {"R1 = 8 (X); CC = R1; R2 = CC; CC = !CC; R3 = CC;", "R2=1 R3=0"},
    {"R1 = R0 & R0; CC = AZ; R2 = CC; R1 = ~R0; CC = AN; R3 = CC;", "R2=1 R3=1"},
    {"R1 = -1 (X); R2 = 1 (X); R3 = R1 + R2; CC = AC0; R4 = CC;", "R3=0 R4=1"},
    {"R1 = [P1]; R2 = 1 (X); R3 = R1 + R2; CC = V; R4 = CC; R3 = R2 + R2; CC = VS; R5 = CC; CC = "
     "V; R6 = CC;",
     "R3=2 R4=1 R5=1 R6=0"},
    {"R1 = 1 (X); R2.L = 0x8000; DIVS(R1, R2); CC = AQ;", "CC=1"},
    {"R1 = 4 (X); CC = BITTST(R1, 2); R2 = CC; CC = !BITTST(R1, 2); R3 = CC;", "R2=1 R3=0"},
};

constexpr Meaning kArithmetic[] = {
    {"R1 = 7 (X); R2 = -9 (X); R3 = R1 + R2; R4 = R1 - R2;", "R3=-2 R4=16"},
    {"R1 = 12 (X); R2 = 10 (X); R3 = R1 & R2; R4 = R1 | R2; R5 = R1 ^ R2;", "R3=8 R4=14 R5=6"},
    {"R1 = [P1]; R1 += 1;", "R1=0x80000000 V=1 AN=1 AC0=0"},
    {"R1 = 5 (X); R2 = -R1; R3 = ~R1;", "R2=-5 R3=-6"},
    {"R1 = 1000; R2 = -70 (X); R1 *= R2;", "R1=-70000"},
    {"R1 = 3 (X); R2 = 4 (X); R1 = (R1 + R2) << 1; R3 = 1 (X); R3 = (R3 + R2) << 2;",
     "R1=14 R3=20"},
    {"R1 = -16 (X); R2 = R1; R3 = R1; R1 <<= 2; R2 >>= 2; R3 >>>= 2;",
     "R1=-64 R2=0x3FFFFFFC R3=-4"},
    {"R4 = 2 (X); R1 = -16 (X); R2 = R1; R3 = R1; R1 <<= R4; R2 >>= R4; R3 >>>= R4;",
     "R1=-64 R2=0x3FFFFFFC R3=-4"},
    {"R4 = 40 (X); R1 = -16 (X); R2 = R1; R3 = R1; R1 <<= R4; R2 >>= R4; R3 >>>= R4;",
     "R1=0 R2=0 R3=-1"},
    {"R1 = 1 (X); R2 = 3 (X); R3 = 5 (X); BITSET(R1, 31); BITCLR(R2, 0); BITTGL(R3, 1);",
     "R1=0x80000001 R2=2 R3=7"},
    // 100 / 7 by one DIVS and sixteen DIVQ on the dividend doubled, as a 16-bit signed division
    // does
    {"R1 = 200; R2 = 7 (X); DIVS(R1, R2); P3 = 15 (X); LSETUP (.Ld, .Ld) LC0 = P3; .Ld: DIVQ(R1, "
     "R2); R1 = R1.L (X);",
     "R1=14"},
    {"P3 = P2 + P2; P4 = P2 + (P2 << 1); P5 = P2 + (P2 << 2);", "P3=8 P4=12 P5=20"},
    {"P3 = 1 (X); P3 = (P3 + P2) << 1; P4 = 1 (X); P4 = (P4 + P2) << 2;", "P3=10 P4=20"},
    {"P3 = P2 << 1; P4 = P2 << 2; P5 = P2 >> 1; P0 = P2 >> 2;", "P3=8 P4=16 P5=2 P0=1"},
    {"P0 += -4; P1 -= P2;", "P0=b-4 P1=b+4"},
    {"I0 += M0; I1 -= M0; R1 = [I0]; R2 = [I1];", "R1=0x11223344 R2=0x11223344"},
    {"I0 += 4; I1 -= 4; R1 = [I0]; R2 = [I1]; I0 += 2; I0 -= 2; R3 = [I0];",
     "R1=0x11223344 R2=0x11223344 R3=0x11223344"},
    // a circular buffer of 8 bytes at b: up past its end and down past its beginning
    {"R1 = P0; B0 = R1; R2 = 8 (X); L0 = R2; R3 = [I0++]; R4 = [I0++]; R5 = [I0--]; R6 = [I0]; R1 "
     "= 0 (X); L0 = R1;",
     "R3=0x84838281 R4=0x11223344 R5=0x84838281 R6=0x11223344"},
};

constexpr Meaning kDsp[] = {
    {"R1 = [P1]; R2 = 1 (X); R3 = R1 + R2 (NS); R4 = R1 + R2 (S);",
     "R3=0x80000000 R4=0x7FFFFFFF V=1"},
    {"R1 = 1 (X); R1 <<= 31; R2 = 1 (X); R3 = R1 - R2 (NS); R4 = R1 - R2 (S);",
     "R3=0x7FFFFFFF R4=0x80000000 V=1"},
    {"R1.L = 0x7FFF; R2.H = 2; R3.L = R1.L + R2.H (NS); R4.H = R1.L + R2.H (S);",
     "R3=0x8001 R4=0x7FFF0000 V=1"},
    {"R1.L = 0x8000; R2.H = 2; R3.L = R1.L - R2.H (NS); R4.H = R1.L - R2.H (S);",
     "R3=0x7FFE R4=0x80000000 V=1"},
    {"R1.L = 3; R1.H = 10; R2.L = 5; R2.H = 4; R3 = R1 +|+ R2; R4 = R1 +|- R2; R5 = R1 -|+ R2; R6 "
     "= R1 -|- R2;",
     "R3=0x000E0008 R4=0x000EFFFE R5=0x00060008 R6=0x0006FFFE"},
    {"R1.L = 0x7FFF; R1.H = 0x8000; R2.L = 1; R2.H = 0xFFFF; R3 = R1 +|+ R2 (S); R2.L = 0xFFFF; "
     "R2.H = 1; R4 = R1 -|- R2 (S);",
     "R3=0x80007FFF R4=0x80007FFF"},
    {"R1 = -5 (X); R2 = 3 (X); R3 = MAX(R1, R2); R4 = MIN(R1, R2);", "R3=3 R4=-5"},
    {"R1.L = 0xFFFF; R1.H = 2; R2.L = 1; R2.H = 0xFFFE; R3 = MAX(R1, R2) (V); R4 = MIN(R1, R2) "
     "(V);",
     "R3=0x00020001 R4=0xFFFEFFFF"},
    {"R1 = -5 (X); R2 = ABS R1; R3 = 1 (X); R3 <<= 31; R4 = ABS R3;", "R2=5 R4=0x7FFFFFFF V=1"},
    {"R1 = -16 (X); R2 = R1 << 3; R3 = R1 >> 3; R4 = R1 >>> 3;", "R2=-128 R3=0x1FFFFFFE R4=-2"},
    {"R1.L = 0x8001; R1.H = 0x0101; R2 = R1 << 4 (V); R3 = R1 >> 4 (V); R4 = R1 >>> 4 (V);",
     "R2=0x10100010 R3=0x00100800 R4=0x0010F800"},
    {"R1 = -16 (X); R2 = 4 (X); R3 = LSHIFT R1 BY R2.L; R2 = -4 (X); R4 = LSHIFT R1 BY R2.L; R5 = "
     "ASHIFT R1 BY R2.L;",
     "R3=-256 R4=0x0FFFFFFF R5=-1"},
    {"R1 = [P0]; R2.L = 0x0808; R3 = EXTRACT(R1, R2.L) (Z); R4 = EXTRACT(R1, R2.L) (X);",
     "R3=0x82 R4=0xFFFFFF82"},
    {"R1 = [P0]; R2.L = ONES R1; R3 = 1 (X); R3.L = SIGNBITS R3; R4 = -1 (X); R5.L = SIGNBITS R4;",
     "R2=9 R3=30 R5=31"},
    {"R1.L = 1; R1.H = 2; R2.L = 3; R2.H = 4; R3 = PACK(R1.H, R2.L);", "R3=0x00020003"},
    {"R1.L = 0x3322; R1.H = 0x5544; R2.L = 0xBBAA; R2.H = 0xDDCC; R3 = ALIGN8(R1, R2); R4 = "
     "ALIGN16(R1, R2); R5 = ALIGN24(R1, R2);",
     "R3=0x22DDCCBB R4=0x3322DDCC R5=0x443322DD"},
    {"R1.L = 0x4000; R1.H = 0x8000; R2 = R1.L * R1.L; R3 = R1.H * R1.H; R4 = R1.H * R1.L (IS); R5 "
     "= R1.H * R1.H (FU);",
     "R2=0x20000000 R3=0x7FFFFFFF R4=0xE0000000 R5=0x40000000"},
    {"R1.L = -3; R1.H = 5; A0 = R1.L * R1.H (IS); A0 += R1.H * R1.H (IS); A0 -= R1.L * R1.L (IS); "
     "R2 = A0;",
     "A0=1 R2=1"},
    {"R1.L = 0xFFFF; R1.H = 2; A0 = R1.L * R1.H (FU); A0 += R1.L * R1.H (FU);", "A0=262140"},
    {"R1.L = 0x4000; R1.H = 2; A0 = R1.L * R1.H; A0 += R1.L * R1.H; A0 -= R1.H * R1.H;",
     "A0=131064"},
    {"R1.L = -3; R1.H = 5; A1 = R1.L * R1.H (IS); A1 += R1.H * R1.H (IS); A1 -= R1.L * R1.L (IS); "
     "R3 = A1;",
     "A1=1 R3=1"},
    {"R1.L = 0x4000; R1.H = 2; A1 = R1.L * R1.H; A1 += R1.L * R1.H;", "A1=131072"},
    {"R1.L = 5; A0 = R1.L * R1.L (IS); A1 = R1.L * R1.L (IS); A0 = 0; R3 = A1; A1 = 0;",
     "A0=0 A1=0 R3=25"},
    {"R1.L = 5; A0 = R1.L * R1.L (IS); A1 = A0 = 0; MNOP;", "A0=0 A1=0"},
    // parallel: everybody reads before anybody writes
    {"R1 = 1 (X); R2 = 2 (X); R1 = R1 + R2 (NS) || R2 = [P0]; R3 = R1;", "R3=3 R2=0x84838281"},
    {"R1 = 1 (X); R2 = 2 (X); R1 = R1 + R2 (NS) || [P0] = R1;", "R1=3 [0]=1"},
    {"R1 = 1 (X); MNOP || R1 = [P1] || [I0] = R1;", "R1=0x7FFFFFFF [0]=1"},
    {"R1 = 6 (X); MNOP || R2 = [P0] || [I0] = R1;", "R2=0x84838281 [0]=6"},
    {"MNOP || I0 += M0 || R1 = [I1];", "R1=0x7FFFFFFF"},
};

constexpr Meaning kShifter[] = {
    // rotation: CC is the ring's 33rd (41st) bit
    {"R1 = 1 (X); R1 <<= 31; R1 += 1; R2 = ROT R1 BY 1; R3 = ROT R1 BY -1;",
     "R2=2 R3=0xC0000000 CC=1"},
    {"R1 = 3 (X); R4 = -2 (X); CC = R0 == R0; R2 = ROT R1 BY R4.L;", "R2=0xC0000000 CC=1"},
    {"R1 = 3 (X); CC = R0 == R0; R2 = ROT R1 BY 0; R3 = ROT R1 BY -32;", "R2=3 R3=7 CC=0"},
    {"R1 = 1 (X); A0 = R1.L * R1.L (IS); A1 = R1.L * R1.L (IS); R4 = -1 (X); A0 = ROT A0 BY 4; A0 "
     "= ROT A0 BY R4.L; A1 = ROT A1 BY 4; A1 = ROT A1 BY R4.L;",
     "A0=8 A1=8 CC=0"},
    {"R1 = 1 (X); A0 = R1.L * R1.L (IS); A0 = ROT A0 BY -1; A0 = ROT A0 BY -1;",
     "A0=-549755813888 CC=0"},
    // halves; V tells of lost bits, a change of sign alone only when it saturates
    {"R1.L = 0x4001; R2.L = R1.L << 1;", "R2=0x8002 V=0 AN=1"},
    {"R1.L = 0x4001; R2.L = R1.L << 2;", "R2=4 V=1 AN=0"},
    {"R1.L = 0x4001; R1.H = 0x8001; R3.L = R1.H >> 1; R4.L = R1.H >>> 1; R5.L = R1.L << 1 (S); "
     "R6.H = R1.H << 1 (S);",
     "R3=0x4000 R4=0xC000 R5=0x7FFF R6=0x80000000 V=1"},
    {"R1.L = 0x8001; R2 = 1 (X); R3.L = LSHIFT R1.L BY R2.L; R2 = -1 (X); R4.L = LSHIFT R1.L BY "
     "R2.L; R5.L = ASHIFT R1.L BY R2.L;",
     "R3=2 R4=0x4000 R5=0xC000 V=0"},
    {"R1.L = 0x8001; R2 = 1 (X); R6.L = ASHIFT R1.L BY R2.L; R7.L = ASHIFT R1.L BY R2.L (S);",
     "R6=2 R7=0x8000 V=1"},
    {"R1.L = 0x8001; R2 = -32 (X); R3.L = LSHIFT R1.L BY R2.L; R4.L = ASHIFT R1.L BY R2.L;",
     "R3=0 R4=0xFFFF AN=1 AZ=0"},
    {"R1.L = 0x4001; R1.H = 0x8001; R2 = -1 (X); R3 = LSHIFT R1 BY R2.L (V); R4 = ASHIFT R1 BY "
     "R2.L (V); R5 = R1 << 1 (V, S); R6 = R1 >>> 1 (V, S); R2 = 1 (X); R7 = ASHIFT R1 BY R2.L (V, "
     "S);",
     "R3=0x40002000 R4=0xC0002000 R5=0x80007FFF R6=0xC0002000 R7=0x80007FFF V=1"},
    // words
    {"R1 = [P1]; R2 = R1 << 1 (S);", "R2=0x7FFFFFFF V=1"},
    {"R3 = -1 (X); R4 = 4 (X); R5 = ASHIFT R3 BY R4.L (S);", "R5=-16 V=0"},
    {"R1 = [P1]; R4 = 4 (X); R6 = ASHIFT R1 BY R4.L (S);", "R6=0x7FFFFFFF V=1"},
    // fields: 4 bits to position 8
    {"R1 = -1 (X); R2.H = 5; R2.L = 0x0804; R3 = DEPOSIT(R1, R2); R2.H = 9; R5 = 0x55 (X); R4 = "
     "DEPOSIT(R5, R2) (X);",
     "R3=0xFFFFF5FF R4=0xFFFFF955"},
    {"R1 = 2 (X); R2 = 1 (X); BITMUX(R1, R2, A0) (ASR);", "A0=-549755813888 R1=1 R2=0"},
    {"R1 = 1 (X); R1 <<= 31; R2 = R1; BITMUX(R1, R2, A0) (ASL);", "A0=3 R1=0 R2=0"},
    // parity
    {"R1.L = 5; R1.H = 1; R2.L = 2; A0 = R1.L * R1.H (IS); A1 = R2.L * R1.H (IS); R2 = 4 (X); R3.L "
     "= CC = BXOR(A0, R2); R4.L = CC = BXORSHIFT(A0, R2); R5.L = CC = BXOR(A0, A1, CC); A0 = "
     "BXORSHIFT(A0, A1, CC);",
     "R3=1 R4=0 R5=1 A0=20 CC=1"},
    // exponents
    {"R1.L = 1; R1.H = 0xFFFF; R2.L = SIGNBITS R1.L; R3.L = SIGNBITS R1.H;", "R2=14 R3=15"},
    {"R1.L = 1; R1.H = -1; A0 = R1.L * R1.L (IS); A1 = R1.L * R1.H (IS); R2.L = SIGNBITS A0; R3.L "
     "= SIGNBITS A1;",
     "R2=30 R3=31"},
    {"R1 = 1 (X); R2 = 10 (X); R3.L = EXPADJ(R1, R2.L); R2 = 31 (X); R4.L = EXPADJ(R1, R2.L); R2 = "
     "15 (X); R5.L = EXPADJ(R1.L, R2.L);",
     "R3=10 R4=30 R5=14"},
    {"R1.L = 0x0100; R1.H = 1; R2 = 15 (X); R3.L = EXPADJ(R1, R2.L) (V);", "R3=6"},
};

constexpr Meaning kFlowMeanings[] = {
    {"JUMP.S .Lx; R1 = 1 (X); .Lx: R2 = 2 (X);", "R1=0 R2=2"},
    {"JUMP.L .Lx; R1 = 1 (X); .Lx: R2 = 2 (X);", "R1=0 R2=2"},
    {"JUMP .Lx; R1 = 1 (X); .Lx: R2 = 2 (X);", "R1=0 R2=2"},
    {"CC = R0 == R0; IF CC JUMP .Lx; R1 = 1 (X); .Lx: IF !CC JUMP .Ly; R2 = 2 (X); .Ly: NOP;",
     "R1=0 R2=2"},
    {"CC = R0 == R0; IF CC JUMP .Lx (BP); R1 = 1 (X); .Lx: IF !CC JUMP .Ly (BP); R2 = 2 (X); .Ly: "
     "NOP;",
     "R1=0 R2=2"},
    {"CALL _five; R2 = R1; P3.L = _five; P3.H = _five; CALL (P3); R3 = R1;", "R2=5 R3=10"},
    {"P3.L = _away; P3.H = _away; JUMP (P3); R1 = 1 (X);", "R1=0 R2=9"},
    {"P3 = 3 (X); LSETUP (.La, .La) LC0 = P3; .La: R1 += 1; LSETUP (.Lb, .Lb) LC1 = P3; .Lb: R2 += "
     "1;",
     "R1=3 R2=3"},
    {"P3 = 7 (X); LSETUP (.La, .La) LC0 = P3 >> 1; .La: R1 += 1; LSETUP (.Lb, .Lb) LC1 = P3 >> 1; "
     ".Lb: R2 += 1;",
     "R1=3 R2=3"},
    {"R3 = 4 (X); LC0 = R3; LC1 = R3; LSETUP (.La, .La) LC0; .La: R1 += 1; LSETUP (.Lb, .Lb) LC1; "
     ".Lb: R2 += 1;",
     "R1=4 R2=4"},
    {"P3 = 3 (X); P4 = 2 (X); LSETUP (.La, .Lb) LC0 = P4; .La: R1 += 1; LSETUP (.Lc, .Lb) LC1 = "
     "P3; .Lc: R2 += 1; .Lb: R3 += 1;",
     "R1=2 R2=6 R3=6"},
    // RAISE 7 waits until STI lets it in; its handler adds 1 and returns
    {"P3.L = 0x201C; P3.H = 0xFFE0; R1.L = _handler; R1.H = _handler; [P3] = R1; RAISE 7; R2 = R7; "
     "R3 = 0x80; STI R3; CSYNC; "
     "CLI R4; RAISE 7; SSYNC; R5 = R7; STI R4; NOP;",
     "R2=0 R4=0x9F R5=1 R7=2"},
    {"P3.L = 0x200C; P3.H = 0xFFE0; R1.L = _exception; R1.H = _exception; [P3] = R1; EXCPT 5; R2 = "
     "R7;",
     "R2=100 R1=5"},
};

constexpr const char* kHelpers =
    ".type _five, @function\n_five: R1 += 5; RTS;\n.size _five, .-_five\n"
    ".type _away, @function\n_away: R2 = 9 (X); IDLE; RTS;\n.size _away, .-_away\n"
    ".type _handler, @function\n_handler: R7 += 1; RTI;\n.size _handler, .-_handler\n"
    ".type _exception, @function\n_exception: R7 = 100; R1 = SEQSTAT; RTX;\n.size _exception, "
    ".-_exception\n"
    ".data\n.align 4\n.type _buffer, @object\n_buffer: .byte4 0x84838281, 0x11223344, 0x7FFFFFFF, "
    "0xFFFF8000\n.space 48\n"
    ".size _buffer, 64\n";

std::string text_of(const Meaning& meaning) {
  return program(std::string("P0.L = _buffer; P0.H = _buffer; I0 = P0; P2 = 4 (X); M0 = P2; P1 = "
                             "P0 + P2; P1 = P1 + P2; "
                             "I1 = P1;\n") +
                     meaning.code,
                 kHelpers);
}

class Machine {
 public:
  explicit Machine(const Meaning& meaning) : harness_(text_of(meaning)) {
    harness_.run();
    for (const ir::PlacedObject& object : harness_.image().objects) {
      if (object.name == "buffer") {
        buffer_ = object.address;
      }
    }
  }

  void expect(const std::string& expectation) {
    const std::size_t equals = expectation.find('=');
    const std::string name = expectation.substr(0, equals);
    EXPECT_EQ(actual(name), number(expectation.substr(equals + 1))) << expectation;
  }

 private:
  std::int64_t number(const std::string& text) const {
    if (text.starts_with('b')) {
      return static_cast<std::int32_t>(
          buffer_ + static_cast<Address>(text.size() > 1 ? std::stoi(text.substr(1)) : 0));
    }
    const std::int64_t value = std::stoll(text, nullptr, 0);
    return value > INT32_MAX ? value - (std::int64_t{1} << 32) : value;
  }
  std::int64_t actual(const std::string& name) {
    const isa::ExecutionState& s = harness_.core().state();
    if (name.starts_with('[')) {
      std::int32_t word = 0;
      std::memcpy(&word,
                  harness_.memory()
                      .view_bytes(buffer_ + static_cast<Address>(std::stoi(name.substr(1))), 4)
                      .data(),
                  4);
      return word;
    }
    const std::map<std::string, std::int64_t> flags = {{"CC", s.cc},
                                                       {"AZ", s.az},
                                                       {"AN", s.an},
                                                       {"AC0", s.ac0},
                                                       {"V", s.v},
                                                       {"A0", s.accumulator[0]},
                                                       {"A1", s.accumulator[1]}};
    const auto flag = flags.find(name);
    return flag != flags.end()
               ? flag->second
               : static_cast<std::int32_t>(s.reg[isa::register_by_name(name).value()]);
  }

  CoreHarness harness_;
  Address buffer_ = 0;
};

class Meanings : public testing::TestWithParam<Meaning> {};

TEST_P(Meanings, ResultsAreAsWorkedByHand) {
  SCOPED_TRACE(GetParam().code);
  Machine machine(GetParam());
  std::istringstream expectations(GetParam().expected);
  for (std::string expectation; expectations >> expectation;) {
    machine.expect(expectation);
  }
}

INSTANTIATE_TEST_SUITE_P(Memory, Meanings, testing::ValuesIn(kMemory));
INSTANTIATE_TEST_SUITE_P(Moves, Meanings, testing::ValuesIn(kMoves));
INSTANTIATE_TEST_SUITE_P(Arithmetic, Meanings, testing::ValuesIn(kArithmetic));
INSTANTIATE_TEST_SUITE_P(Dsp, Meanings, testing::ValuesIn(kDsp));
INSTANTIATE_TEST_SUITE_P(Shifter, Meanings, testing::ValuesIn(kShifter));
INSTANTIATE_TEST_SUITE_P(Flow, Meanings, testing::ValuesIn(kFlowMeanings));

}  // namespace
}  // namespace finback::core
