/* Nested conditions, jumps backwards, exits out of loops, chains of else. */
#include "report.h"
__attribute__((noinline)) static int nested(int a, int b, int c) {
  if (a > b) {
    if (b > c) return 1;
    if (a > c) return 2;
    return 3;
  }
  if (a > c || (b < 5 && c > 7)) return 4;
  return b > c && a != 0 ? 5 : c % 3 ? 6 : 7;
}
__attribute__((noinline)) static int jumps(int n) {
  int s = 0, i = 0;
again:
  s += i;
  if (++i < n) {
    if (s > 40) goto out;
    goto again;
  }
  s = -s;
out:
  return s;
}
__attribute__((noinline)) static int collatz(unsigned n) {
  int steps = 0;
  for (; n != 1; steps++) n = n & 1 ? 3 * n + 1 : n / 2;
  return steps;
}
__attribute__((noinline)) static int clamp(int x, int low, int high) { return x < low ? low : x > high ? high : x; }
__attribute__((noinline)) static unsigned logical(int a, int b) { return (unsigned)((a && b) + 2 * (a || b) + 4 * !a + 8 * (a == 0 && b != 0)); }
int main(void) {
  unsigned s = 0;
  for (int a = -1; a < 9; a += 3)
    for (int b = -1; b < 9; b += 2)
      for (int c = 0; c < 10; c += 4) s = mix(s, (unsigned)(nested(a, b, c) + clamp(a * b, c, 20)) + logical(a, b));
  for (int i = 0; i < 20; i++) s = mix(s, (unsigned)jumps(i));
  for (unsigned i = 1; i < 30; i++) s = mix(s, (unsigned)collatz(i));
  report("flow", s);
  return 0;
}
