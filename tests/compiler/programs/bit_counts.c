/* The counting builtins of 32 and 64 bits, and the loops and tricks that programs count, find,
 * reverse and spread bits with. */
#include "report.h"

typedef unsigned long long u64;

APART static unsigned of_word(unsigned x) {
  unsigned s = (unsigned)__builtin_popcount(x) * 3 + (unsigned)__builtin_parity(x);
  s = mix(s, x == 0 ? 99 : (unsigned)(__builtin_clz(x) * 64 + __builtin_ctz(x)));
  s = mix(s, (unsigned)__builtin_ffs((int)x) + (unsigned)__builtin_clrsb((int)x) * 100);
  return mix(s, __builtin_bswap32(x) ^ __builtin_bswap16((unsigned short)x));
}
APART static unsigned of_long(u64 x) {
  unsigned s = (unsigned)__builtin_popcountll(x) * 3 + (unsigned)__builtin_parityll(x);
  s = mix(s, x == 0 ? 99 : (unsigned)(__builtin_clzll(x) * 64 + __builtin_ctzll(x)));
  s = mix(
      s, (unsigned)__builtin_ffsll((long long)x) + (unsigned)__builtin_clrsbll((long long)x) * 100);
  return mix_long(s, __builtin_bswap64(x));
}
APART static int ones_one_by_one(unsigned x) {
  int n = 0;
  for (; x != 0; x &= x - 1)
    n++;
  return n;
}
APART static int ones_by_table(unsigned x) {
  static const unsigned char table[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
  int n = 0;
  for (int i = 0; i < 32; i += 4)
    n += table[x >> i & 15];
  return n;
}
APART static unsigned ones_in_parallel(unsigned x) {
  x -= x >> 1 & 0x55555555;
  x = (x & 0x33333333) + (x >> 2 & 0x33333333);
  return ((x + (x >> 4)) & 0x0f0f0f0f) * 0x01010101u >> 24;
}
APART static unsigned reversed(unsigned x) {
  x = (x & 0x55555555) << 1 | (x >> 1 & 0x55555555);
  x = (x & 0x33333333) << 2 | (x >> 2 & 0x33333333);
  x = (x & 0x0f0f0f0f) << 4 | (x >> 4 & 0x0f0f0f0f);
  return x << 24 | (x & 0xff00) << 8 | (x >> 8 & 0xff00) | x >> 24;
}
APART static unsigned reversed_by_loop(unsigned x, int bits) {
  unsigned r = 0;
  while (bits-- > 0) {
    r = r << 1 | (x & 1);
    x >>= 1;
  }
  return r;
}
APART static int logarithm(unsigned x) {
  int n = -1;
  while (x != 0) {
    x >>= 1;
    n++;
  }
  return n;
}
APART static unsigned next_power(unsigned x) {
  x--;
  x |= x >> 1;
  x |= x >> 2;
  x |= x >> 4;
  x |= x >> 8;
  x |= x >> 16;
  return x + 1;
}
APART static unsigned spread(unsigned short x) {
  unsigned v = x;
  v = (v | v << 8) & 0x00ff00ff;
  v = (v | v << 4) & 0x0f0f0f0f;
  v = (v | v << 2) & 0x33333333;
  return (v | v << 1) & 0x55555555;
}
APART static unsigned gray(unsigned x) { return x ^ x >> 1; }
APART static unsigned from_gray(unsigned x) {
  for (unsigned shift = 1; shift < 32; shift *= 2)
    x ^= x >> shift;
  return x;
}
APART static int has_zero_byte(unsigned x) { return ((x - 0x01010101) & ~x & 0x80808080) != 0; }

int main(void) {
  unsigned state = 77, builtins = 0, tricks = 0;
  for (int i = 0; i < 70; i++) {
    unsigned x = i < 32    ? 1u << i
                 : i < 64  ? ~0u >> (i - 32)
                 : i == 64 ? 0
                           : next_number(&state) * 40503u;
    builtins = mix(builtins, of_word(x));
    builtins = mix(builtins, of_long((u64)x << (i & 31) | (u64)(i & 4)));
    tricks = mix(tricks, (unsigned)(ones_one_by_one(x) + 100 * ones_by_table(x)) +
                             10000 * ones_in_parallel(x));
    tricks = mix(tricks, reversed(x) ^ reversed_by_loop(x, 32 - (i & 7)));
    tricks = mix(tricks, (unsigned)logarithm(x) + next_power(x));
    tricks = mix(tricks, spread((unsigned short)x) ^ from_gray(gray(x) + 1));
    tricks = mix(tricks, (unsigned)has_zero_byte(x));
  }
  report("builtins", builtins);
  report("tricks", tricks);
  return 0;
}
