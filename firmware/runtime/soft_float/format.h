/* The bits of a binary floating-point number of IEEE 754, single or double: a unit sets FLOAT_BITS
 * to 32 or 64 and includes what it needs. Rounding is to the nearest, ties to even, the only way
 * there is; no flags are raised and nothing traps. What is not a number stays so, made quiet, with
 * its payload. */
#ifndef FINBACK_SOFT_FLOAT_FORMAT_H
#define FINBACK_SOFT_FLOAT_FORMAT_H

#include <stdint.h>

#include "../machine.h"

#if FLOAT_BITS == 32
typedef float real_t;
typedef uint32_t bits_t;
#define FRACTION_BITS 23
#define EXPONENT_MAX 255
#else
typedef double real_t;
typedef uint64_t bits_t;
#define FRACTION_BITS 52
#define EXPONENT_MAX 2047
#endif

#define EXPONENT_BIAS (EXPONENT_MAX >> 1)
#define SIGN_BIT ((bits_t)1 << (FLOAT_BITS - 1))
#define HIDDEN_BIT ((bits_t)1 << FRACTION_BITS)
#define INFINITE_BITS ((bits_t)EXPONENT_MAX << FRACTION_BITS)
#define QUIET_BIT (HIDDEN_BIT >> 1)
#define NO_NUMBER (INFINITE_BITS | QUIET_BIT)
/* Significands on their way have three bits more: half, quarter, and whether any is below. */
#define EXTRA_BITS 3

/* What the compiler shall keep off the straight way. */
#define RARELY(condition) (__builtin_expect((condition), 0) != 0)

static inline bits_t bits_of(real_t value) {
  union {
    real_t value;
    bits_t bits;
  } both = {value};
  return both.bits;
}

static inline real_t float_of(bits_t bits) {
  union {
    bits_t bits;
    real_t value;
  } both = {bits};
  return both.value;
}

static inline bits_t magnitude_of(bits_t bits) { return bits & ~SIGN_BIT; }

static inline bits_t sign_of(bits_t bits) { return bits & SIGN_BIT; }

static inline int exponent_of(bits_t magnitude) { return (int)(magnitude >> FRACTION_BITS); }

/* Zero, infinite or no number: what the ordinary way does not handle. */
static inline int is_special(bits_t magnitude) {
  return RARELY(magnitude - 1 >= INFINITE_BITS - 1);
}

static inline int leading_zeros(bits_t bits) {
#if FLOAT_BITS == 32
  return leading_zeros_32(bits);
#else
  return leading_zeros_64(bits);
#endif
}

/* Shifts right; the lowest bit of the result says as well whether a bit was lost. */
static inline bits_t shift_right_sticky(bits_t bits, int places) {
  if (RARELY(places >= FLOAT_BITS)) {
    return bits != 0;
  }
  bits_t shifted = bits >> places;
  return shifted | (shifted << places != bits);
}

/* The significand of a magnitude that is not special, with its hidden bit in place; brings
 * subnormal ones there and lowers their exponent below 1. */
static inline bits_t normalised_significand(bits_t magnitude, int* exponent) {
  *exponent = exponent_of(magnitude);
  if (RARELY(*exponent == 0)) {
    int shift = leading_zeros(magnitude) - (FLOAT_BITS - 1 - FRACTION_BITS);
    *exponent = 1 - shift;
    return magnitude << shift;
  }
  return (magnitude & (HIDDEN_BIT - 1)) | HIDDEN_BIT;
}

/* Rounds and packs a significand with its hidden bit at FRACTION_BITS + EXTRA_BITS (lower only
 * where the exponent is 1). Too small an exponent gives a subnormal number, too large a one
 * infinity. */
static inline bits_t round_and_pack(bits_t sign, int exponent, bits_t significand) {
  if (RARELY(exponent >= EXPONENT_MAX)) {
    return sign | INFINITE_BITS;
  }
  if (RARELY(exponent <= 0)) {
    significand = shift_right_sticky(significand, 1 - exponent);
    exponent = 1;
  }
  /* The hidden bit itself adds one to the exponent; so does a carry out of the rounding. */
  bits_t packed = ((bits_t)(exponent - 1) << FRACTION_BITS) + (significand >> EXTRA_BITS);
  uint32_t extra = (uint32_t)significand & 7;
  return sign | (packed + ((extra + ((uint32_t)packed & 1) + 3) >> EXTRA_BITS));
}

#endif
