/* Loops over 16-bit arrays that the compiler takes two elements at a time: each operation on the
 * values where it wraps around or saturates, of every small count, from odd halves on, over arrays
 * that overlap by any distance, in place, in rows of odd and even length; and loops that look
 * alike. */
#include "report.h"

enum { COUNT = 80 };

static short a[COUNT + 8], b[COUNT + 8], c[COUNT + 8];
static const short edges[] = {0,      1,   -1,   32767, -32768, 32766,
                              -32767, 255, -256, 16384, -16384, 12345};

static const int counts[] = {0, 1, 2, 7, 8, 9, 10, 11, 33};

static short half(int x) { return (short)x; }
static int clamp(int x) { return x > 32767 ? 32767 : x < -32768 ? -32768 : x; }

#define LOOP(name, expression)                                                                \
  APART static void name(short* restrict z, const short* restrict x, const short* restrict y, \
                         int n, int k) {                                                      \
    (void)y, (void)k;                                                                         \
    for (int i = 0; i < n; i++)                                                               \
      z[i] = (short)(expression);                                                             \
  }
#define MAGNITUDE(x) ((x) < 0 ? -(x) : (x))
#define LEAST(x, y) ((x) < (y) ? (x) : (y))
#define MOST(x, y) ((x) > (y) ? (x) : (y))
LOOP(sum, x[i] + y[i])
LOOP(difference, x[i] - y[i])
LOOP(negative, -x[i])
LOOP(least, LEAST(x[i], y[i]))
LOOP(most, MOST(x[i], y[i]))
LOOP(amount, MAGNITUDE(x[i]))
LOOP(amount_of_shifted, MAGNITUDE(x[i] >> 1))
LOOP(down, x[i] >> 3)
LOOP(down_all, x[i] >> 15)
LOOP(down_unsigned, (unsigned short)x[i] >> 5)
LOOP(up, (unsigned)x[i] << 4)
LOOP(bits, (x[i] & y[i]) | (~x[i] & 0x0ff0))
LOOP(limited_sum, clamp(x[i] + y[i]))
LOOP(limited_difference, clamp(x[i] - y[i]))
LOOP(fraction, LEAST(x[i] * y[i] >> 15, 32767))
LOOP(limited_fraction, clamp(x[i] * y[i] >> 15))
LOOP(unlimited_fraction, x[i] * y[i] >> 15)
LOOP(product, x[i] * y[i])
LOOP(plus_outside, x[i] + k)
LOOP(most_outside, MOST(x[i], k))
LOOP(limited_outside, clamp(x[i] - half(k)))
LOOP(scaled, LEAST(x[i] * half(k) >> 15, 32767))
LOOP(blend, clamp(LEAST(x[i] * half(k) >> 15, 32767) + (y[i] >> 1)))
LOOP(window, LEAST(MOST(x[i] - y[i], -100), k))
LOOP(half_sum, (x[i] + y[i]) >> 1)
LOOP(distance, MAGNITUDE(x[i] - y[i]))
LOOP(unsigned_least, LEAST((unsigned short)x[i], (unsigned short)y[i]))
LOOP(index, x[i] + i)
LOOP(chosen, x[i] > y[i] ? x[i] : k)
LOOP(mixed, (x[i] + 3) - (y[i] << 1) + MAGNITUDE(LEAST(x[i], y[i])))
LOOP(volatile_read, x[i] + *(const volatile short*)&y[i])

typedef void Loop(short* restrict, const short* restrict, const short* restrict, int, int);
static Loop* const loops[] = {sum,
                              difference,
                              negative,
                              least,
                              most,
                              amount,
                              amount_of_shifted,
                              down,
                              down_all,
                              down_unsigned,
                              up,
                              bits,
                              limited_sum,
                              limited_difference,
                              fraction,
                              limited_fraction,
                              unlimited_fraction,
                              product,
                              plus_outside,
                              most_outside,
                              limited_outside,
                              scaled,
                              blend,
                              window,
                              half_sum,
                              distance,
                              unsigned_least,
                              index,
                              chosen,
                              mixed,
                              volatile_read};

APART static void overlapping(short* z, const short* x, const short* y, int n) {
  for (int i = 0; i < n; i++)
    z[i] = (short)(x[i] + y[i]);
}
APART static void in_place(short* x, const short* y, unsigned n) {
  while (n-- != 0)
    *x = (short)(*x - *y), x++, y++;
}
APART static void two_results(short* restrict z, short* restrict v, const short* x, int n) {
  for (int i = 0; i < n; i++) {
    z[i] = (short)clamp(x[i] + x[i]);
    v[i] = (short)(x[i] >> 2);
  }
}
APART static void neighbours(short* restrict z, const short* x, int n) {
  for (int i = 0; i < n; i++)
    z[i] = (short)(x[i + 1] - x[i]);
}
APART static void backwards(short* restrict z, const short* x, int n) {
  for (int i = n - 1; i >= 0; i--)
    z[i] = (short)(x[i] + 1);
}
APART static void every_second(short* restrict z, const short* x, int n) {
  for (int i = 0; i < n; i += 2)
    z[i] = (short)(x[i] - 5);
}
APART static void rows(short* restrict z, const short* restrict x, int width, int height,
                       int pitch) {
  for (int row = 0; row < height; row++)
    for (int i = 0; i < width; i++)
      z[row * pitch + i] = (short)-x[row * pitch + i];
}
APART static void globals(void) {
  for (int i = 0; i < COUNT; i++)
    c[i] = half(a[i] - b[i]);
  for (int i = 1; i < COUNT; i++)
    c[i] = half(c[i] + a[i]);
}
APART static void recurrence(short* z, int n) {
  for (int i = 0; i + 1 < n; i++)
    z[i + 1] = (short)(z[i] + z[i + 1]);
}

static void fill(void) {
  unsigned state = 99;
  for (int i = 0; i < COUNT + 8; i++) {
    a[i] = i < 40 ? edges[i % 12] : half((int)next_number(&state));
    b[i] = i < 40 ? edges[i * 5 / 7 % 12] : half((int)next_number(&state));
    c[i] = half(i);
  }
}
static unsigned result(unsigned sum) {
  for (int i = 0; i < COUNT + 8; i++)
    sum = mix(sum, ((unsigned)a[i] << 16) ^ (unsigned)c[i]);
  fill();
  return sum;
}

int main(void) {
  fill();
  for (unsigned which = 0; which < sizeof loops / sizeof *loops; which++) {
    unsigned sum = which;
    for (unsigned count = 0; count < sizeof counts / sizeof *counts; count++) {
      const int n = counts[count];
      for (int at = 0; at < 8; at += 1 + at / 2) {
        loops[which](c + (at & 1), a + (at >> 1 & 1), b + (at >> 2), n, edges[(n + at) % 12]);
        sum = result(sum);
      }
    }
    report("loop", sum);
  }
  for (int n = 0; n < 40; n += n < 12 ? 1 : 13) {
    unsigned sum = 0;
    for (int apart = 0; apart < 8; apart++) {
      overlapping(a + apart, a + 4, b, n), sum = result(sum);
      overlapping(a + 3, b, a + apart, n), sum = result(sum);
      in_place(a + apart, a + 2, (unsigned)n), sum = result(sum);
      two_results(c, a + 40, a + apart, n), sum = result(sum);
    }
    neighbours(c, a, n), sum = result(sum);
    backwards(c, a, n), sum = result(sum);
    every_second(c, a, n), sum = result(sum);
    recurrence(c, n), sum = result(sum);
    rows(c, a, n / 4, 4, n / 4), sum = result(sum);
    rows(c, a, n / 4, 4, 9), sum = result(sum);
    rows(c, a, 15, 3, 20), sum = result(sum);
    report("shapes", sum);
  }
  globals();
  report("globals", result(0));
  return 0;
}
