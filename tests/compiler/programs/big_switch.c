/* A switch of some two hundred cases, with holes and shared bodies; a large sparse one; tables of
 * values that a switch of constants becomes. */
#include "report.h"

#define ONE(n)       \
  case n:            \
    x = x * 3 + (n); \
    break;
#define HOLE(n)
#define SHARED(n) case n:
#define EIGHT(n) \
  ONE(n) ONE(n + 1) ONE(n + 2) SHARED(n + 3) ONE(n + 4) HOLE(n + 5) ONE(n + 6) ONE(n + 7)
#define SIXTY_FOUR(n) \
  EIGHT(n)            \
  EIGHT(n + 8) EIGHT(n + 16) EIGHT(n + 24) EIGHT(n + 32) EIGHT(n + 40) EIGHT(n + 48) EIGHT(n + 56)

APART static unsigned dense(unsigned n, unsigned x) {
  switch (n) {
    SIXTY_FOUR(1000)
    SIXTY_FOUR(1064)
    SIXTY_FOUR(1128)
    default:
      x ^= 0xffff;
  }
  return x + n;
}

#define FAR(n)            \
  case (n) * (n)*37 + 11: \
    return n + x;
#define TEN(n)                                                                            \
  FAR(n)                                                                                  \
  FAR(n + 1) FAR(n + 2) FAR(n + 3) FAR(n + 4) FAR(n + 5) FAR(n + 6) FAR(n + 7) FAR(n + 8) \
      FAR(n + 9)
APART static int sparse(int n, int x) {
  switch (n) { TEN(0) TEN(10) TEN(20) TEN(30) }
  return -x;
}

APART static int days(int month, int leap) {
  switch (month) {
    case 2:
      return leap ? 29 : 28;
    case 4:
    case 6:
    case 9:
    case 11:
      return 30;
    case 1:
    case 3:
    case 5:
    case 7:
    case 8:
    case 10:
    case 12:
      return 31;
    default:
      return 0;
  }
}
APART static const char* name(int day) {
  switch (day) {
    case 0:
      return "sunday";
    case 1:
      return "monday";
    case 2:
      return "tuesday";
    case 3:
      return "wednesday";
    case 4:
      return "thursday";
    case 5:
      return "friday";
    case 6:
      return "saturday";
  }
  return "none";
}
APART static short half_words(int n) {
  switch (n) {
    case 10:
      return -300;
    case 11:
      return 5;
    case 12:
      return 32767;
    case 13:
      return -32768;
    case 15:
      return 99;
    case 16:
      return 98;
    case 17:
      return 3;
    case 18:
      return 1;
    case 19:
      return 1000;
  }
  return 77;
}
APART static unsigned bits(unsigned char n) {
  switch (n) {
    case 1:
    case 4:
    case 5:
    case 17:
    case 29:
    case 30:
      return 1;
    default:
      return 0;
  }
}

int main(void) {
  unsigned s = 0;
  for (unsigned n = 990; n < 1200; n++)
    s = dense(n, s);
  report("dense", dense(0, s) + dense(~0u, s));
  for (int n = 0; n < 41; n++) {
    s = mix(s, (unsigned)sparse(n * n * 37 + 11, n));
    s = mix(s, (unsigned)sparse(n * n * 37 + 12, n));
  }
  report("sparse", s);
  for (int i = -1; i < 34; i++) {
    s = mix(s, (unsigned)days(i, i & 1));
    s = mix(s, (unsigned char)name(i)[2]);
    s = mix(s, (unsigned)half_words(i) + bits((unsigned char)i));
  }
  report("tables", s);
  return 0;
}
