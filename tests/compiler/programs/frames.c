/* Locals in frames: none, small, deep in recursion, with addresses handed on. */
#include "report.h"
__attribute__((noinline)) static unsigned fill(unsigned char *p, int n, unsigned seed) {
  for (int i = 0; i < n; i++) p[i] = (unsigned char)next_number(&seed);
  return seed;
}
__attribute__((noinline)) static unsigned small_frame(int n) {
  unsigned char a[40];
  int b[10];
  fill(a, 40, (unsigned)n);
  for (int i = 0; i < 10; i++) b[i] = a[i * 4] - a[39 - i];
  unsigned s = 0;
  for (int i = 0; i < 10; i++) s = mix(s, (unsigned)b[(i * 7) % 10]);
  return s;
}
__attribute__((noinline)) static unsigned many_values(int a, int b, int c, int d, int e, int f, int g, int h, int i, int j) {
  int k = a * b + c, l = d - e * f, m = g ^ h, n = i | j, o = a + j, p = b - i, q = c * h, r = d & g;
  unsigned s = 0;
  for (int t = 0; t < 3; t++) {
    s = mix(s, (unsigned)(k * t + l));
    s = mix(s, (unsigned)(m - n * t));
    s = mix(s, (unsigned)(o + p * q));
    s = mix(s, (unsigned)(r ^ a ^ f));
    s = mix(s, (unsigned)(e * h - i + t));
    k += n, l -= o, m ^= p, q += r;
  }
  return mix(s, (unsigned)(k + l + m + n + o + p + q + r));
}
__attribute__((noinline)) static unsigned variable(int n) {
  int a[n];
  for (int i = 0; i < n; i++) a[i] = i * i;
  unsigned s = fill((unsigned char *)a, n, 4);
  for (int i = 0; i < n; i++) s = mix(s, (unsigned)a[i]);
  return mix(s, many_values(n, 2, 3, 4, 5, 6, 7, 8, 9, a[n / 2]));
}
int main(void) {
  report("small", small_frame(5));
  report("many", many_values(1, -2, 3, -4, 5, -6, 7, -8, 9, -10));
  report("variable", variable(17));
  return 0;
}
