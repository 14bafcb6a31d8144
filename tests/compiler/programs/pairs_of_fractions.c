/* Pairs of fractions and of integers; sums and differences at once. */
#include "fract_reference.h"

CHECK1(abs_fr2x16, int)
CHECK1(negate_fr2x16, int)
CHECK1(sum_fr2x16, int)
CHECK1(diff_hl_fr2x16, int)
CHECK1(diff_lh_fr2x16, int)
CHECK1(high_of_fr2x16, int)
CHECK1(low_of_fr2x16, int)
CHECK2(add_fr2x16, int, int)
CHECK2(sub_fr2x16, int, int)
CHECK2(mult_fr2x16, int, int)
CHECK2(multr_fr2x16, int, int)
CHECK2(min_fr2x16, int, int)
CHECK2(max_fr2x16, int, int)
CHECK2(add_as_fr2x16, int, int)
CHECK2(add_sa_fr2x16, int, int)
CHECK2(mult_ll_fr2x16, int, int)
CHECK2(mult_hl_fr2x16, int, int)
CHECK2(mult_lh_fr2x16, int, int)
CHECK2(mult_hh_fr2x16, int, int)
CHECK2(add_i2x16, int, int)
CHECK2(sub_i2x16, int, int)
CHECK2(mult_i2x16, int, int)
CHECK2(compose_fr2x16, int, int)
CHECK_SHIFT(shl_fr2x16, int, -31, 31)
CHECK_SHIFT(shr_fr2x16, int, -31, 31)
CHECK_SHIFT(shrl_fr2x16, int, 0, 31)
CHECK_SHIFT(shl_fr2x16_clip, int, -100, 100)

#define TWO(name)                                       \
  static unsigned name(int a, int b) {                  \
    const long long both = __builtin_bfin_##name(a, b); \
    return mix((unsigned)both, (unsigned)(both >> 32)); \
  }                                                     \
  CHECK2(name, int, int)
TWO(both_i2x16)
TWO(both_fr2x16)
TWO(both_half_2x16)
TWO(both_half_co_2x16)
TWO(cross_fr2x16)
TWO(cross_half_2x16)
TWO(cross_half_co_2x16)

/* One instruction for two, whichever comes first. */
static __attribute__((noinline)) unsigned joined(int a, int b, int c) {
  unsigned sum = mix((unsigned)add_fr2x16(a, b), (unsigned)sub_fr2x16(b, a));
  sum = mix(sum, mix((unsigned)sub_fr2x16(b, c), (unsigned)add_fr2x16(b, c)));
  sum = mix(sum, mix((unsigned)add_as_fr2x16(a, c), (unsigned)add_sa_fr2x16(a, c)));
  sum = mix(sum, mix((unsigned)add_as_fr2x16(b, c), (unsigned)add_sa_fr2x16(c, b)));
  sum = mix(sum, mix((unsigned)add_fr2x16(c, c), (unsigned)sub_fr2x16(c, c)));
  sum = mix(sum, (unsigned)compose_fr2x16(high_of_fr2x16(a), high_of_fr2x16(b)));
  sum = mix(sum, (unsigned)compose_fr2x16(low_of_fr2x16(a), high_of_fr2x16(a)));
  sum = mix(sum, (unsigned)shl_fr2x16(a, 2));
  sum = mix(sum, (unsigned)shr_fr2x16(b, 9));
  return mix(sum, (unsigned)shrl_fr2x16(c, 7));
}

int main(void) {
  REPORT(abs_fr2x16)
  REPORT(negate_fr2x16)
  REPORT(sum_fr2x16)
  REPORT(diff_hl_fr2x16)
  REPORT(diff_lh_fr2x16)
  REPORT(high_of_fr2x16)
  REPORT(low_of_fr2x16)
  REPORT(add_fr2x16)
  REPORT(sub_fr2x16)
  REPORT(mult_fr2x16)
  REPORT(multr_fr2x16)
  REPORT(min_fr2x16)
  REPORT(max_fr2x16)
  REPORT(add_as_fr2x16)
  REPORT(add_sa_fr2x16)
  REPORT(mult_ll_fr2x16)
  REPORT(mult_hl_fr2x16)
  REPORT(mult_lh_fr2x16)
  REPORT(mult_hh_fr2x16)
  REPORT(add_i2x16)
  REPORT(sub_i2x16)
  REPORT(mult_i2x16)
  REPORT(compose_fr2x16)
  REPORT(shl_fr2x16)
  REPORT(shr_fr2x16)
  REPORT(shrl_fr2x16)
  REPORT(shl_fr2x16_clip)
  REPORT(both_i2x16)
  REPORT(both_fr2x16)
  REPORT(both_half_2x16)
  REPORT(both_half_co_2x16)
  REPORT(cross_fr2x16)
  REPORT(cross_half_2x16)
  REPORT(cross_half_co_2x16)
  unsigned state = 6, sum = 0;
  for (unsigned i = 0; i < 400; ++i) {
    const int a = edge_or_any(&state, i / 20), b = edge_or_any(&state, i % 20);
    sum = mix(sum, joined(a, b, edge_or_any(&state, i % 7)));
  }
  report("joined", sum);
  return 0;
}
