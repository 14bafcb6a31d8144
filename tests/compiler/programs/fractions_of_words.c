/* Fractions of 32 bits, and conversions between fractions and floats. */
#include "fract_reference.h"

CHECK1(abs_fr1x32, fract32)
CHECK1(negate_fr1x32, fract32)
CHECK1(norm_fr1x32, fract32)
CHECK1(sat_fr1x32, fract32)
CHECK1(round_fr1x32, fract32)
CHECK1(trunc_fr1x32, fract32)
CHECK2(add_fr1x32, fract32, fract32)
CHECK2(sub_fr1x32, fract32, fract32)
CHECK2(mult_fr1x32x32, fract32, fract32)
CHECK2(mult_fr1x32x32NS, fract32, fract32)
CHECK2(multr_fr1x32x32, fract32, fract32)
CHECK2(min_fr1x32, fract32, fract32)
CHECK2(max_fr1x32, fract32, fract32)
CHECK2(clip, int, unsigned short)
CHECK_SHIFT(shl_fr1x32, fract32, -31, 31)
CHECK_SHIFT(shr_fr1x32, fract32, -31, 31)
CHECK_SHIFT(shl_fr1x32_clip, fract32, -100, 100)
CHECK_SHIFT(shr_fr1x32_clip, fract32, -100, 100)

static __attribute__((noinline)) unsigned both_of(fract32 a, fract32 b) {
  const long long both = __builtin_bfin_both_fr1x32(a, b);
  return mix((unsigned)both, (unsigned)(both >> 32));
}

static unsigned bits_of(float a) {
  union {
    float number;
    unsigned bits;
  } both;
  both.number = a;
  return both.bits;
}

static __attribute__((noinline)) unsigned converted(int a) {
  unsigned sum = bits_of(fr16_to_float((fract16)a));
  sum = mix(sum, bits_of(fr32_to_float(a)));
  sum = mix(sum, (unsigned)float_to_fr16((float)a / 2000000000.0f));
  sum = mix(sum, (unsigned)float_to_fr32((float)a / 2000000000.0f));
  sum = mix(sum, (unsigned)shl_fr1x32(a, 7));
  sum = mix(sum, (unsigned)shr_fr1x32(a, 31));
  return mix(sum, (unsigned)shl_fr1x32_clip(a, 500));
}

int main(void) {
  REPORT(abs_fr1x32)
  REPORT(negate_fr1x32)
  REPORT(norm_fr1x32)
  REPORT(sat_fr1x32)
  REPORT(round_fr1x32)
  REPORT(trunc_fr1x32)
  REPORT(add_fr1x32)
  REPORT(sub_fr1x32)
  REPORT(mult_fr1x32x32)
  REPORT(mult_fr1x32x32NS)
  REPORT(multr_fr1x32x32)
  REPORT(min_fr1x32)
  REPORT(max_fr1x32)
  REPORT(clip)
  REPORT(shl_fr1x32)
  REPORT(shr_fr1x32)
  REPORT(shl_fr1x32_clip)
  REPORT(shr_fr1x32_clip)
  unsigned state = 5, sum = 0;
  for (unsigned i = 0; i < 60; ++i)
    sum = mix(sum, converted(edge_or_any(&state, i)));
  report("converted", sum);
  for (unsigned i = 0; i < 400; ++i) {
    const int a = edge_or_any(&state, i / 20);
    sum = mix(sum, both_of(a, edge_or_any(&state, i % 20)));
  }
  report("both", sum);
  return 0;
}
