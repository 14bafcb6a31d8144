/* Quotient. */
#ifndef FINBACK_SOFT_FLOAT_DIVIDE_H
#define FINBACK_SOFT_FLOAT_DIVIDE_H

#include "format.h"

static inline bits_t divide_special(bits_t sign, bits_t a, bits_t b) {
  bits_t a_magnitude = magnitude_of(a);
  bits_t b_magnitude = magnitude_of(b);
  if (a_magnitude > INFINITE_BITS) {
    return a | QUIET_BIT;
  }
  if (b_magnitude > INFINITE_BITS) {
    return b | QUIET_BIT;
  }
  if (a_magnitude == b_magnitude) {
    return NO_NUMBER; /* 0 / 0, infinite / infinite */
  }
  return a_magnitude == INFINITE_BITS || b_magnitude == 0 ? sign | INFINITE_BITS : sign;
}

/* The quotient's FRACTION_BITS + EXTRA_BITS bits behind the first, of normalised significands. */
#if FLOAT_BITS == 32
static inline bits_t further_quotient(bits_t* remainder, bits_t divisor) {
  return divide_steps(remainder, 0, divisor, FRACTION_BITS + EXTRA_BITS);
}
#else
/* Some bits of it, at most 28. The upper 31 bits of the divisor, plus one, give them, or a little
 * less: the missing part is below 2^-30 of the whole, so that one or two is all that can be short.
 */
static inline bits_t quotient_digit(bits_t* remainder, bits_t divisor, int bits) {
  const int lower = FRACTION_BITS + 1 - 31;
  uint32_t upper = (uint32_t)(*remainder >> lower);
  uint32_t next = (uint32_t)*remainder << (32 - lower);
  uint32_t digit = divide_steps(&upper, next, (uint32_t)(divisor >> lower) + 1, bits);
  /* Correct in 64 bits, though not all of the products' bits are there. */
  *remainder = (*remainder << bits) - digit * divisor;
  while (*remainder >= divisor) {
    *remainder -= divisor;
    ++digit;
  }
  return digit;
}

static inline bits_t further_quotient(bits_t* remainder, bits_t divisor) {
  bits_t first = quotient_digit(remainder, divisor, 28);
  return first << 27 | quotient_digit(remainder, divisor, FRACTION_BITS + EXTRA_BITS - 28);
}
#endif

static inline bits_t divide_bits(bits_t a, bits_t b) {
  bits_t sign = sign_of(a ^ b);
  if (is_special(magnitude_of(a)) || is_special(magnitude_of(b))) {
    return divide_special(sign, a, b);
  }
  int a_exponent;
  int b_exponent;
  bits_t remainder = normalised_significand(magnitude_of(a), &a_exponent);
  bits_t divisor = normalised_significand(magnitude_of(b), &b_exponent);
  int exponent = a_exponent - b_exponent + EXPONENT_BIAS;
  if (remainder < divisor) {
    remainder <<= 1;
    --exponent;
  }
  remainder -= divisor; /* the quotient's first bit is 1 */
  bits_t quotient = HIDDEN_BIT << EXTRA_BITS | further_quotient(&remainder, divisor);
  return round_and_pack(sign, exponent, quotient | (remainder != 0));
}

#endif
