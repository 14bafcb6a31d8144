/* Loops over 16-bit arrays that the compiler takes two elements at a time, where the arrays overlap
 * by any distance, lie in rows of odd and even length, or give their least and greatest; and loops
 * that must go one by one. */
#include "halves.h"

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

APART static int greatest(const short* x, int n, int least) {
  for (int i = 0; i < n; i++)
    least = MOST(x[i], least);
  return least;
}
APART static unsigned extremes(const short* x, const short* y, short* restrict z, int n) {
  short low = 32767, high = -32768;
  int apart = -5;
  for (int i = 0; i < n; i++) {
    low = LEAST(x[i], low);
    high = MOST(y[i], high);
    z[i] = (short)(x[i] >> 1);
    apart = MOST(apart, z[i] - 3);
  }
  return ((unsigned)low << 16) + (unsigned)(high + apart);
}
APART static int least_of_amounts(const short* x, int n) {
  short found = 9999;
  for (int i = 0; i < n; i++)
    if (half(MAGNITUDE(x[i])) < found)
      found = half(MAGNITUDE(x[i]));
  return found;
}

int main(void) {
  fill();
  for (int n = 0; n < 40; n += n < 12 ? 1 : 13) {
    unsigned sum = 0;
    for (int apart = 0; apart < 8; apart++) {
      overlapping(a + apart, a + 4, b, n), sum = result(sum);
      overlapping(a + 3, b, a + apart, n), sum = result(sum);
      in_place(a + apart, a + 2, (unsigned)n), sum = result(sum);
      two_results(c, a + 40, a + apart, n), sum = result(sum);
      sum = mix(sum, (unsigned)greatest(a + apart, n, edges[apart] / 3));
      sum = mix(sum, (unsigned)greatest(b + apart, n, -40000 + apart));
      sum = mix(sum, extremes(a + apart, b, c, n)), sum = result(sum);
      sum = mix(sum, (unsigned)least_of_amounts(a + apart, n));
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
