/* Product. */
#ifndef FINBACK_SOFT_FLOAT_MULTIPLY_H
#define FINBACK_SOFT_FLOAT_MULTIPLY_H

#include "format.h"

/* The upper half of a product; its lowest bit says as well whether the lower half has any. */
static inline bits_t upper_product_sticky(bits_t a, bits_t b) {
#if FLOAT_BITS == 32
  uint64_t product = (uint64_t)a * b;
  return (uint32_t)(product >> 32) | ((uint32_t)product != 0);
#else
  uint32_t a_low = (uint32_t)a;
  uint32_t a_high = (uint32_t)(a >> 32);
  uint32_t b_low = (uint32_t)b;
  uint32_t b_high = (uint32_t)(b >> 32);
  uint64_t low = (uint64_t)a_low * b_low;
  uint64_t one = (uint64_t)a_high * b_low + (low >> 32);
  uint64_t other = (uint64_t)a_low * b_high + (uint32_t)one;
  uint64_t high = (uint64_t)a_high * b_high + (one >> 32) + (other >> 32);
  return high | (((uint32_t)low | (uint32_t)other) != 0);
#endif
}

static inline bits_t multiply_special(bits_t sign, bits_t a, bits_t b) {
  bits_t a_magnitude = magnitude_of(a);
  bits_t b_magnitude = magnitude_of(b);
  if (a_magnitude > INFINITE_BITS) {
    return a | QUIET_BIT;
  }
  if (b_magnitude > INFINITE_BITS) {
    return b | QUIET_BIT;
  }
  if (a_magnitude == INFINITE_BITS || b_magnitude == INFINITE_BITS) {
    return a_magnitude == 0 || b_magnitude == 0 ? NO_NUMBER : sign | INFINITE_BITS;
  }
  return sign; /* a zero */
}

static inline bits_t multiply_bits(bits_t a, bits_t b) {
  bits_t sign = sign_of(a ^ b);
  if (is_special(magnitude_of(a)) || is_special(magnitude_of(b))) {
    return multiply_special(sign, a, b);
  }
  int a_exponent;
  int b_exponent;
  bits_t a_significand = normalised_significand(magnitude_of(a), &a_exponent);
  bits_t b_significand = normalised_significand(magnitude_of(b), &b_exponent);
  int exponent = a_exponent + b_exponent - EXPONENT_BIAS;
  /* Shifted so that the hidden bit comes out in its place, or one above it. */
  bits_t product = upper_product_sticky(a_significand << (FLOAT_BITS - 1 - FRACTION_BITS),
                                        b_significand << (EXTRA_BITS + 1));
  if ((product & HIDDEN_BIT << (EXTRA_BITS + 1)) != 0) {
    product = product >> 1 | (product & 1);
    ++exponent;
  }
  return round_and_pack(sign, exponent, product);
}

#endif
