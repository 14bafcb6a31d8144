/* Rotations as idioms: of 8, 16, 32 and 64 bits, both ways, by constants and variables, and where
 * only half of the idiom stands. */
#include "report.h"

typedef unsigned char u8;
typedef unsigned short u16;
typedef unsigned long long u64;

#define BY(n)                                                                   \
  APART static unsigned by_##n(unsigned x, u64 y) {                             \
    u16 h = (u16)x;                                                             \
    u8 b = (u8)x;                                                               \
    unsigned s = x << n | x >> (32 - n);                                        \
    s = mix_long(s, y << n | y >> (64 - n));                                    \
    s = mix_long(s, y >> (n + 30) | y << (34 - n));                             \
    s = mix(s, (u16)((unsigned)h << (n & 15) | h >> ((16 - n) & 15)));          \
    return mix(s, (u8)((unsigned)b >> (n & 7) | (unsigned)b << ((8 - n) & 7))); \
  }
BY(1)
BY(5)
BY(8)
BY(16)
BY(24)
BY(31)

APART static unsigned left(unsigned x, unsigned n) { return x << (n & 31) | x >> (-n & 31); }
APART static unsigned right(unsigned x, int n) { return x >> (n & 31) | x << (-n & 31); }
APART static u16 left16(u16 x, unsigned n) { return (u16)(x << (n & 15) | x >> (-n & 15)); }
APART static u8 right8(u8 x, unsigned n) { return (u8)(x >> (n & 7) | x << (-n & 7)); }
APART static unsigned half(unsigned x, unsigned y) { return x << 9 | y >> 23; }
APART static unsigned added(unsigned x) { return (x << 13) + (x >> 19); }
APART static unsigned rotated_sum(const unsigned* p, int n) {
  unsigned s = 1;
  for (int i = 0; i < n; i++)
    s = left(s, 7) ^ p[i];
  return s;
}
APART static unsigned swap_halves(unsigned x) { return x >> 16 | x << 16; }
APART static unsigned cyclic_distance(unsigned x, unsigned y) {
  for (unsigned n = 0; n < 32; n++)
    if (left(x, n) == y)
      return n;
  return 32;
}

int main(void) {
  unsigned s = 0, state = 4, numbers[20];
  for (int i = 0; i < 20; i++) {
    unsigned x = next_number(&state) << 8 | (unsigned)i, y = next_number(&state);
    u64 wide = (u64)x << 32 | y;
    numbers[i] = x;
    s = mix(mix(s, by_1(x, wide)), by_5(x, wide));
    s = mix(mix(s, by_8(x, wide)), by_16(x, wide));
    s = mix(mix(s, by_24(x, wide)), by_31(x, wide));
    for (unsigned n = 0; n < 40; n += 3) {
      s = mix(s, left(x, n) + right(y, (int)n));
      s = mix(s, left16((u16)x, n) + 65536u * right8((u8)y, n));
    }
    s = mix(s, half(x, y) ^ added(y));
    s = mix(s, cyclic_distance(x, swap_halves(x)));
  }
  report("rotations", s);
  report("sum", rotated_sum(numbers, 20));
  return 0;
}
