/* Division and remainder of 32 bits by constants: powers of two, neighbours of them, primes,
 * negative ones; multiples are told from others. */
#include "report.h"

static const unsigned values[] = {0,           1,           2,          6,           7,
                                  9,           10,          99,         100,         641,
                                  999,         1000,        65535,      65536,       65537,
                                  1000000007,  0x7ffffffe,  0x7fffffff, 0x80000000u, 0x80000001u,
                                  0xfffffff6u, 0xfffffffeu, 0xffffffffu};
#define COUNT ((int)(sizeof values / sizeof *values))

#define BY(d)                                                               \
  APART static unsigned signed_by_##d(int x) {                              \
    return mix(mix((unsigned)(x / d), (unsigned)(x % d)),                   \
               mix((unsigned)(x / -d), (unsigned)(x % -d)) + (x % d == 0)); \
  }                                                                         \
  APART static unsigned unsigned_by_##d(unsigned x) {                       \
    return mix(mix(x / d##u, x % d##u), x % d##u == 1);                     \
  }                                                                         \
  APART static unsigned narrow_by_##d(unsigned x) {                         \
    short h = (short)x;                                                     \
    unsigned char b = (unsigned char)x;                                     \
    return mix(mix((unsigned)(h / d), (unsigned)(h % d)),                   \
               mix((unsigned)(b / d), (unsigned)((signed char)b % d)));     \
  }

#define EACH(DO)                                                                                  \
  DO(2)                                                                                           \
  DO(3) DO(5) DO(7) DO(10) DO(13) DO(16) DO(25) DO(60) DO(100) DO(127) DO(641) DO(1000) DO(65537) \
      DO(1073741824) DO(2147483647)

EACH(BY)

#define CHECK(d)                                 \
  {                                              \
    unsigned s = 0;                              \
    for (int i = 0; i < COUNT; i++) {            \
      s = mix(s, signed_by_##d((int)values[i])); \
      s = mix(s, unsigned_by_##d(values[i]));    \
      s = mix(s, narrow_by_##d(values[i]));      \
    }                                            \
    report(#d, s);                               \
  }

int main(void) {
  EACH(CHECK)
  return 0;
}
