/* Products of fixed point numbers, square roots, bilinear interpolation, a filter. */
#include "report.h"
typedef int q16;
__attribute__((noinline)) static q16 multiply(q16 a, q16 b) { return (q16)((long long)a * b >> 16); }
__attribute__((noinline)) static short multiply_fraction(short a, short b) { return (short)(a * b >> 15); }
__attribute__((noinline)) static q16 root(q16 x) {
  unsigned r = 0, bit = 1u << 30, n = (unsigned)x;
  while (bit > n) bit >>= 2;
  for (; bit; bit >>= 2)
    if (n >= r + bit) {
      n -= r + bit;
      r = (r >> 1) + bit;
    } else r >>= 1;
  return (q16)(r << 8);
}
__attribute__((noinline)) static int bilinear(const unsigned char *p, int width, int fx, int fy) {
  int top = p[0] * (256 - fx) + p[1] * fx, bottom = p[width] * (256 - fx) + p[width + 1] * fx;
  return (top * (256 - fy) + bottom * fy + 32768) >> 16;
}
static short taps[8] = {100, -300, 900, 15000, 15000, 900, -300, 100};
__attribute__((noinline)) static int filter(const short *x) {
  int sum = 0;
  for (int i = 0; i < 8; i++) sum += taps[i] * x[i];
  return sum >> 15;
}
int main(void) {
  unsigned state = 6, s = 0;
  unsigned char p[8];
  short x[40];
  for (int i = 0; i < 8; i++) p[i] = (unsigned char)next_number(&state);
  for (int i = 0; i < 40; i++) x[i] = (short)next_number(&state);
  for (int i = 0; i < 30; i++) {
    q16 left = (q16)(next_number(&state) << 7), right = (q16)next_number(&state) - 8000000;
    s = mix(s, (unsigned)multiply(left, right));
    s = mix(s, (unsigned)multiply_fraction(x[i], x[i + 1]));
    s = mix(s, (unsigned)root((q16)next_number(&state)));
    s = mix(s, (unsigned)bilinear(p, 4, i * 8, 256 - i * 5));
    s = mix(s, (unsigned)filter(x + i));
  }
  report("fixed", s);
  return 0;
}
