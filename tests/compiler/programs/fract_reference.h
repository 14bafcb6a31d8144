/* The functions of fract_math.h, fr2x16.h, complex_bf.h and video.h once more, by their definitions
 * in plain integers, for the host's side of the differential tests. Does not share a line with what
 * it is held against; the target includes the real headers. */
#ifndef FRACT_REFERENCE_H
#define FRACT_REFERENCE_H

#include "report.h"

#ifdef __FINBACK__
#include <complex_bf.h>
#include <fract.h>
#include <math_bf.h>
#include <video.h>
#else

typedef short fract16;
typedef int fract32;
typedef int fract2x16;
typedef struct {
  fract16 re;
  fract16 im;
} complex_fract16;
typedef long long wide;
typedef unsigned char byte;

static wide limited(wide a, int bits) {
  const wide most = ((wide)1 << (bits - 1)) - 1;
  return a > most ? most : a < -most - 1 ? -most - 1 : a;
}
static fract16 half_of(wide a) { return (fract16)limited(a, 16); }
static fract32 word_of(wide a) { return (fract32)limited(a, 32); }
/* a / 2^16, a half to even. */
static wide rounded(wide a) {
  const wide down = a >> 16, rest = a & 0xffff;
  return down + (rest > 0x8000 || (rest == 0x8000 && (down & 1) != 0));
}
static wide product(fract16 a, fract16 b) { return (wide)a * b * 2; }
static wide moved(wide a, int left) { return left >= 0 ? a * ((wide)1 << left) : a >> -left; }
/* Low six bits, signed. */
static int amount(int left) { return ((left & 63) ^ 32) - 32; }

static fract16 add_fr1x16(fract16 a, fract16 b) { return half_of((wide)a + b); }
static fract16 sub_fr1x16(fract16 a, fract16 b) { return half_of((wide)a - b); }
static fract16 mult_fr1x16(fract16 a, fract16 b) { return half_of(product(a, b) >> 16); }
static fract16 multr_fr1x16(fract16 a, fract16 b) { return half_of(rounded(product(a, b))); }
static fract32 mult_fr1x32(fract16 a, fract16 b) { return word_of(product(a, b)); }
static fract16 abs_fr1x16(fract16 a) { return half_of(a < 0 ? -(wide)a : a); }
static fract16 negate_fr1x16(fract16 a) { return half_of(-(wide)a); }
static fract16 min_fr1x16(fract16 a, fract16 b) { return a < b ? a : b; }
static fract16 max_fr1x16(fract16 a, fract16 b) { return a > b ? a : b; }
static int norm(wide a, int bits) {
  int n = 0;
  for (; n < bits - 1 && limited(a * 2, bits) == a * 2; ++n)
    a *= 2;
  return n;
}
static int norm_fr1x16(fract16 a) { return norm(a, 16); }
static fract16 shl_fr1x16(fract16 a, short left) { return half_of(moved(a, amount(left))); }
static fract16 shr_fr1x16(fract16 a, short right) { return half_of(moved(a, amount(-right))); }
static fract16 shrl_fr1x16(fract16 a, short right) {
  return (fract16)moved((unsigned short)a, amount(-right));
}
static fract16 shl_fr1x16_clip(fract16 a, short left) {
  return half_of(moved(a, left < -40 ? -40 : left > 40 ? 40 : left));
}
static fract16 shr_fr1x16_clip(fract16 a, short right) {
  return shl_fr1x16_clip(a, right == -32768 ? 32767 : (short)-right);
}

static fract32 add_fr1x32(fract32 a, fract32 b) { return word_of((wide)a + b); }
static fract32 sub_fr1x32(fract32 a, fract32 b) { return word_of((wide)a - b); }
static fract32 mult_fr1x32x32(fract32 a, fract32 b) { return word_of((wide)a * b >> 31); }
static fract32 mult_fr1x32x32NS(fract32 a, fract32 b) { return mult_fr1x32x32(a, b); }
static fract32 multr_fr1x32x32(fract32 a, fract32 b) {
  return word_of(((wide)a * b + (1 << 30)) >> 31);
}
static fract32 abs_fr1x32(fract32 a) { return word_of(a < 0 ? -(wide)a : a); }
static fract32 negate_fr1x32(fract32 a) { return word_of(-(wide)a); }
static fract32 min_fr1x32(fract32 a, fract32 b) { return a < b ? a : b; }
static fract32 max_fr1x32(fract32 a, fract32 b) { return a > b ? a : b; }
static int norm_fr1x32(fract32 a) { return norm(a, 32); }
static fract32 shl_fr1x32(fract32 a, short left) {
  const int n = amount(left);
  return n > 31 ? 0 : word_of(moved(a, n));
}
static fract32 shr_fr1x32(fract32 a, short right) { return shl_fr1x32(a, (short)-right); }
static fract32 shl_fr1x32_clip(fract32 a, short left) {
  return word_of(moved(a, left < -31 ? -31 : left > 32 ? 32 : left));
}
static fract32 shr_fr1x32_clip(fract32 a, short right) {
  return shl_fr1x32_clip(a, right == -32768 ? 32767 : (short)-right);
}
static fract16 sat_fr1x32(fract32 a) { return half_of(a); }
static fract16 round_fr1x32(fract32 a) { return half_of(((wide)a + 0x8000) >> 16); }
static fract16 trunc_fr1x32(fract32 a) { return (fract16)(a >> 16); }

static fract2x16 compose_fr2x16(fract16 high, fract16 low) {
  return (int)((unsigned)high << 16 | (unsigned short)low);
}
static fract16 high_of_fr2x16(fract2x16 a) { return (fract16)(a >> 16); }
static fract16 low_of_fr2x16(fract2x16 a) { return (fract16)a; }
#define HIGH high_of_fr2x16
#define LOW low_of_fr2x16
#define EACH2(name)                                                                        \
  static fract2x16 name##_fr2x16(fract2x16 a, fract2x16 b) {                               \
    return compose_fr2x16(name##_fr1x16(HIGH(a), HIGH(b)), name##_fr1x16(LOW(a), LOW(b))); \
  }
#define EACH1(name)                                                       \
  static fract2x16 name##_fr2x16(fract2x16 a) {                           \
    return compose_fr2x16(name##_fr1x16(HIGH(a)), name##_fr1x16(LOW(a))); \
  }
EACH2(add)
EACH2(sub)
EACH2(mult)
EACH2(multr)
EACH2(min)
EACH2(max)
EACH1(abs)
EACH1(negate)
static fract2x16 shl_fr2x16(fract2x16 a, short n) {
  return compose_fr2x16(shl_fr1x16(HIGH(a), n), shl_fr1x16(LOW(a), n));
}
static fract2x16 shr_fr2x16(fract2x16 a, short n) {
  return compose_fr2x16(shr_fr1x16(HIGH(a), n), shr_fr1x16(LOW(a), n));
}
static fract2x16 shrl_fr2x16(fract2x16 a, short n) {
  return compose_fr2x16(shrl_fr1x16(HIGH(a), n), shrl_fr1x16(LOW(a), n));
}
static fract2x16 shl_fr2x16_clip(fract2x16 a, short n) {
  return compose_fr2x16(shl_fr1x16_clip(HIGH(a), n), shl_fr1x16_clip(LOW(a), n));
}
static fract2x16 add_as_fr2x16(fract2x16 a, fract2x16 b) {
  return compose_fr2x16(add_fr1x16(HIGH(a), HIGH(b)), sub_fr1x16(LOW(a), LOW(b)));
}
static fract2x16 add_sa_fr2x16(fract2x16 a, fract2x16 b) {
  return compose_fr2x16(sub_fr1x16(HIGH(a), HIGH(b)), add_fr1x16(LOW(a), LOW(b)));
}
static fract16 sum_fr2x16(fract2x16 a) { return add_fr1x16(HIGH(a), LOW(a)); }
static fract16 diff_hl_fr2x16(fract2x16 a) { return sub_fr1x16(HIGH(a), LOW(a)); }
static fract16 diff_lh_fr2x16(fract2x16 a) { return sub_fr1x16(LOW(a), HIGH(a)); }
static int mult_ll_fr2x16(fract2x16 a, fract2x16 b) { return LOW(a) * LOW(b); }
static int mult_hl_fr2x16(fract2x16 a, fract2x16 b) { return HIGH(a) * LOW(b); }
static int mult_lh_fr2x16(fract2x16 a, fract2x16 b) { return LOW(a) * HIGH(b); }
static int mult_hh_fr2x16(fract2x16 a, fract2x16 b) { return HIGH(a) * HIGH(b); }
static int add_i2x16(int a, int b) {
  return compose_fr2x16((short)(HIGH(a) + HIGH(b)), (short)(LOW(a) + LOW(b)));
}
static int sub_i2x16(int a, int b) {
  return compose_fr2x16((short)(HIGH(a) - HIGH(b)), (short)(LOW(a) - LOW(b)));
}
static int mult_i2x16(int a, int b) {
  return compose_fr2x16(half_of((wide)HIGH(a) * HIGH(b)), half_of((wide)LOW(a) * LOW(b)));
}
static int swapped(int a) { return compose_fr2x16(LOW(a), HIGH(a)); }
static int halved(int ah, int bh, int al, int bl) {
  return compose_fr2x16((short)((ah + bh) >> 1), (short)((al + bl) >> 1));
}
static wide both(int first, int second) { return (wide)second << 32 | (unsigned)first; }
static wide __builtin_bfin_both_i2x16(int a, int b) {
  return both(add_i2x16(a, b), sub_i2x16(a, b));
}
static wide __builtin_bfin_both_fr2x16(int a, int b) {
  return both(add_fr2x16(a, b), sub_fr2x16(a, b));
}
static wide __builtin_bfin_cross_fr2x16(int a, int b) {
  return both(add_as_fr2x16(a, b), add_sa_fr2x16(a, b));
}
static wide __builtin_bfin_both_fr1x32(int a, int b) {
  return both(add_fr1x32(a, b), sub_fr1x32(a, b));
}
static wide __builtin_bfin_both_half_2x16(int a, int b) {
  return both(halved(HIGH(a), HIGH(b), LOW(a), LOW(b)), halved(HIGH(a), -HIGH(b), LOW(a), -LOW(b)));
}
static wide __builtin_bfin_cross_half_2x16(int a, int b) {
  return both(halved(HIGH(a), HIGH(b), LOW(a), -LOW(b)), halved(HIGH(a), -HIGH(b), LOW(a), LOW(b)));
}
static wide __builtin_bfin_both_half_co_2x16(int a, int b) {
  const wide plain = __builtin_bfin_both_half_2x16(a, b);
  return both((int)plain, swapped((int)(plain >> 32)));
}
static wide __builtin_bfin_cross_half_co_2x16(int a, int b) {
  const wide plain = __builtin_bfin_cross_half_2x16(a, b);
  return both((int)plain, swapped((int)(plain >> 32)));
}

/* A product added to, or taken from, an accumulator of `bits` bits. */
static wide sum_of(wide sum, int sign, wide factors, int bits) {
  return limited(sum + sign * (bits == 32 ? limited(factors, 32) : factors), bits);
}
static complex_fract16 complex_sum(wide re, wide im, int sign, complex_fract16 a, complex_fract16 b,
                                   int bits) {
  complex_fract16 result;
  re = sum_of(re, sign, product(a.re, b.re), bits);
  im = sum_of(im, sign, product(a.re, b.im), bits);
  re = sum_of(re, -sign, product(a.im, b.im), 40);
  im = sum_of(im, sign, product(a.im, b.re), 40);
  result.re = half_of(rounded(re));
  result.im = half_of(rounded(im));
  return result;
}
static complex_fract16 ccompose_fr16(fract16 re, fract16 im) {
  complex_fract16 result = {re, im};
  return result;
}
static fract16 real_fr16(complex_fract16 a) { return a.re; }
static fract16 imag_fr16(complex_fract16 a) { return a.im; }
static complex_fract16 cadd_fr16(complex_fract16 a, complex_fract16 b) {
  return ccompose_fr16(add_fr1x16(a.re, b.re), add_fr1x16(a.im, b.im));
}
static complex_fract16 csub_fr16(complex_fract16 a, complex_fract16 b) {
  return ccompose_fr16(sub_fr1x16(a.re, b.re), sub_fr1x16(a.im, b.im));
}
static complex_fract16 conj_fr16(complex_fract16 a) {
  return ccompose_fr16(a.re, negate_fr1x16(a.im));
}
static complex_fract16 cmlt_fr16(complex_fract16 a, complex_fract16 b) {
  return complex_sum(0, 0, 1, a, b, 32);
}
static complex_fract16 cmlt_fr16_s40(complex_fract16 a, complex_fract16 b) {
  return complex_sum(0, 0, 1, a, b, 40);
}
static complex_fract16 cmac_fr16(complex_fract16 s, complex_fract16 a, complex_fract16 b) {
  return complex_sum((wide)s.re * 65536, (wide)s.im * 65536, 1, a, b, 32);
}
static complex_fract16 cmsu_fr16(complex_fract16 s, complex_fract16 a, complex_fract16 b) {
  return complex_sum((wide)s.re * 65536, (wide)s.im * 65536, -1, a, b, 32);
}
static complex_fract16 cmac_fr16_s40(complex_fract16 s, complex_fract16 a, complex_fract16 b) {
  return complex_sum((wide)s.re * 65536, (wide)s.im * 65536, 1, a, b, 40);
}
static complex_fract16 cmsu_fr16_s40(complex_fract16 s, complex_fract16 a, complex_fract16 b) {
  return complex_sum((wide)s.re * 65536, (wide)s.im * 65536, -1, a, b, 40);
}
static complex_fract16 csqu_fr16(complex_fract16 a) {
  const fract16 mixed = multr_fr1x16(a.re, a.im);
  return ccompose_fr16(sub_fr1x16(multr_fr1x16(a.re, a.re), multr_fr1x16(a.im, a.im)),
                       add_fr1x16(mixed, mixed));
}

static float fr16_to_float(fract16 a) { return (float)a / 32768; }
static float fr32_to_float(fract32 a) { return (float)a / 2147483648.0f; }
static fract16 float_to_fr16(float a) {
  return a != a ? 0 : a >= 1 ? 32767 : a < -1 ? -32768 : half_of((wide)(a * 32768));
}
static fract32 float_to_fr32(float a) {
  return a != a   ? 0
         : a >= 1 ? 0x7fffffff
         : a < -1 ? -0x7fffffff - 1
                  : word_of((wide)(a * 2147483648.0f));
}
static int clip(int a, int limit) { return a > limit ? limit : a < -limit ? -limit : a; }

/* Byte n of the four that begin at `at` in a pair; `turned` exchanges the words. */
static int byte_at(wide pair, const void* at, int turned, int n) {
  const unsigned long long words =
      turned ? (unsigned long long)pair << 32 | (unsigned long long)pair >> 32
             : (unsigned long long)pair;
  return (byte)(words >> 8 * (((unsigned)(unsigned long)at & 3) + (unsigned)n));
}
static int align8(int high, int low) { return (int)((unsigned)high << 24 | (unsigned)low >> 8); }
static int align16(int high, int low) { return (int)((unsigned)high << 16 | (unsigned)low >> 16); }
static int align24(int high, int low) { return (int)((unsigned)high << 8 | (unsigned)low >> 24); }
static int bytepack(int low, int high) {
  return (int)((low & 255) | (low >> 16 & 255) << 8 | (high & 255) << 16 |
               (unsigned)(high >> 16 & 255) << 24);
}
static int averages(wide a, const void* at_a, wide b, const void* at_b, int round, int turned) {
  unsigned result = 0;
  for (int i = 0; i < 4; ++i)
    result |= (unsigned)((byte_at(a, at_a, turned, i) + byte_at(b, at_b, turned, i) + round) >> 1)
              << 8 * i;
  return (int)result;
}
static int avg_i4x8(wide a, const void* p, wide b, const void* q) {
  return averages(a, p, b, q, 1, 0);
}
static int avg_i4x8_t(wide a, const void* p, wide b, const void* q) {
  return averages(a, p, b, q, 0, 0);
}
static int avg_i4x8_r(wide a, const void* p, wide b, const void* q) {
  return averages(a, p, b, q, 1, 1);
}
static int avg_i4x8_tr(wide a, const void* p, wide b, const void* q) {
  return averages(a, p, b, q, 0, 1);
}
static int averages_of_four(wide a, const void* at, wide b, int high, int round, int turned) {
  unsigned result = 0;
  for (int i = 0; i < 4; i += 2)
    result |= (unsigned)((byte_at(a, at, turned, i) + byte_at(a, at, turned, i + 1) +
                          byte_at(b, at, turned, i) + byte_at(b, at, turned, i + 1) + round) >>
                         2)
              << (8 * i + 8 * high);
  return (int)result;
}
static int avg_i2x8_lo(wide a, const void* p, wide b) { return averages_of_four(a, p, b, 0, 2, 0); }
static int avg_i2x8_lot(wide a, const void* p, wide b) {
  return averages_of_four(a, p, b, 0, 0, 0);
}
static int avg_i2x8_lor(wide a, const void* p, wide b) {
  return averages_of_four(a, p, b, 0, 2, 1);
}
static int avg_i2x8_lotr(wide a, const void* p, wide b) {
  return averages_of_four(a, p, b, 0, 0, 1);
}
static int avg_i2x8_hi(wide a, const void* p, wide b) { return averages_of_four(a, p, b, 1, 2, 0); }
static int avg_i2x8_hit(wide a, const void* p, wide b) {
  return averages_of_four(a, p, b, 1, 0, 0);
}
static int avg_i2x8_hir(wide a, const void* p, wide b) {
  return averages_of_four(a, p, b, 1, 2, 1);
}
static int avg_i2x8_hitr(wide a, const void* p, wide b) {
  return averages_of_four(a, p, b, 1, 0, 1);
}
static int clipped_sums(wide a, const void* p, wide b, const void* q, int high, int turned) {
  unsigned result = 0;
  for (int i = 0; i < 4; i += 2) {
    const int half = (short)(byte_at(a, p, turned, i) | byte_at(a, p, turned, i + 1) << 8);
    const int sum = half + byte_at(b, q, turned, i + (high ? 0 : 1));
    result |= (unsigned)(sum < 0 ? 0 : sum > 255 ? 255 : sum) << (8 * i + 8 * high);
  }
  return (int)result;
}
static int addclip_lo(wide a, const void* p, wide b, const void* q) {
  return clipped_sums(a, p, b, q, 0, 0);
}
static int addclip_hi(wide a, const void* p, wide b, const void* q) {
  return clipped_sums(a, p, b, q, 1, 0);
}
static int addclip_lor(wide a, const void* p, wide b, const void* q) {
  return clipped_sums(a, p, b, q, 0, 1);
}
static int addclip_hir(wide a, const void* p, wide b, const void* q) {
  return clipped_sums(a, p, b, q, 1, 1);
}
static int of_bytes(wide a, const void* p, wide b, const void* q, int sign, int turned, int n) {
  return compose_fr2x16((short)(byte_at(a, p, turned, n + 1) + sign * byte_at(b, q, turned, n + 1)),
                        (short)(byte_at(a, p, turned, n) + sign * byte_at(b, q, turned, n)));
}
#define ALL_BYTES(a, p, b, q, sign, turned, upper, lower) \
  ((upper) = of_bytes(a, p, b, q, sign, turned, 2), (lower) = of_bytes(a, p, b, q, sign, turned, 0))
#define add_i4x8(a, p, b, q, upper, lower) ALL_BYTES(a, p, b, q, 1, 0, upper, lower)
#define add_i4x8_r(a, p, b, q, upper, lower) ALL_BYTES(a, p, b, q, 1, 1, upper, lower)
#define sub_i4x8(a, p, b, q, upper, lower) ALL_BYTES(a, p, b, q, -1, 0, upper, lower)
#define sub_i4x8_r(a, p, b, q, upper, lower) ALL_BYTES(a, p, b, q, -1, 1, upper, lower)
#define byteunpack(a, p, upper, lower) ALL_BYTES(a, p, 0, p, 1, 0, upper, lower)
#define byteunpackr(a, p, upper, lower) ALL_BYTES(a, p, 0, p, 1, 1, upper, lower)

#endif

/* Values at the edges, and then any. */
static int edge_or_any(unsigned* state, unsigned n) {
  static const int edges[] = {0,
                              1,
                              -1,
                              0x7fff,
                              -0x8000,
                              0x4000,
                              -0x4000,
                              0x8000,
                              0x7ffe,
                              0x7fffffff,
                              -0x7fffffff - 1,
                              0x40000000,
                              (int)0x80008000,
                              0x7fff7fff,
                              0x7fff8000,
                              (int)0x80007fff,
                              0x00010001,
                              0x0000ffff};
  const unsigned count = sizeof edges / sizeof edges[0];
  if (n < count)
    return edges[n];
  const unsigned high = next_number(state);
  return (int)(high << 16 ^ next_number(state));
}

#define ROUNDS 36
/* All pairs of edges, then any; what each function gives, mixed into a sum. */
#define CHECK1(name, type)                                          \
  static __attribute__((noinline)) unsigned check_##name(void) {    \
    unsigned state = 1, sum = 0;                                    \
    for (unsigned i = 0; i < ROUNDS; ++i)                           \
      sum = mix(sum, (unsigned)name((type)edge_or_any(&state, i))); \
    return sum;                                                     \
  }
#define CHECK2(name, type, other)                                         \
  static __attribute__((noinline)) unsigned check_##name(void) {          \
    unsigned state = 2, sum = 0;                                          \
    for (unsigned i = 0; i < ROUNDS; ++i)                                 \
      for (unsigned k = 0; k < 20; ++k) {                                 \
        const int a = edge_or_any(&state, i), b = edge_or_any(&state, k); \
        sum = mix(sum, (unsigned)name((type)a, (other)b));                \
      }                                                                   \
    return sum;                                                           \
  }
/* Amounts from -40 to 40. */
#define CHECK_SHIFT(name, type, least, most)                     \
  static __attribute__((noinline)) unsigned check_##name(void) { \
    unsigned state = 3, sum = 0;                                 \
    for (unsigned i = 0; i < 30; ++i) {                          \
      const type a = (type)edge_or_any(&state, i);               \
      for (int n = (least); n <= (most); ++n)                    \
        sum = mix(sum, (unsigned)name(a, (short)n));             \
    }                                                            \
    return sum;                                                  \
  }
#define REPORT(name) report(#name, check_##name());

#endif
