/* Pairs of 16-bit fractions. Sums and differences saturate. An amount of a shift counts with its
 * low six bits (-32 to 31), as the instruction takes it; the _clip functions take any. */
#ifndef FR2X16_H
#define FR2X16_H

#include <i2x16.h>

FINBACK_INLINE fract2x16 compose_fr2x16(fract16 high, fract16 low) {
  return compose_2x16(high, low);
}
FINBACK_INLINE fract16 high_of_fr2x16(fract2x16 a) { return high_of_2x16(a); }
FINBACK_INLINE fract16 low_of_fr2x16(fract2x16 a) { return low_of_2x16(a); }

FINBACK_INLINE fract2x16 add_fr2x16(fract2x16 a, fract2x16 b) {
  return __builtin_bfin_add_fr2x16(a, b);
}
FINBACK_INLINE fract2x16 sub_fr2x16(fract2x16 a, fract2x16 b) {
  return __builtin_bfin_sub_fr2x16(a, b);
}
FINBACK_INLINE fract2x16 mult_fr2x16(fract2x16 a, fract2x16 b) {
  return __builtin_bfin_mult_fr2x16(a, b);
}
FINBACK_INLINE fract2x16 multr_fr2x16(fract2x16 a, fract2x16 b) {
  return __builtin_bfin_multr_fr2x16(a, b);
}
FINBACK_INLINE fract2x16 negate_fr2x16(fract2x16 a) { return __builtin_bfin_negate_fr2x16(a); }
FINBACK_INLINE fract2x16 abs_fr2x16(fract2x16 a) { return __builtin_bfin_abs_fr2x16(a); }
FINBACK_INLINE fract2x16 min_fr2x16(fract2x16 a, fract2x16 b) {
  return __builtin_bfin_min_fr2x16(a, b);
}
FINBACK_INLINE fract2x16 max_fr2x16(fract2x16 a, fract2x16 b) {
  return __builtin_bfin_max_fr2x16(a, b);
}

/* The high halves added and the low ones subtracted, and the other way round. */
FINBACK_INLINE fract2x16 add_as_fr2x16(fract2x16 a, fract2x16 b) {
  return __builtin_bfin_dspaddsubsat(a, b);
}
FINBACK_INLINE fract2x16 add_sa_fr2x16(fract2x16 a, fract2x16 b) {
  return __builtin_bfin_dspsubaddsat(a, b);
}

FINBACK_INLINE fract16 sum_fr2x16(fract2x16 a) { return __builtin_bfin_sum_fr2x16(a); }
FINBACK_INLINE fract16 diff_hl_fr2x16(fract2x16 a) { return __builtin_bfin_diff_hl_fr2x16(a); }
FINBACK_INLINE fract16 diff_lh_fr2x16(fract2x16 a) { return __builtin_bfin_diff_lh_fr2x16(a); }

/* Products of integers, not doubled, as with the vendor. */
FINBACK_INLINE fract32 mult_ll_fr2x16(fract2x16 a, fract2x16 b) { return mult_ll_i2x16(a, b); }
FINBACK_INLINE fract32 mult_hl_fr2x16(fract2x16 a, fract2x16 b) { return mult_hl_i2x16(a, b); }
FINBACK_INLINE fract32 mult_lh_fr2x16(fract2x16 a, fract2x16 b) { return mult_lh_i2x16(a, b); }
FINBACK_INLINE fract32 mult_hh_fr2x16(fract2x16 a, fract2x16 b) { return mult_hh_i2x16(a, b); }

/* To the left and saturated, to the right with the sign; the other way when negative. shrl: to the
 * right with zeros. */
FINBACK_INLINE fract2x16 shl_fr2x16(fract2x16 a, short left) {
  return __builtin_bfin_shl_fr2x16(a, left);
}
FINBACK_INLINE fract2x16 shr_fr2x16(fract2x16 a, short right) {
  return __builtin_bfin_shl_fr2x16(a, (short)-right);
}
FINBACK_INLINE fract2x16 shrl_fr2x16(fract2x16 a, short right) {
  return __builtin_bfin_lshl_fr2x16(a, (short)-right);
}

FINBACK_INLINE short finback_clipped(short amount, short least, short most) {
  return amount < least ? least : amount > most ? most : amount;
}
FINBACK_INLINE fract2x16 shl_fr2x16_clip(fract2x16 a, short left) {
  return shl_fr2x16(a, finback_clipped(left, -16, 16));
}
FINBACK_INLINE fract2x16 shr_fr2x16_clip(fract2x16 a, short right) {
  return shr_fr2x16(a, finback_clipped(right, -16, 16));
}
FINBACK_INLINE fract2x16 shrl_fr2x16_clip(fract2x16 a, short right) {
  return shrl_fr2x16(a, finback_clipped(right, -16, 16));
}

#endif
