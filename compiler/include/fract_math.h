/* Arithmetic of 16-bit and 32-bit fractions. Sums, differences and negations saturate. An amount of
 * a shift counts with its low six bits (-32 to 31), as the instruction takes it; the _clip
 * functions take any. */
#ifndef FRACT_MATH_H
#define FRACT_MATH_H

#include <fr2x16.h>

FINBACK_INLINE fract16 add_fr1x16(fract16 a, fract16 b) { return __builtin_bfin_add_fr1x16(a, b); }
FINBACK_INLINE fract16 sub_fr1x16(fract16 a, fract16 b) { return __builtin_bfin_sub_fr1x16(a, b); }
/* The product's high half: truncated, and (multr) rounded, a half to even unless RND_MOD is set. */
FINBACK_INLINE fract16 mult_fr1x16(fract16 a, fract16 b) {
  return __builtin_bfin_mult_fr1x16(a, b);
}
FINBACK_INLINE fract16 multr_fr1x16(fract16 a, fract16 b) {
  return __builtin_bfin_multr_fr1x16(a, b);
}
FINBACK_INLINE fract16 negate_fr1x16(fract16 a) { return __builtin_bfin_negate_fr1x16(a); }
FINBACK_INLINE fract16 abs_fr1x16(fract16 a) { return __builtin_bfin_abs_fr1x16(a); }
FINBACK_INLINE fract16 min_fr1x16(fract16 a, fract16 b) { return __builtin_bfin_min_fr1x16(a, b); }
FINBACK_INLINE fract16 max_fr1x16(fract16 a, fract16 b) { return __builtin_bfin_max_fr1x16(a, b); }
FINBACK_INLINE fract16 abs_fr16(fract16 a) { return abs_fr1x16(a); }
FINBACK_INLINE fract16 min_fr16(fract16 a, fract16 b) { return min_fr1x16(a, b); }
FINBACK_INLINE fract16 max_fr16(fract16 a, fract16 b) { return max_fr1x16(a, b); }
/* How far to the left until the value has no sign bit to spare; 15 for 0 and -1. */
FINBACK_INLINE int norm_fr1x16(fract16 a) { return __builtin_bfin_norm_fr1x16(a); }

FINBACK_INLINE fract16 shl_fr1x16(fract16 a, short left) {
  return __builtin_bfin_shl_fr1x16(a, left);
}
FINBACK_INLINE fract16 shr_fr1x16(fract16 a, short right) {
  return __builtin_bfin_shl_fr1x16(a, (short)-right);
}
FINBACK_INLINE fract16 shrl_fr1x16(fract16 a, short right) {
  return __builtin_bfin_lshl_fr1x16(a, (short)-right);
}
FINBACK_INLINE fract16 shl_fr1x16_clip(fract16 a, short left) {
  return shl_fr1x16(a, finback_clipped(left, -16, 16));
}
FINBACK_INLINE fract16 shr_fr1x16_clip(fract16 a, short right) {
  return shr_fr1x16(a, finback_clipped(right, -16, 16));
}
FINBACK_INLINE fract16 shrl_fr1x16_clip(fract16 a, short right) {
  return shrl_fr1x16(a, finback_clipped(right, -16, 16));
}

FINBACK_INLINE fract32 add_fr1x32(fract32 a, fract32 b) { return __builtin_bfin_add_fr1x32(a, b); }
FINBACK_INLINE fract32 sub_fr1x32(fract32 a, fract32 b) { return __builtin_bfin_sub_fr1x32(a, b); }
/* The whole product of two 16-bit fractions; -1 times -1 saturates. */
FINBACK_INLINE fract32 mult_fr1x32(fract16 a, fract16 b) {
  return __builtin_bfin_mult_fr1x32(a, b);
}
/* The product's high word: truncated, and (multr) rounded upwards at a half. All saturate, NS too.
 */
FINBACK_INLINE fract32 mult_fr1x32x32(fract32 a, fract32 b) {
  return __builtin_bfin_mult_fr1x32x32(a, b);
}
FINBACK_INLINE fract32 mult_fr1x32x32NS(fract32 a, fract32 b) {
  return __builtin_bfin_mult_fr1x32x32(a, b);
}
FINBACK_INLINE fract32 multr_fr1x32x32(fract32 a, fract32 b) {
  return __builtin_bfin_multr_fr1x32x32(a, b);
}
FINBACK_INLINE fract32 abs_fr1x32(fract32 a) { return __builtin_bfin_abs_fr1x32(a); }
FINBACK_INLINE fract32 negate_fr1x32(fract32 a) { return __builtin_bfin_negate_fr1x32(a); }
FINBACK_INLINE fract32 min_fr1x32(fract32 a, fract32 b) { return __builtin_bfin_min_fr1x32(a, b); }
FINBACK_INLINE fract32 max_fr1x32(fract32 a, fract32 b) { return __builtin_bfin_max_fr1x32(a, b); }
FINBACK_INLINE int norm_fr1x32(fract32 a) { return __builtin_bfin_norm_fr1x32(a); }

FINBACK_INLINE fract32 shl_fr1x32(fract32 a, short left) {
  return __builtin_bfin_shl_fr1x32(a, left);
}
FINBACK_INLINE fract32 shr_fr1x32(fract32 a, short right) {
  return __builtin_bfin_shl_fr1x32(a, (short)-right);
}
/* 31 places to the left saturate as 32 do, but for -1. */
FINBACK_INLINE fract32 shl_fr1x32_clip(fract32 a, short left) {
  return left > 31 ? shl_fr1x32(shl_fr1x32(a, 31), 1)
                   : shl_fr1x32(a, finback_clipped(left, -31, 31));
}
FINBACK_INLINE fract32 shr_fr1x32_clip(fract32 a, short right) {
  return shl_fr1x32_clip(a, (short)-finback_clipped(right, -32, 32));
}

/* A word as a half: the value itself where it fits, the nearest otherwise; the high half, rounded
 * upwards at a half, and truncated. */
FINBACK_INLINE fract16 sat_fr1x32(fract32 a) { return (fract16)(shl_fr1x32(a, 16) >> 16); }
FINBACK_INLINE fract16 round_fr1x32(fract32 a) { return __builtin_bfin_round_fr1x32(a); }
FINBACK_INLINE fract16 trunc_fr1x32(fract32 a) { return (fract16)(a >> 16); }

#endif
