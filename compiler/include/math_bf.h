/* Signal processing beside math.h: the smaller, the larger and the clipped of integers and
 * fractions, and counts of bits. */
#ifndef MATH_BF_H
#define MATH_BF_H

#include <fract_math.h>

FINBACK_INLINE int max(int a, int b) { return a > b ? a : b; }
FINBACK_INLINE int min(int a, int b) { return a < b ? a : b; }

/* a within -limit and limit. */
FINBACK_INLINE int clip(int a, int limit) { return min(max(a, -limit), limit); }
FINBACK_INLINE fract16 clip_fr16(fract16 a, fract16 limit) {
  return min_fr16(max_fr16(a, (fract16)-limit), limit);
}
FINBACK_INLINE int countones(int a) { return (int)__builtin_bfin_ones((unsigned)a); }

#endif
