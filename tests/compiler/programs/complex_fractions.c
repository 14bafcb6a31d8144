/* Complex fractions: products, sums of products, squares; a filter in place. */
#include "fract_reference.h"

static complex_fract16 number_of(int a) {
  return ccompose_fr16(low_of_fr2x16(a), high_of_fr2x16(a));
}
static unsigned bits_of(complex_fract16 a) {
  return (unsigned)compose_fr2x16(imag_fr16(a), real_fr16(a));
}
#define WITH1(name)                                                          \
  static unsigned with_##name(int a) { return bits_of(name(number_of(a))); } \
  CHECK1(with_##name, int)
#define WITH2(name)                                                                               \
  static unsigned with_##name(int a, int b) { return bits_of(name(number_of(a), number_of(b))); } \
  CHECK2(with_##name, int, int)
#define WITH3(name)                                                              \
  static unsigned with_##name(int a, int b) {                                    \
    return bits_of(name(number_of(b ^ 0x71234567), number_of(a), number_of(b))); \
  }                                                                              \
  CHECK2(with_##name, int, int)
WITH1(conj_fr16)
WITH1(csqu_fr16)
WITH2(cadd_fr16)
WITH2(csub_fr16)
WITH2(cmlt_fr16)
WITH2(cmlt_fr16_s40)
WITH3(cmac_fr16)
WITH3(cmsu_fr16)
WITH3(cmac_fr16_s40)
WITH3(cmsu_fr16_s40)

/* Products inside sums of other products: both want the accumulators. */
static __attribute__((noinline)) int sum_beside(const short* a, const complex_fract16* c, int n,
                                                complex_fract16* last) {
  int sum = 0;
  complex_fract16 turned = c[0];
  for (int i = 0; i < n; ++i) {
    sum += a[i] * a[i + 1];
    turned = cmlt_fr16(turned, c[i]);
  }
  *last = turned;
  return sum;
}
static __attribute__((noinline)) int sum_after(const short* a, complex_fract16 b, complex_fract16 c,
                                               int n, complex_fract16* product) {
  int sum = 0;
  for (int i = 0; i < n; ++i)
    sum += a[i] * a[i + 1];
  *product = cmlt_fr16(b, c);
  return sum;
}

static void filter(complex_fract16* x, const complex_fract16* h, int n) {
  for (int i = n - 1; i >= 3; --i) {
    complex_fract16 sum = cmlt_fr16(x[i], h[0]);
    for (int k = 1; k < 4; ++k)
      sum = cmac_fr16(sum, x[i - k], h[k]);
    x[i] = sum;
  }
}

int main(void) {
  unsigned state = 7, sum = 0;
  REPORT(with_conj_fr16)
  REPORT(with_csqu_fr16)
  REPORT(with_cadd_fr16)
  REPORT(with_csub_fr16)
  REPORT(with_cmlt_fr16)
  REPORT(with_cmlt_fr16_s40)
  REPORT(with_cmac_fr16)
  REPORT(with_cmsu_fr16)
  REPORT(with_cmac_fr16_s40)
  REPORT(with_cmsu_fr16_s40)
  complex_fract16 x[40], h[4], product;
  short a[40];
  for (unsigned i = 0; i < 40; ++i) {
    x[i] = number_of(edge_or_any(&state, i));
    a[i] = (short)(edge_or_any(&state, 99) >> 20);
  }
  for (unsigned i = 0; i < 4; ++i)
    h[i] = number_of(edge_or_any(&state, 99));
  sum = (unsigned)sum_beside(a, x, 30, &product);
  report("beside", mix(sum, bits_of(product)));
  sum = (unsigned)sum_after(a, x[20], x[30], 30, &product);
  report("after", mix(sum, bits_of(product)));
  filter(x, h, 40);
  for (unsigned i = 0; i < 40; ++i)
    sum = mix(sum, bits_of(x[i]));
  report("filter", sum);
  return 0;
}
