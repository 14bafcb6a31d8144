/* Switches over every type: 64 bits, enumerations, bit-fields,
 * expressions; cases far apart, cases at both ends of the type. */
#include "report.h"

typedef long long i64;
typedef unsigned long long u64;
enum colour { red = -3, green, blue = 40000, violet = 0x7fffffff };
struct fields {
  unsigned three : 3;
  int four : 4;
};

APART static int of_long(i64 x) {
  switch (x) {
    case 0:
      return 1;
    case 1:
      return 2;
    case 0x100000000ll:
      return 3;
    case 0x100000001ll:
      return 4;
    case -1:
      return 5;
    case -0x7fffffffffffffffll - 1:
      return 6;
    case 0x7fffffffffffffffll:
      return 7;
    case 0xffffffffll:
      return 8;
    default:
      return 0;
  }
}
APART static int dense_long(u64 x) {
  switch (x) {
    case 0x500000000ull:
      return 10;
    case 0x500000001ull:
      return 21;
    case 0x500000002ull:
      return 32;
    case 0x500000003ull:
      return 43;
    case 0x500000004ull:
      return 54;
    case 0x500000005ull:
      return 66;
    case 0x500000006ull:
      return 70;
    case 0x500000007ull:
      return 81;
    case 0x500000008ull:
      return 97;
    case 0x500000009ull:
      return 103;
  }
  return -1;
}
APART static int of_colour(enum colour c) {
  switch (c) {
    case red:
      return 1;
    case green:
      return 2;
    case blue:
      return 3;
    case violet:
      return 4;
  }
  return 5;
}
APART static int of_field(struct fields f) {
  int n = 0;
  switch (f.three) {
    case 7:
      n += 1;
    case 5:
      n += 2;
      break;
    case 0:
      n += 4;
  }
  switch (f.four) {
    case -8:
      return n + 10;
    case 7:
      return n + 20;
    case -1:
      return n + 30;
  }
  return n;
}
APART static int of_expression(int x, short y) {
  switch (x * 3 - y % 5) {
    case -4:
      return y;
    case 3 * 7 + 1:
      return x;
    case sizeof(int) + 1:
      return x + y;
    case 'A' - 'B':
      return 1000;
  }
  return x - y;
}

int main(void) {
  static const i64 longs[] = {0,
                              1,
                              -1,
                              0x100000000ll,
                              0x100000001ll,
                              0x100000002ll,
                              -0x7fffffffffffffffll - 1,
                              0x7fffffffffffffffll,
                              0xffffffffll,
                              0x80000000ll};
  unsigned s = 0;
  for (int i = 0; i < 10; i++) {
    s = mix(s, (unsigned)of_long(longs[i]));
  }
  report("far", s);
  for (int i = -2; i < 12; i++)
    s = mix(s, (unsigned)(dense_long(0x500000000ull + (u64)(i64)i) + dense_long((u64)i)));
  report("dense", s);
  for (int i = -128; i < 128; i++) {
    s = mix(s, (unsigned)of_field((struct fields){.three = (unsigned)i & 7, .four = i % 8}));
    s = mix(s, (unsigned)of_expression(i / 3, (short)(i * 7)));
  }
  report("narrow", s);
  static const enum colour colours[] = {red, green, blue, violet};
  for (int i = 0; i < 4; i++)
    s = mix(s, (unsigned)of_colour(colours[i]));
  report("colours", s);
  return 0;
}
