/* Pairs of 16-bit integers. Sums wrap; products of mult_i2x16 saturate, as the instruction does. */
#ifndef I2X16_H
#define I2X16_H

#include <builtins.h>

typedef int int2x16;

FINBACK_INLINE int compose_2x16(short high, short low) {
  return __builtin_bfin_compose_2x16(high, low);
}
FINBACK_INLINE short high_of_2x16(int a) { return (short)(a >> 16); }
FINBACK_INLINE short low_of_2x16(int a) { return (short)a; }

FINBACK_INLINE int2x16 compose_i2x16(short high, short low) { return compose_2x16(high, low); }
FINBACK_INLINE short high_of_i2x16(int2x16 a) { return high_of_2x16(a); }
FINBACK_INLINE short low_of_i2x16(int2x16 a) { return low_of_2x16(a); }

FINBACK_INLINE int2x16 add_i2x16(int2x16 a, int2x16 b) { return __builtin_bfin_add_i2x16(a, b); }
FINBACK_INLINE int2x16 sub_i2x16(int2x16 a, int2x16 b) { return __builtin_bfin_sub_i2x16(a, b); }
FINBACK_INLINE int2x16 mult_i2x16(int2x16 a, int2x16 b) { return __builtin_bfin_mult_i2x16(a, b); }
FINBACK_INLINE int2x16 min_i2x16(int2x16 a, int2x16 b) { return __builtin_bfin_min_fr2x16(a, b); }
FINBACK_INLINE int2x16 max_i2x16(int2x16 a, int2x16 b) { return __builtin_bfin_max_fr2x16(a, b); }

/* Products of a's and b's halves, by their letters. */
FINBACK_INLINE int mult_ll_i2x16(int2x16 a, int2x16 b) { return (short)a * (short)b; }
FINBACK_INLINE int mult_hl_i2x16(int2x16 a, int2x16 b) { return (a >> 16) * (short)b; }
FINBACK_INLINE int mult_lh_i2x16(int2x16 a, int2x16 b) { return (short)a * (b >> 16); }
FINBACK_INLINE int mult_hh_i2x16(int2x16 a, int2x16 b) { return (a >> 16) * (b >> 16); }

#endif
