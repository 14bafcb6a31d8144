/* The usual arithmetic conversions: the type of a sum for pairs of integer types, and the sums,
 * products and comparisons themselves, where signs decide. */
#include "report.h"

#define TYPE_OF(value) \
  _Generic((value), int : 1, unsigned : 2, long long : 3, unsigned long long : 4, default : 99)

typedef signed char i8;
typedef unsigned char u8;
typedef short i16;
typedef unsigned short u16;
typedef int i32;
typedef unsigned u32;
typedef long long i64;
typedef unsigned long long u64;

static const int small[] = {-128, -7, -1, 0, 1, 100, 127};
#define COUNT ((int)(sizeof small / sizeof *small))

#define PAIR(left, right)                                                   \
  APART static unsigned left##_##right(left a, right b) {                   \
    unsigned s = TYPE_OF(a + b) + 10 * TYPE_OF(a << b) + 100 * TYPE_OF(~b); \
    s = mix_long(s, (u64)(a + b));                                          \
    s = mix(s, (unsigned)((a - b) * 3 ^ a * (b & 63)));                     \
    return s ^ (unsigned)((a < b) | (a == b) << 1 | (-a >= b) << 2);        \
  }

#define CHECK(left, right)                                    \
  {                                                           \
    unsigned s = 0;                                           \
    for (int i = 0; i < COUNT; i++)                           \
      for (int j = 0; j < COUNT; j++)                         \
        s += left##_##right((left)small[i], (right)small[j]); \
    report(#left " " #right, s);                              \
  }

#define EACH_PAIR(DO)                                                                      \
  DO(i8, u8)                                                                               \
  DO(u8, i16)                                                                              \
  DO(u16, i16) DO(u16, u16) DO(i8, i32) DO(u8, u32) DO(i16, u32) DO(u32, i32) DO(i64, u32) \
      DO(u32, i64) DO(i16, u64) DO(u64, i32) DO(i64, u64) DO(u8, i64)

EACH_PAIR(PAIR)

int main(void) {
  EACH_PAIR(CHECK)
  return 0;
}
