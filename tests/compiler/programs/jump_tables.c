/* Switches big enough for tables: dense, with holes, from a negative number, in loops, nested. */
#include "report.h"

static unsigned calls;

static int count(int value) {
  calls++;
  return value;
}

static int dense(int n) {
  switch (n) {
    case 0: return count(5);
    case 1: return 1 - n;
    case 2: return count(77) * n;
    case 3: return n << 3;
    case 4: return count(9);
    case 5: return n * n * n;
    case 6: return count(2);
    case 7: return -n;
    case 8: return n ^ 99;
    case 9: return count(3);
    default: return 0;
  }
}

static int with_holes(int n) {
  int result = 1;
  switch (n) {
    case -7: result += count(1); /* falls through */
    case -6: result *= 3; break;
    case -4: result = count(6); break;
    case -3: result = 12; break;
    case -1: result -= 8; break;
    case 0:
    case 1: result = count(2) + n; break;
    case 3: result = 1000; break;
    case 4: result = count(4); /* falls through */
    case 5: result += 5; break;
    case 6: result = 66; break;
  }
  return result;
}

static unsigned machine(const char *program) {
  unsigned a = 1;
  unsigned b = 2;
  for (;; program++) {
    switch (*program) {
      case 'a': a += b; break;
      case 'b': b ^= a << 1; break;
      case 'c': a = a << 3 | a >> 29; break;
      case 'd': b = count((int)(b - a)); break;
      case 'e':
        for (int i = 0; i < 4; i++) a = mix(a, b);
        break;
      case 'f': a = (unsigned)dense((int)(a % 10)) + b; break;
      case 'g': a ^= b; b ^= a; a ^= b; break;
      case 'h': b = (unsigned)with_holes((int)(b % 13) - 7); break;
      default: return mix(a, b);
    }
  }
}

int main(void) {
  unsigned sum = 0;
  for (int n = -10; n < 14; n++) sum = mix(mix(sum, (unsigned)dense(n)), (unsigned)with_holes(n));
  report("sum", sum);
  report("machine", machine("abcdefghgfedcbaafhdheefgabcbabdhdfhg"));
  report("calls", calls);
  return 0;
}
