/* Loops over 16-bit arrays that the compiler takes two elements at a time: each operation on the
 * values where it wraps around or saturates, of every small count, from odd halves on, over arrays
 * that overlap by any distance, in place, in rows of odd and even length; and loops that look
 * alike. */
#include "halves.h"

static const int counts[] = {0, 1, 2, 7, 8, 9, 10, 11, 33};

#define LOOP(name, expression)                                                                \
  APART static void name(short* restrict z, const short* restrict x, const short* restrict y, \
                         int n, int k) {                                                      \
    (void)y, (void)k;                                                                         \
    for (int i = 0; i < n; i++)                                                               \
      z[i] = (short)(expression);                                                             \
  }
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
LOOP(gain, x[i] * 23170 >> 15)
LOOP(gain_of_least, x[i] * -32768 >> 15)
LOOP(upper, x[i] * -4321 >> 16)
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
                              gain,
                              gain_of_least,
                              upper,
                              half_sum,
                              distance,
                              unsigned_least,
                              index,
                              chosen,
                              mixed,
                              volatile_read};

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
  return 0;
}
