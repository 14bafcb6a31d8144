/* From integers, rounded where they have more bits than a significand. */
#ifndef FINBACK_SOFT_FLOAT_FROM_INTEGER_H
#define FINBACK_SOFT_FLOAT_FROM_INTEGER_H

#include "format.h"

/* The number nearest to a magnitude, with a sign. */
static inline bits_t from_magnitude(bits_t sign, bits_t magnitude) {
  if (magnitude == 0) {
    return 0;
  }
  int shift = leading_zeros(magnitude);
  bits_t significand = magnitude << shift;
  const int spare = FLOAT_BITS - 1 - FRACTION_BITS - EXTRA_BITS;
  bits_t lost = significand & (((bits_t)1 << spare) - 1);
  return round_and_pack(sign, EXPONENT_BIAS + FLOAT_BITS - 1 - shift,
                        significand >> spare | (lost != 0));
}

static inline bits_t from_uint32(bits_t sign, uint32_t magnitude) {
#if FLOAT_BITS == 32
  return from_magnitude(sign, magnitude);
#else
  if (magnitude == 0) {
    return 0;
  }
  /* Always exact: the first bit goes to the hidden one's place and adds one to the exponent. */
  int shift = leading_zeros_32(magnitude);
  bits_t significand = (bits_t)(magnitude << shift) << (FRACTION_BITS - 31);
  return sign | (((bits_t)(EXPONENT_BIAS + 30 - shift) << FRACTION_BITS) + significand);
#endif
}

static inline bits_t from_uint64(bits_t sign, uint64_t magnitude) {
#if FLOAT_BITS == 32
  uint32_t high = (uint32_t)(magnitude >> 32);
  if (high == 0) {
    return from_magnitude(sign, (uint32_t)magnitude);
  }
  /* The upper 32 significant bits, the lowest of which speaks for all below. */
  int shift = leading_zeros_32(high);
  magnitude <<= shift;
  bits_t upper = (uint32_t)(magnitude >> 32) | ((uint32_t)magnitude != 0);
  return from_magnitude(sign, upper) + ((bits_t)(32 - shift) << FRACTION_BITS);
#else
  return from_magnitude(sign, magnitude);
#endif
}

static inline bits_t from_int32(int32_t value) {
  return value < 0 ? from_uint32(SIGN_BIT, 0u - (uint32_t)value) : from_uint32(0, (uint32_t)value);
}

static inline bits_t from_int64(int64_t value) {
  return value < 0 ? from_uint64(SIGN_BIT, 0u - (uint64_t)value) : from_uint64(0, (uint64_t)value);
}

#endif
