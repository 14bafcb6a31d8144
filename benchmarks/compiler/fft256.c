/* The discrete Fourier transform of 256 complex fractions, divided by 256. Radix 2, every stage in
 * the same shape: butterfly k takes elements k and k + 128 and leaves its results in 2 k and
 * 2 k + 1 of the other buffer, so that the last results stand in bit-reversed order, which is
 * undone as they are written. Butterfly k of stage s turns by the angle number k mod 2^s; the
 * angles are those of 0, -1/4, -1/8, -3/8, ... of a circle: bit-reversed. No element's magnitude
 * exceeds 1. */
#include <stdint.h>

#define POINTS 256
#define HALF (POINTS / 2)

struct complex16 {
  int16_t re;
  int16_t im;
};

#define REVERSED_2(n) (n), (n) + 128, (n) + 64, (n) + 192
#define REVERSED_4(n) \
  REVERSED_2(n), REVERSED_2((n) + 32), REVERSED_2((n) + 16), REVERSED_2((n) + 48)
#define REVERSED_6(n) REVERSED_4(n), REVERSED_4((n) + 8), REVERSED_4((n) + 4), REVERSED_4((n) + 12)
static const uint8_t bit_reversed[POINTS] = {REVERSED_6(0), REVERSED_6(2), REVERSED_6(1),
                                             REVERSED_6(3)};

/* Half of a plus b and half of a minus b. */
static void butterfly(const struct complex16* restrict a, int b_re, int b_im,
                      struct complex16* restrict sum, struct complex16* restrict difference) {
  int re = a->re;
  int im = a->im;
  sum->re = (int16_t)((re + b_re) >> 1);
  sum->im = (int16_t)((im + b_im) >> 1);
  difference->re = (int16_t)((re - b_re) >> 1);
  difference->im = (int16_t)((im - b_im) >> 1);
}

static void turned_butterfly(const struct complex16* restrict a,
                             const struct complex16* restrict angle, struct complex16* restrict sum,
                             struct complex16* restrict difference) {
  const struct complex16* b = a + HALF;
  butterfly(a, (b->re * angle->re - b->im * angle->im) >> 15,
            (b->re * angle->im + b->im * angle->re) >> 15, sum, difference);
}

/* The first two stages, whose angles need no multiplication: every fourth of the input becomes four
 * neighbours. */
static void first_stages(const struct complex16* restrict in, struct complex16* restrict out) {
  for (int k = 0; k < POINTS / 4; ++k) {
    struct complex16 even_sum;
    struct complex16 even_difference;
    struct complex16 odd_sum;
    struct complex16 odd_difference;
    butterfly(in, in[128].re, in[128].im, &even_sum, &even_difference);
    butterfly(in + 64, in[192].re, in[192].im, &odd_sum, &odd_difference);
    butterfly(&even_sum, odd_sum.re, odd_sum.im, out, out + 1);
    butterfly(&even_difference, odd_difference.im, -odd_difference.re, out + 2, out + 3);
    ++in;
    out += 4;
  }
}

static void stage(const struct complex16* restrict in, struct complex16* restrict out,
                  const struct complex16* restrict angles, int angle_count) {
  for (int k = 0; k < HALF; ++k) {
    turned_butterfly(in + k, angles + (k & (angle_count - 1)), out, out + 1);
    out += 2;
  }
}

static void last_stage(const struct complex16* restrict in, struct complex16* restrict out,
                       const struct complex16* restrict angles) {
  const uint8_t* restrict to = bit_reversed;
  for (int k = 0; k < HALF; ++k) {
    turned_butterfly(in + k, angles + k, out + to[0], out + to[1]);
    to += 2;
  }
}

/* `in` is used up. */
void fft256(struct complex16* restrict in, struct complex16* restrict out,
            const struct complex16* restrict angles) {
  first_stages(in, out);
  stage(out, in, angles, 4);
  stage(in, out, angles, 8);
  stage(out, in, angles, 16);
  stage(in, out, angles, 32);
  stage(out, in, angles, 64);
  last_stage(in, out, angles);
}
