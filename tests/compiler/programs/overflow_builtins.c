/* __builtin_add_overflow and its like for every width and for results narrower or of other sign
 * than the operands. */
#include "report.h"

typedef signed char i8;
typedef unsigned char u8;
typedef short i16;
typedef unsigned short u16;
typedef int i32;
typedef unsigned u32;
typedef long long i64;
typedef unsigned long long u64;

static const i64 values[] = {0,
                             1,
                             -1,
                             2,
                             3,
                             100,
                             -100,
                             127,
                             -128,
                             255,
                             32767,
                             -32768,
                             65535,
                             46341,
                             2147483647,
                             -2147483648ll,
                             4294967295ll,
                             0x7fffffffffffffffll,
                             -0x7fffffffffffffffll - 1};
#define COUNT ((int)(sizeof values / sizeof *values))

#define OF(type)                                                                         \
  APART static unsigned of_##type(type a, type b) {                                      \
    type sum, difference, product;                                                       \
    unsigned flags = __builtin_add_overflow(a, b, &sum);                                 \
    flags |= (unsigned)__builtin_sub_overflow(a, b, &difference) << 1;                   \
    flags |= (unsigned)__builtin_mul_overflow(a, b, &product) << 2;                      \
    return mix_long(mix_long(mix_long(flags, (u64)sum), (u64)difference), (u64)product); \
  }
OF(i8)
OF(u8)
OF(i16)
OF(u16)
OF(i32)
OF(u32)
OF(i64)
OF(u64)

APART static unsigned into_others(int a, unsigned b) {
  u8 narrow;
  i64 wide;
  unsigned flags = __builtin_add_overflow(a, b, &narrow);
  flags |= (unsigned)__builtin_mul_overflow(a, b, &wide) << 1;
  unsigned same;
  flags |= (unsigned)__builtin_sub_overflow(a, a / 2, &same) << 2;
  return mix(mix_long(flags, (u64)wide), narrow) ^ same;
}

APART static int sum_until_overflow(const int* p, int n, int* sum) {
  *sum = 0;
  for (int i = 0; i < n; i++)
    if (__builtin_add_overflow(*sum, p[i], sum))
      return i;
  return n;
}
APART static unsigned factorial(unsigned n) {
  unsigned product = 1;
  while (n > 1)
    if (__builtin_umul_overflow(product, n--, &product))
      return 0;
  return product;
}

#define CHECK(type)                                              \
  {                                                              \
    unsigned s = 0;                                              \
    for (int i = 0; i < COUNT; i++)                              \
      for (int j = 0; j < COUNT; j++)                            \
        s = mix(s, of_##type((type)values[i], (type)values[j])); \
    report(#type, s);                                            \
  }

int main(void) {
  CHECK(i8)
  CHECK(u8)
  CHECK(i16)
  CHECK(u16)
  CHECK(i32)
  CHECK(u32)
  CHECK(i64)
  CHECK(u64)
  unsigned s = 0;
  for (int i = 0; i < COUNT; i++)
    for (int j = 0; j < COUNT; j++)
      s = mix(s, into_others((int)values[i], (unsigned)values[j]));
  report("others", s);
  static const int large[] = {1 << 30, 5, 1 << 29, 1 << 28, 1 << 29, 7};
  int sum;
  report("at", (unsigned)sum_until_overflow(large, 6, &sum));
  report("sum", (unsigned)sum);
  report("factorial", factorial(12) ^ factorial(13));
  return 0;
}
