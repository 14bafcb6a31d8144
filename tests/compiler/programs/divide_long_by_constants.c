/* Division and remainder of 64 bits by constants and by what fits 32 bits or 16. */
#include "report.h"

typedef unsigned long long u64;
typedef long long i64;

static const u64 values[] = {0,
                             1,
                             9,
                             10,
                             4294967295ull,
                             4294967296ull,
                             4294967297ull,
                             999999999999ull,
                             0x7fffffffffffffffull,
                             0x8000000000000000ull,
                             0x8000000000000001ull,
                             0xfffffffffffffff6ull,
                             ~0ull};
#define COUNT ((int)(sizeof values / sizeof *values))

#define BY(d)                                             \
  APART static unsigned by_##d(u64 x) {                   \
    unsigned s = mix_long(mix_long(0, x / d), x % d);     \
    s = mix_long(s, (u64)((i64)x / d));                   \
    return mix_long(s, (u64)((i64)x % d)) + (x % d == 0); \
  }
#define EACH(DO) DO(3) DO(8) DO(10) DO(1000) DO(4096) DO(1000000) DO(10000000000)
EACH(BY)

APART static unsigned by_word(u64 x, unsigned d) { return mix_long(mix_long(0, x / d), x % d); }
APART static unsigned by_half(i64 x, short d) {
  return mix_long(mix_long(0, (u64)(x / d)), (u64)(x % d));
}
APART static unsigned of_word(unsigned x, u64 d) { return mix_long(mix_long(0, x / d), x % d); }
APART static unsigned of_int(int x, i64 d) {
  return mix_long(mix_long(0, (u64)(x / d)), (u64)(x % d));
}

static unsigned digits(u64 x) {
  unsigned s = 0;
  do {
    s = mix(s, (unsigned)(x % 10));
    x /= 10;
  } while (x != 0);
  return s;
}

#define CHECK(d)                     \
  {                                  \
    unsigned s = 0;                  \
    for (int i = 0; i < COUNT; i++)  \
      s = mix(s, by_##d(values[i])); \
    report(#d, s);                   \
  }

int main(void) {
  EACH(CHECK)
  unsigned s = 0;
  for (int i = 0; i < COUNT; i++) {
    s = mix(s, by_word(values[i], 641));
    s = mix(s, by_word(values[i], 0x80000001u));
    s = mix(s, by_half((i64)values[i], 1000));
    s = mix(s, by_half((i64)values[i], -3));
    s = mix(s, of_word((unsigned)values[i], 1000));
    s = mix(s, of_word((unsigned)values[i], 1ull << 33));
    s = mix(s, of_int((int)values[i], -7));
    s = mix(s, digits(values[i]));
  }
  report("variable", s);
  return 0;
}
