/* Sum and difference. */
#ifndef FINBACK_SOFT_FLOAT_ADD_H
#define FINBACK_SOFT_FLOAT_ADD_H

#include "format.h"

static inline bits_t add_special(bits_t a, bits_t b) {
  bits_t a_magnitude = magnitude_of(a);
  bits_t b_magnitude = magnitude_of(b);
  if (a_magnitude > INFINITE_BITS) {
    return a | QUIET_BIT;
  }
  if (b_magnitude > INFINITE_BITS) {
    return b | QUIET_BIT;
  }
  if (a_magnitude == INFINITE_BITS) {
    return b_magnitude == INFINITE_BITS && a != b ? NO_NUMBER : a;
  }
  if (b_magnitude == INFINITE_BITS || a_magnitude == 0) {
    return (a_magnitude | b_magnitude) == 0 ? a & b : b; /* -0 only out of two */
  }
  return a;
}

/* The significand in its place with the extra bits; subnormal ones have the exponent 1. */
static inline bits_t significand_to_add(bits_t magnitude, int* exponent) {
  *exponent = exponent_of(magnitude);
  bits_t significand = magnitude & (HIDDEN_BIT - 1);
  if (RARELY(*exponent == 0)) {
    *exponent = 1;
  } else {
    significand |= HIDDEN_BIT;
  }
  return significand << EXTRA_BITS;
}

static inline bits_t add_bits(bits_t a, bits_t b) {
  if (is_special(magnitude_of(a)) || is_special(magnitude_of(b))) {
    return add_special(a, b);
  }
  if (magnitude_of(a) < magnitude_of(b)) {
    bits_t larger = b;
    b = a;
    a = larger;
  }
  int exponent;
  int b_exponent;
  bits_t sum = significand_to_add(magnitude_of(a), &exponent);
  bits_t smaller = significand_to_add(magnitude_of(b), &b_exponent);
  smaller = shift_right_sticky(smaller, exponent - b_exponent);
  if (sign_of(a ^ b) == 0) {
    sum += smaller;
    if ((sum & HIDDEN_BIT << (EXTRA_BITS + 1)) != 0) {
      sum = sum >> 1 | (sum & 1);
      ++exponent;
    }
    return round_and_pack(sign_of(a), exponent, sum);
  }
  sum -= smaller;
  if (sum == 0) {
    return 0;
  }
  if ((sum & HIDDEN_BIT << EXTRA_BITS) == 0) {
    int shift = leading_zeros(sum) - (FLOAT_BITS - 1 - FRACTION_BITS - EXTRA_BITS);
    sum <<= shift;
    exponent -= shift;
  }
  return round_and_pack(sign_of(a), exponent, sum);
}

#endif
