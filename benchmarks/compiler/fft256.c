/* The discrete Fourier transform of 256 complex fractions, divided by 256. Radix 2, every stage in
 * the same shape: butterfly k takes elements k and k + 128 and leaves its results in 2 k and
 * 2 k + 1 of the other buffer, so that the last results stand in bit-reversed order, which is
 * undone as they are written. Butterfly k of stage s turns by the angle number k mod 2^s; the
 * angles are those of 0, -1/4, -1/8, -3/8, ... of a circle: bit-reversed. No element's magnitude
 * exceeds 1. Products are rounded to the nearest fraction, sums are halved downwards. */
#include <ccblkfn.h>
#include <fr2x16.h>

#define POINTS 256
#define HALF (POINTS / 2)

/* A complex number is a pair: the imaginary part in the high half. */
FINBACK_INLINE fract2x16 first_of(long long both) { return (fract2x16)both; }
FINBACK_INLINE fract2x16 second_of(long long both) { return (fract2x16)(both >> 32); }

/* Half of a plus b times angle, and half of a minus it. */
FINBACK_INLINE long long turned_butterfly(fract2x16 a, fract2x16 b, fract2x16 angle) {
  return __builtin_bfin_both_half_2x16(a, __builtin_bfin_cmplx_mul(b, angle));
}

/* The first two stages, whose angles need no multiplication: every fourth of the input becomes four
 * neighbours. */
static void first_stages(const fract2x16* restrict in, fract2x16* restrict out) {
  for (int k = 0; k < POINTS / 4; ++k) {
    const long long even = __builtin_bfin_both_half_2x16(in[0], in[128]);
    const long long odd = __builtin_bfin_both_half_co_2x16(in[64], in[192]);
    const long long sums = __builtin_bfin_both_half_2x16(first_of(even), first_of(odd));
    const long long crossed = __builtin_bfin_cross_half_2x16(second_of(even), second_of(odd));
    out[0] = first_of(sums);
    out[1] = second_of(sums);
    out[2] = second_of(crossed);
    out[3] = first_of(crossed);
    ++in;
    out += 4;
  }
}

/* `groups` times through all the stage's angles. */
static void stage(const fract2x16* restrict in, fract2x16* restrict out,
                  const fract2x16* restrict angles, int angle_count, int groups) {
  const fract2x16* restrict opposite = in + HALF;
  do {
    const fract2x16* restrict angle = angles;
    for (int k = 0; k < angle_count; ++k) {
      const long long both = turned_butterfly(*in++, *opposite++, *angle++);
      *out++ = first_of(both);
      *out++ = second_of(both);
    }
  } while (--groups != 0);
}

static void last_stage(const fract2x16* restrict in, fract2x16* restrict out,
                       const fract2x16* restrict angles) {
  const fract2x16* restrict opposite = in + HALF;
  char* at = 0; /* in bytes from `out` */
  for (int k = 0; k < HALF; ++k) {
    const long long both = turned_butterfly(*in++, *opposite++, *angles++);
    fract2x16* to = (fract2x16*)((char*)out + (int)at);
    to[0] = first_of(both);
    to[HALF] = second_of(both);
    at = brevadd(at, (char*)(HALF / 2 * sizeof(fract2x16)));
  }
}

/* `in` is used up. */
void fft256(fract2x16* restrict in, fract2x16* restrict out, const fract2x16* restrict angles) {
  fract2x16* from = out;
  fract2x16* to = in;
  first_stages(in, out);
  for (int groups = HALF / 4, angle_count = 4; groups > 1; groups /= 2, angle_count *= 2) {
    fract2x16* results = to;
    stage(from, to, angles, angle_count, groups);
    to = from;
    from = results;
  }
  last_stage(in, out, angles);
}
