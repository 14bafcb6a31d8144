/* Fractions of 16 bits: every function at the edges, and several in one expression. */
#include "fract_reference.h"

CHECK1(abs_fr1x16, fract16)
CHECK1(negate_fr1x16, fract16)
CHECK1(norm_fr1x16, fract16)
CHECK2(add_fr1x16, fract16, fract16)
CHECK2(sub_fr1x16, fract16, fract16)
CHECK2(mult_fr1x16, fract16, fract16)
CHECK2(multr_fr1x16, fract16, fract16)
CHECK2(mult_fr1x32, fract16, fract16)
CHECK2(min_fr1x16, fract16, fract16)
CHECK2(max_fr1x16, fract16, fract16)
CHECK_SHIFT(shl_fr1x16, fract16, -31, 31)
CHECK_SHIFT(shr_fr1x16, fract16, -31, 31)
CHECK_SHIFT(shrl_fr1x16, fract16, 0, 31)
CHECK_SHIFT(shl_fr1x16_clip, fract16, -100, 100)
CHECK_SHIFT(shr_fr1x16_clip, fract16, -100, 100)

/* Halves where they stand, and shifts by numbers. */
static __attribute__((noinline)) unsigned mixed(int a, int b) {
  const fract16 ah = high_of_fr2x16(a), bl = low_of_fr2x16(b), bh = high_of_fr2x16(b);
  unsigned sum = (unsigned)mult_fr1x16(ah, bl);
  sum = mix(sum, (unsigned)mult_fr1x16(bl, ah));
  sum = mix(sum, (unsigned)multr_fr1x16(ah, bh));
  sum = mix(sum, (unsigned)add_fr1x16(add_fr1x16(ah, bl), mult_fr1x16(bl, bl)));
  sum = mix(sum, (unsigned)sub_fr1x16(bl, ah));
  sum = mix(sum, (unsigned)mult_fr1x32(bh, ah));
  sum = mix(sum, (unsigned)norm_fr1x16(ah));
  sum = mix(sum, (unsigned)shl_fr1x16(ah, 3));
  sum = mix(sum, (unsigned)shl_fr1x16(bl, 15));
  sum = mix(sum, (unsigned)shl_fr1x16(bl, 16));
  sum = mix(sum, (unsigned)shr_fr1x16(bl, 4));
  sum = mix(sum, (unsigned)shr_fr1x16(bl, 15));
  sum = mix(sum, (unsigned)shr_fr1x16(bl, 16));
  sum = mix(sum, (unsigned)shr_fr1x16(bl, 0));
  sum = mix(sum, (unsigned)shrl_fr1x16(bl, 5));
  sum = mix(sum, (unsigned)shrl_fr1x16(bl, 16));
  return mix(sum, (unsigned)shl_fr1x16_clip(bl, 99));
}

/* What plain C says with comparisons. */
static __attribute__((noinline)) short limited_sum(short a, short b) {
  const int sum = a + b;
  return (short)(sum > 32767 ? 32767 : sum < -32768 ? -32768 : sum);
}
static __attribute__((noinline)) unsigned limited_difference(short a, short b) {
  const int difference = a - b;
  return (unsigned short)(difference > 32767 ? 32767 : difference < -32768 ? -32768 : difference);
}
static __attribute__((noinline)) int twice_limited(short a, short b, short c) {
  const int sum = limited_sum(a, b) - c;
  return sum > 32767 ? 32767 : sum < -32768 ? -32768 : sum;
}
CHECK2(limited_sum, short, short)
CHECK2(limited_difference, short, short)

int main(void) {
  REPORT(abs_fr1x16)
  REPORT(negate_fr1x16)
  REPORT(norm_fr1x16)
  REPORT(add_fr1x16)
  REPORT(sub_fr1x16)
  REPORT(mult_fr1x16)
  REPORT(multr_fr1x16)
  REPORT(mult_fr1x32)
  REPORT(min_fr1x16)
  REPORT(max_fr1x16)
  REPORT(shl_fr1x16)
  REPORT(shr_fr1x16)
  REPORT(shrl_fr1x16)
  REPORT(shl_fr1x16_clip)
  REPORT(shr_fr1x16_clip)
  REPORT(limited_sum)
  REPORT(limited_difference)
  unsigned state = 4, sum = 0;
  for (unsigned i = 0; i < 100; ++i) {
    const int a = edge_or_any(&state, i);
    sum = mix(sum, (unsigned)twice_limited((short)a, (short)(a >> 16), (short)(a >> 7)));
    sum = mix(sum, mixed(a, edge_or_any(&state, i / 2)));
  }
  report("mixed", sum);
  return 0;
}
