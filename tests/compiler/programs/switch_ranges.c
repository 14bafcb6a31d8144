/* Switches with GNU's ranges: short, long, adjacent, over the whole type, of characters and of
 * signs. */
#include "report.h"

APART static int kind(int c) {
  switch (c) {
    case '0' ... '9':
      return 1;
    case 'a' ... 'f':
    case 'A' ... 'F':
      return 2;
    case 'g' ... 'z':
      return 3;
    case ' ':
    case '\t' ... '\r':
      return 4;
    case 128 ... 255:
      return 5;
    default:
      return 0;
  }
}
APART static int signs(int x) {
  switch (x) {
    case -2147483647 - 1 ... - 1:
      return -1;
    case 0:
      return 0;
    case 1 ... 0x7fffffff:
      return 1;
  }
  return 99;
}
APART static int grade(unsigned char points) {
  switch (points) {
    case 0 ... 49:
      return 5;
    case 50 ... 64:
      return 4;
    case 65 ... 79:
      return 3;
    case 80 ... 89:
      return 2;
    case 90 ... 100:
      return 1;
    default:
      return 6;
  }
}
APART static unsigned bytes_of(unsigned code) {
  switch (code) {
    case 0 ... 0x7f:
      return 1;
    case 0x80 ... 0x7ff:
      return 2;
    case 0xd800 ... 0xdfff:
      return 0;
    case 0x800 ... 0xd7ff:
    case 0xe000 ... 0xffff:
      return 3;
    case 0x10000 ... 0x10ffff:
      return 4;
  }
  return 0;
}
APART static int fall(int x, int y) {
  switch (x) {
    case 10 ... 20:
      y += 1;
    case 21 ... 30:
      y *= 2;
      break;
    case 31:
      y = -y;
    case -5 ... - 1:
      y ^= 3;
    default:
      y += 100;
  }
  return y;
}
APART static int edges(unsigned x) {
  switch (x) {
    case 0xfffffff0u ... 0xffffffffu:
      return 1;
    case 0x80000000u ... 0x8000000fu:
      return 2;
    case 0 ... 15:
      return 3;
  }
  return 0;
}

int main(void) {
  unsigned s = 0;
  for (int c = -3; c < 260; c++) {
    s = mix(s, (unsigned)kind(c));
    s = mix(s, (unsigned)grade((unsigned char)c));
    s = mix(s, (unsigned)fall(c - 100, c));
    s = mix(s, bytes_of((unsigned)c * (unsigned)c * 19));
  }
  report("ranges", s);
  static const int edge[] = {-2147483647 - 1, -2147483647, -1, 0, 1, 0x7ffffffe, 0x7fffffff};
  for (int i = 0; i < 7; i++)
    s = mix(s, (unsigned)signs(edge[i]));
  report("signs", s);
  for (int i = -20; i < 20; i++)
    s = mix(s, (unsigned)(edges((unsigned)i) + edges(0x80000000u + (unsigned)i) * 4));
  report("edges", s);
  static const unsigned codes[] = {0x7f,   0x80,   0x7ff,  0x800,   0xd7ff,   0xd800,
                                   0xdfff, 0xe000, 0xffff, 0x10000, 0x10ffff, 0x110000};
  unsigned lengths = 0;
  for (int i = 0; i < 12; i++)
    lengths = lengths * 10 + bytes_of(codes[i]);
  report("lengths", lengths);
  return 0;
}
