/* Comparisons of 64 bits: as values, as branches, as selections, against constants, of both signs.
 */
#include "report.h"

typedef unsigned long long u64;
typedef long long i64;

static const u64 values[] = {0,
                             1,
                             0x7fffffffull,
                             0x80000000ull,
                             0xffffffffull,
                             0x100000000ull,
                             0x100000001ull,
                             0x7fffffffffffffffull,
                             0x8000000000000000ull,
                             0x80000000ffffffffull,
                             0xffffffff00000000ull,
                             0xffffffffffffffffull};
#define COUNT ((int)(sizeof values / sizeof *values))

APART static unsigned truths(i64 a, i64 b) {
  u64 x = (u64)a, y = (u64)b;
  return (unsigned)((a < b) | (a <= b) << 1 | (a == b) << 2 | (a != b) << 3 | (x < y) << 4 |
                    (x <= y) << 5 | (a > b) << 6 | (x >= y) << 7);
}
APART static int branches(i64 a, u64 b) {
  int taken = 0;
  if (a < 0)
    taken += 1;
  if (a > (i64)b)
    taken += 2;
  if ((u64)a > b)
    taken += 4;
  if (a == 0 || b == 1)
    taken += 8;
  if (!(a & 1) && (b >> 32))
    taken += 16;
  if ((a ^ (i64)b) < 0)
    taken += 32;
  while (taken < 64 && (u64)taken < b)
    taken += 64;
  return taken;
}
APART static u64 larger(u64 a, u64 b) { return a > b ? a : b; }
APART static i64 smaller(i64 a, i64 b) { return a < b ? a : b; }
APART static i64 clamped(i64 a) { return a < -1000 ? -1000 : a > 5000000000ll ? 5000000000ll : a; }
APART static int order(i64 a, i64 b) { return (a > b) - (a < b); }
APART static u64 distance(u64 a, u64 b) { return a > b ? a - b : b - a; }
APART static unsigned constants(i64 a) {
  return (unsigned)((a < 1) | (a >= 0x7fffffffll) << 1 | (a == -1) << 2 | (a > 0xffffffffll) << 3 |
                    ((u64)a < 0x100000000ull) << 4 | ((u64)a > 0xfffffffffffffffeull) << 5 |
                    (a <= -0x7fffffffffffffffll) << 6 | (a == (int)a) << 7);
}
APART static int mixed(i64 a, int b, unsigned c) {
  return (a < b) | (a > c) << 1 | (a == b) << 2 | ((u64)a == c) << 3;
}

int main(void) {
  unsigned s = 0, chosen = 0;
  for (int i = 0; i < COUNT; i++) {
    for (int j = 0; j < COUNT; j++) {
      u64 a = values[i], b = values[j];
      s = mix(s, truths((i64)a, (i64)b));
      s = mix(s, (unsigned)branches((i64)a, b));
      s = mix(s, (unsigned)mixed((i64)a, (int)b, (unsigned)b));
      s = mix(s, (unsigned)order((i64)a, (i64)b));
      chosen = mix_long(chosen, larger(a, b));
      chosen = mix_long(chosen, (u64)smaller((i64)a, (i64)b));
      chosen = mix_long(chosen, distance(a, b));
    }
    s = mix(s, constants((i64)values[i]));
    chosen = mix_long(chosen, (u64)clamped((i64)values[i]));
  }
  report("compared", s);
  report("chosen", chosen);
  return 0;
}
