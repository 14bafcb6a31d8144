/* What the processor has instructions for and C has no words: a few steps in assembly, and the same
 * in C for whoever else compiles the runtime. */
#ifndef FINBACK_RUNTIME_MACHINE_H
#define FINBACK_RUNTIME_MACHINE_H

#include <stdint.h>

/* Zeros before the first bit of a word; the word is not 0. */
static inline int leading_zeros_32(uint32_t word) {
#ifdef __FINBACK__
  if ((int32_t)word < 0) {
    return 0;
  }
  int signs;
  __asm__("%h0 = SIGNBITS %1; %0 = %h0 (X);" : "=d"(signs) : "d"(word));
  return signs + 1;
#else
  return __builtin_clz(word);
#endif
}

static inline int leading_zeros_64(uint64_t bits) {
  uint32_t high = (uint32_t)(bits >> 32);
  return high != 0 ? leading_zeros_32(high) : 32 + leading_zeros_32((uint32_t)bits);
}

/* So many steps, 1 to 32, of a division by hand: each brings the dividend's next bit, the highest
 * first, down behind the remainder, and gives a bit of the quotient, which is returned. The
 * dividend's bits beyond the steps are 0; the remainder is less than the divisor, which is at most
 * 2^31. */
static inline uint32_t divide_steps(uint32_t* remainder, uint32_t dividend, uint32_t divisor,
                                    int steps) {
#ifdef __FINBACK__
  uint32_t rest = *remainder;
  uint32_t difference;
  /* The quotient's bits go into the dividend from below as its own leave above. */
  __asm__(
      "CC = %1 < %1;\n"
      "LSETUP (.Lstep%=, .Lstep_end%=) LC0 = %4;\n"
      ".Lstep%=: %0 = ROT %0 BY 1; %1 = ROT %1 BY 1; CC = %3 <= %1 (IU); %2 = %1 - %3;\n"
      ".Lstep_end%=: IF CC %1 = %2;\n"
      "%0 = ROT %0 BY 1;"
      : "+d"(dividend), "+d"(rest), "=&d"(difference)
      : "d"(divisor), "a"(steps)
      : "LC0");
  *remainder = rest;
  return dividend;
#else
  uint32_t quotient = 0;
  for (; steps != 0; --steps) {
    *remainder = *remainder << 1 | dividend >> 31;
    dividend <<= 1;
    quotient <<= 1;
    if (*remainder >= divisor) {
      *remainder -= divisor;
      quotient |= 1;
    }
  }
  return quotient;
#endif
}

#endif
