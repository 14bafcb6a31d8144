/* The counting builtins of 32 bits, swaps of bytes, single bits; a CRC bit by bit. */
#include "report.h"
__attribute__((noinline)) static unsigned twiddle(unsigned x) {
  unsigned s = 0;
  s = mix(s, (unsigned)__builtin_popcount(x));
  s = mix(s, x ? (unsigned)__builtin_clz(x) : 32);
  s = mix(s, x ? (unsigned)__builtin_ctz(x) : 32);
  s = mix(s, __builtin_bswap32(x));
  s = mix(s, __builtin_bswap16((unsigned short)x));
  s = mix(s, x << 7 | x >> 25);
  s = mix(s, (unsigned)__builtin_parity(x));
  s = mix(s, (unsigned)__builtin_ffs((int)x));
  s = mix(s, x & (x - 1));
  s = mix(s, (x & 0x10) ? x | 0x400000 : x & ~0x800u);
  s = mix(s, x ^ 0x80000000u);
  return s;
}
__attribute__((noinline)) static unsigned crc(const unsigned char *p, unsigned n) {
  unsigned c = ~0u;
  while (n--) {
    c ^= *p++;
    for (int k = 0; k < 8; k++) c = c & 1 ? c >> 1 ^ 0xedb88320u : c >> 1;
  }
  return ~c;
}
int main(void) {
  unsigned state = 3, s = 0;
  for (int i = 0; i < 200; i++) s = mix(s, twiddle(next_number(&state) << (i & 15)));
  report("twiddle", s);
  report("crc", crc((const unsigned char *)"123456789", 9));
  return 0;
}
