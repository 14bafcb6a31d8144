/* Every operator on int and on narrow types, with values that carry, wrap and change sign. */
#include "report.h"
static const int values[] = {0, 1, -1, 2, 7, -8, 100, 127, 128, 255, 256, -32768, 32767, 65535,
                             65536, 0x12345678, 0x7fffffff, (int)0x80000000u, -100000};
#define COUNT ((int)(sizeof values / sizeof values[0]))
__attribute__((noinline)) static unsigned int_ops(int a, int b) {
  unsigned s = 0, ua = (unsigned)a, ub = (unsigned)b;
  s = mix(s, ua + ub);
  s = mix(s, ua - ub);
  s = mix(s, ua * ub);
  s = mix(s, ua & ub);
  s = mix(s, ua | ub);
  s = mix(s, ua ^ ub);
  s = mix(s, ~ua);
  s = mix(s, -ua);
  s = mix(s, ua << (ub & 31));
  s = mix(s, ua >> (ub & 31));
  s = mix(s, (unsigned)(a >> (b & 31)));
  s = mix(s, (unsigned)(a < b) | (unsigned)(a <= b) << 1 | (unsigned)(ua < ub) << 2 |
                 (unsigned)(ua <= ub) << 3 | (unsigned)(a == b) << 4 | (unsigned)(a > b) << 5 |
                 (unsigned)(ua >= ub) << 6 | (unsigned)!a << 7);
  return s;
}
__attribute__((noinline)) static unsigned narrow_ops(signed char a, unsigned char b, short c,
                                                     unsigned short d) {
  unsigned s = 0;
  s = mix(s, (unsigned)(a * b));
  s = mix(s, (unsigned)(c * a));
  s = mix(s, (unsigned)c * d);
  s = mix(s, (unsigned)(signed char)(a + b));
  s = mix(s, (unsigned char)(a - c));
  s = mix(s, (unsigned)(short)(c + d));
  s = mix(s, (unsigned short)(c << 3));
  s = mix(s, (unsigned)(a >> 2));
  s = mix(s, (unsigned)(b >> 2));
  s = mix(s, (unsigned)(c < a));
  s = mix(s, (unsigned)(d > b));
  s = mix(s, (unsigned)d * d);
  return s;
}
int main(void) {
  unsigned sum = 0, narrow = 0;
  for (int i = 0; i < COUNT; i++)
    for (int j = 0; j < COUNT; j++) {
      sum = mix(sum, int_ops(values[i], values[j]));
      narrow = mix(narrow, narrow_ops((signed char)values[i], (unsigned char)values[j],
                                      (short)values[j], (unsigned short)values[i]));
    }
  report("int", sum);
  report("narrow", narrow);
  return 0;
}
