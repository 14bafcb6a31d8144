/* Complex 16-bit fractions. A product's parts are sums of two products, rounded once (a half to
 * even unless RND_MOD is set) and saturated. The accumulators hold 32 bits on the way, and 40 bits
 * in what ends with _s40. */
#ifndef COMPLEX_BF_H
#define COMPLEX_BF_H

#include <fract_math.h>

typedef struct complex_fract16 {
  fract16 re;
  fract16 im;
} __attribute__((aligned(4))) complex_fract16;

/* The same 32 bits. */
FINBACK_INLINE fract2x16 finback_pair(complex_fract16 a) {
  union {
    complex_fract16 number;
    fract2x16 pair;
  } both;
  both.number = a;
  return both.pair;
}
FINBACK_INLINE complex_fract16 finback_complex(fract2x16 a) {
  union {
    fract2x16 pair;
    complex_fract16 number;
  } both;
  both.pair = a;
  return both.number;
}

FINBACK_INLINE complex_fract16 ccompose_fr16(fract16 re, fract16 im) {
  return finback_complex(compose_fr2x16(im, re));
}
FINBACK_INLINE fract16 real_fr16(complex_fract16 a) { return low_of_fr2x16(finback_pair(a)); }
FINBACK_INLINE fract16 imag_fr16(complex_fract16 a) { return high_of_fr2x16(finback_pair(a)); }

FINBACK_INLINE complex_fract16 cadd_fr16(complex_fract16 a, complex_fract16 b) {
  return finback_complex(__builtin_bfin_cmplx_add(finback_pair(a), finback_pair(b)));
}
FINBACK_INLINE complex_fract16 csub_fr16(complex_fract16 a, complex_fract16 b) {
  return finback_complex(__builtin_bfin_cmplx_sub(finback_pair(a), finback_pair(b)));
}
FINBACK_INLINE complex_fract16 conj_fr16(complex_fract16 a) {
  return finback_complex(add_sa_fr2x16(finback_pair(a) & 0xffff, finback_pair(a) & ~0xffff));
}
FINBACK_INLINE complex_fract16 cmlt_fr16(complex_fract16 a, complex_fract16 b) {
  return finback_complex(__builtin_bfin_cmplx_mul(finback_pair(a), finback_pair(b)));
}
FINBACK_INLINE complex_fract16 cmlt_fr16_s40(complex_fract16 a, complex_fract16 b) {
  return finback_complex(__builtin_bfin_cmplx_mul_s40(finback_pair(a), finback_pair(b)));
}
/* sum + a b and sum - a b. */
FINBACK_INLINE complex_fract16 cmac_fr16(complex_fract16 sum, complex_fract16 a,
                                         complex_fract16 b) {
  return finback_complex(
      __builtin_bfin_cmplx_mac(finback_pair(sum), finback_pair(a), finback_pair(b)));
}
FINBACK_INLINE complex_fract16 cmsu_fr16(complex_fract16 sum, complex_fract16 a,
                                         complex_fract16 b) {
  return finback_complex(
      __builtin_bfin_cmplx_msu(finback_pair(sum), finback_pair(a), finback_pair(b)));
}
FINBACK_INLINE complex_fract16 cmac_fr16_s40(complex_fract16 sum, complex_fract16 a,
                                             complex_fract16 b) {
  return finback_complex(
      __builtin_bfin_cmplx_mac_s40(finback_pair(sum), finback_pair(a), finback_pair(b)));
}
FINBACK_INLINE complex_fract16 cmsu_fr16_s40(complex_fract16 sum, complex_fract16 a,
                                             complex_fract16 b) {
  return finback_complex(
      __builtin_bfin_cmplx_msu_s40(finback_pair(sum), finback_pair(a), finback_pair(b)));
}
/* The square, its parts rounded before they are subtracted and doubled. */
FINBACK_INLINE complex_fract16 csqu_fr16(complex_fract16 a) {
  const fract2x16 squares = multr_fr2x16(finback_pair(a), finback_pair(a));
  const fract16 mixed = multr_fr1x16(real_fr16(a), imag_fr16(a));
  return ccompose_fr16(diff_lh_fr2x16(squares), add_fr1x16(mixed, mixed));
}

#endif
