/* Products wider than a register: 16 by 16 to 32, 32 by 32 to 64, upper halves, 64 by 64, squares,
 * sums of products, and 128 bits out of pieces. */
#include "report.h"

typedef unsigned long long u64;
typedef long long i64;

static const unsigned values[] = {0,           1,           2,           0x7fff,     0x8000,
                                  0xffff,      0x10000,     0x10001,     0x7fffffff, 0x80000000u,
                                  0x80000001u, 0xfffffffeu, 0xffffffffu, 0x12345678};
#define COUNT ((int)(sizeof values / sizeof *values))

APART static i64 signed_wide(int a, int b) { return (i64)a * b; }
APART static u64 unsigned_wide(unsigned a, unsigned b) { return (u64)a * b; }
APART static i64 mixed_wide(int a, unsigned b) { return (i64)a * (i64)b; }
APART static int high(int a, int b) { return (int)((i64)a * b >> 32); }
APART static unsigned high_unsigned(unsigned a, unsigned b) { return (unsigned)((u64)a * b >> 32); }
APART static int rounded(int a, int b) { return (int)(((i64)a * b + (1 << 30)) >> 31); }
APART static int halves(short a, unsigned short b) { return a * (b >> 1); }
APART static u64 full(u64 a, u64 b) { return a * b; }
APART static i64 by_short(i64 a, short b) { return (i64)((u64)a * (u64)(i64)b); }
APART static i64 accumulated(i64 sum, int a, int b) { return (i64)((u64)sum + (u64)((i64)a * b)); }
APART static u64 square(unsigned a) { return (u64)a * a; }

struct two {
  u64 low, high;
};
APART static struct two wide(u64 a, u64 b) {
  u64 low = (u64)(unsigned)a * (unsigned)b, middle = (a >> 32) * (unsigned)b,
      other = (unsigned)a * (b >> 32);
  u64 carry = (low >> 32) + (unsigned)middle + (unsigned)other;
  return (struct two){carry << 32 | (unsigned)low,
                      (a >> 32) * (b >> 32) + (middle >> 32) + (other >> 32) + (carry >> 32)};
}
APART static u64 by_constants(u64 a) { return a * 3 + a * 10 - a * 0x100000001ull + a * 7 / 2; }
APART static u64 hash(const unsigned char* text, int length) {
  u64 h = 0xcbf29ce484222325ull;
  for (int i = 0; i < length; i++)
    h = (h ^ text[i]) * 0x100000001b3ull;
  return h;
}

int main(void) {
  unsigned s = 0, wide_sum = 0;
  i64 sum = 0;
  for (int i = 0; i < COUNT; i++)
    for (int j = 0; j < COUNT; j++) {
      unsigned a = values[i], b = values[j];
      s = mix_long(s, (u64)signed_wide((int)a, (int)b));
      s = mix_long(s, unsigned_wide(a, b));
      s = mix_long(s, (u64)mixed_wide((int)a, b));
      s = mix(s, (unsigned)high((int)a, (int)b) ^ high_unsigned(a, b));
      s = mix(s, (unsigned)rounded((int)a, (int)b / 2));
      s = mix(s, (unsigned)halves((short)a, (unsigned short)b));
      u64 x = (u64)a << 32 | b, y = (u64)b << 20 ^ a;
      s = mix_long(s, full(x, y) + square(a));
      s = mix_long(s, (u64)by_short((i64)x, (short)b));
      sum = accumulated(sum, (int)a, (int)b);
      struct two product = wide(x, y);
      wide_sum = mix_long(mix_long(wide_sum, product.low), product.high);
      wide_sum = mix_long(wide_sum, by_constants(x));
    }
  report("products", s);
  report("sum", mix_long(0, (u64)sum));
  report("wide", wide_sum);
  report("hash", mix_long(0, hash((const unsigned char*)"finback", 7)));
  return 0;
}
