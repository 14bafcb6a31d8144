/* Conversions of edge values between integer types, _Bool among them: casts, stores, arguments and
 * results. */
#include "report.h"

typedef _Bool bit;
typedef signed char i8;
typedef unsigned char u8;
typedef short i16;
typedef unsigned short u16;
typedef int i32;
typedef unsigned u32;
typedef long long i64;
typedef unsigned long long u64;

static const i64 values[] = {
    0,
    1,
    -1,
    127,
    128,
    -128,
    -129,
    255,
    256,
    32767,
    32768,
    -32768,
    -32769,
    65535,
    65536,
    2147483647,
    1ll << 31,
    -(1ll << 31),
    4294967295ll,
    1ll << 32,
    -(1ll << 32),
    0x123456789abcdefll,
    1ll << 62,
};
#define COUNT ((int)(sizeof values / sizeof *values))

struct all {
  bit t;
  i8 a;
  u8 b;
  i16 c;
  u16 d;
  i32 e;
  u32 f;
  i64 g;
  u64 h;
};

/* From one type into all others. */
#define FROM(from)                                                                 \
  APART static void from_##from(struct all* to, from value) {                      \
    *to = (struct all){value,      (i8)value,  (u8)value,  (i16)value, (u16)value, \
                       (i32)value, (u32)value, (i64)value, (u64)value};            \
  }                                                                                \
  APART static i8 i8_of_##from(from value) { return (i8)value; }                   \
  APART static u16 u16_of_##from(from value) { return (u16)value; }                \
  APART static i64 i64_of_##from(from value) { return (i64)value; }

#define EACH(DO) DO(bit) DO(i8) DO(u8) DO(i16) DO(u16) DO(i32) DO(u32) DO(i64) DO(u64)
EACH(FROM)

static unsigned sum_of(const struct all* all) {
  unsigned s = mix(all->t, (unsigned)all->a);
  s = mix(mix(s, all->b), (unsigned)all->c);
  s = mix(mix(s, all->d), (unsigned)all->e);
  return mix_long(mix_long(mix(s, all->f), (u64)all->g), all->h);
}

#define CHECK(from)                                                     \
  {                                                                     \
    unsigned s = 0;                                                     \
    for (int i = 0; i < COUNT; i++) {                                   \
      from value = (from)values[i];                                     \
      struct all all;                                                   \
      from_##from(&all, value);                                         \
      s = mix(s, sum_of(&all));                                         \
      s = mix(s, (unsigned)i8_of_##from(value) + u16_of_##from(value)); \
      s = mix_long(s, (u64)i64_of_##from(value));                       \
    }                                                                   \
    report(#from, s);                                                   \
  }

int main(void) {
  EACH(CHECK)
  return 0;
}
