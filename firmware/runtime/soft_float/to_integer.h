/* To integers, towards zero. What does not fit, C leaves open: here it becomes the nearest that
 * does, and what is no number becomes 0. */
#ifndef FINBACK_SOFT_FLOAT_TO_INTEGER_H
#define FINBACK_SOFT_FLOAT_TO_INTEGER_H

#include "format.h"

/* The integer part of a magnitude below 2^32; of others, what is left of it. */
static inline uint32_t whole_32(bits_t magnitude) {
  int power = exponent_of(magnitude) - EXPONENT_BIAS;
  if (power < 0) {
    return 0;
  }
  bits_t significand = (magnitude & (HIDDEN_BIT - 1)) | HIDDEN_BIT;
#if FLOAT_BITS == 32
  if (power > FRACTION_BITS) {
    return significand << (power - FRACTION_BITS);
  }
#endif
  return (uint32_t)(significand >> (FRACTION_BITS - power));
}

/* The same below 2^64. */
static inline uint64_t whole_64(bits_t magnitude) {
  int power = exponent_of(magnitude) - EXPONENT_BIAS;
  if (power < 0) {
    return 0;
  }
  uint64_t significand = (magnitude & (HIDDEN_BIT - 1)) | HIDDEN_BIT;
  return power > FRACTION_BITS ? significand << (power - FRACTION_BITS)
                               : significand >> (FRACTION_BITS - power);
}

/* The bits of 2^power. */
static inline bits_t power_of_two(int power) {
  return (bits_t)(EXPONENT_BIAS + power) << FRACTION_BITS;
}

static inline int32_t to_int32(bits_t bits) {
  bits_t magnitude = magnitude_of(bits);
  int negative = sign_of(bits) != 0;
  if (magnitude >= power_of_two(31)) {
    return magnitude > INFINITE_BITS ? 0 : negative ? INT32_MIN : INT32_MAX;
  }
  int32_t whole = (int32_t)whole_32(magnitude);
  return negative ? -whole : whole;
}

static inline uint32_t to_uint32(bits_t bits) {
  if (sign_of(bits) != 0 || bits > INFINITE_BITS) {
    return 0;
  }
  return bits >= power_of_two(32) ? UINT32_MAX : whole_32(bits);
}

static inline int64_t to_int64(bits_t bits) {
  bits_t magnitude = magnitude_of(bits);
  int negative = sign_of(bits) != 0;
  if (magnitude >= power_of_two(63)) {
    return magnitude > INFINITE_BITS ? 0 : negative ? INT64_MIN : INT64_MAX;
  }
  int64_t whole = (int64_t)whole_64(magnitude);
  return negative ? -whole : whole;
}

static inline uint64_t to_uint64(bits_t bits) {
  if (sign_of(bits) != 0 || bits > INFINITE_BITS) {
    return 0;
  }
  return bits >= power_of_two(64) ? UINT64_MAX : whole_64(bits);
}

#endif
