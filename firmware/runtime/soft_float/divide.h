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
  /* The quotient's first bit is 1; each further step gives one more. */
  remainder -= divisor;
  bits_t quotient = 1;
  for (int bit = 0; bit < FRACTION_BITS + EXTRA_BITS; ++bit) {
    remainder <<= 1;
    quotient <<= 1;
    if (remainder >= divisor) {
      remainder -= divisor;
      quotient |= 1;
    }
  }
  return round_and_pack(sign, exponent, quotient | (remainder != 0));
}

#endif
