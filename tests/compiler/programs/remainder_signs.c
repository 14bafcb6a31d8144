/* Signs of quotients and remainders for variables of every width, and what is made of them: floors,
 * moduli, greatest common divisors. */
#include "report.h"

static const int numbers[] = {0,  1,   -1,   2,   -2,   3,   -3,   7,
                              -7, 100, -100, 127, -128, 255, 4096, -4097};
#define COUNT ((int)(sizeof numbers / sizeof *numbers))

#define OF(type)                                                                             \
  APART static unsigned of_##type(type a, type b) {                                          \
    return mix((unsigned)(a / b), (unsigned)(a % b)) + (unsigned)((a / b) * b + a % b == a); \
  }
typedef signed char i8;
typedef unsigned char u8;
typedef short i16;
typedef unsigned short u16;
typedef int i32;
typedef unsigned u32;
typedef long long i64;
OF(i8)
OF(u8)
OF(i16)
OF(u16)
OF(i32)
OF(u32)
OF(i64)

APART static int floor_divide(int a, int b) { return a / b - (a % b != 0 && (a < 0) != (b < 0)); }
APART static int modulus(int a, int b) {
  int r = a % b;
  return r < 0 ? r + (b < 0 ? -b : b) : r;
}
APART static int rounded(int a, int b) { return (a + (a < 0 ? -b / 2 : b / 2)) / b; }
APART static unsigned divisor(unsigned a, unsigned b) {
  while (b != 0) {
    unsigned rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}
APART static int both(int a, int b, int* rest) {
  *rest = a % b;
  return a / b;
}

#define CHECK(type)                                                  \
  {                                                                  \
    unsigned s = 0;                                                  \
    for (int i = 0; i < COUNT; i++)                                  \
      for (int j = 0; j < COUNT; j++)                                \
        if ((type)numbers[j] != 0)                                   \
          s = mix(s, of_##type((type)numbers[i], (type)numbers[j])); \
    report(#type, s);                                                \
  }

int main(void) {
  CHECK(i8)
  CHECK(u8)
  CHECK(i16)
  CHECK(u16)
  CHECK(i32)
  CHECK(u32)
  CHECK(i64)
  unsigned s = 0;
  for (int i = 0; i < COUNT; i++)
    for (int j = 1; j < COUNT; j++) {
      int a = numbers[i] * 1001, b = numbers[j], rest;
      s = mix(s, (unsigned)floor_divide(a, b));
      s = mix(s, (unsigned)modulus(a, b));
      s = mix(s, (unsigned)rounded(a, b));
      s = mix(s, divisor((unsigned)a, (unsigned)b));
      s = mix(s, (unsigned)both(a, b, &rest) + (unsigned)rest);
    }
  report("made", s);
  report("least", (unsigned)floor_divide(-2147483647 - 1, 2));
  report("least", (unsigned)floor_divide(-2147483647 - 1, 2147483647));
  report("least", of_i8(-128, -1) + of_i16(-32768, -1));
  return 0;
}
