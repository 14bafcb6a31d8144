/* _Bool: what it makes of every type, its arithmetic, arrays and members of it, conditions kept in
 * variables, and logic by bits against logic by branches. */
#include "report.h"

struct switches {
  _Bool one, two;
  unsigned char between;
  _Bool many[5];
  _Bool field : 1;
};

APART static _Bool of_int(int x) { return x; }
APART static _Bool of_long(long long x) { return x; }
APART static _Bool of_double(double x) { return x; }
APART static _Bool of_float(float x) { return (_Bool)x; }
APART static _Bool of_pointer(const void* x) { return x; }
APART static int arithmetic(_Bool a, _Bool b) {
  return a + b * 2 + (a - b) * 4 + -a * 100 + (a << 5) + (b ^ 6) + !a * 1000;
}
APART static _Bool logic(_Bool a, _Bool b, _Bool c) { return (a & b) | (b ^ c) | (!a && c); }
APART static _Bool branches(_Bool a, _Bool b, _Bool c) {
  if (a && b)
    return 1;
  if (b != c)
    return 1;
  return !a && c;
}
APART static int kept(int x, int y) {
  _Bool less = x < y, equal = x == y, odd = x & 1;
  int n = 0;
  if (less || odd)
    n += 1;
  less = !less;
  if (less && !equal)
    n += 2;
  odd |= y > 5;
  odd = odd + 1;
  equal = equal + 2;
  less &= y & 2;
  return n + 4 * odd + 8 * equal + 16 * less;
}
APART static unsigned members(struct switches* s, int n) {
  s->one = n & 4;
  s->two ^= s->one;
  s->field = n;
  s->between += s->two;
  for (int i = 0; i < 5; i++)
    s->many[i] = !s->many[i] ^ (n >> i & 1);
  unsigned sum = s->one + s->two * 2u + s->field * 4u + s->between * 8u;
  for (int i = 0; i < 5; i++)
    sum = mix(sum, s->many[i]);
  return sum;
}
APART static int count_true(const _Bool* p, int n) {
  int count = 0;
  for (int i = 0; i < n; i++)
    count += p[i];
  return count;
}

int main(void) {
  static int object;
  unsigned s = 0;
  static const int ints[] = {0, 1, 2, -1, 256, 65536, -2147483647 - 1};
  for (int i = 0; i < 7; i++)
    s = mix(s, of_int(ints[i]) + 2u * of_long(ints[i] * 0x100000000ll) +
                   4u * of_double(ints[i] / 1e300) + 8u * of_float((float)ints[i]));
  s = mix(s, of_double(-0.0) + 2u * of_double(5e-324) + 4u * of_pointer(&object) +
                 8u * of_pointer(0) + 16u * of_float(1e-45f));
  report("made", s);
  for (int i = 0; i < 8; i++) {
    s = mix(s, (unsigned)arithmetic(i & 1, i & 2));
    s = mix(s, (unsigned)(logic(i & 1, i & 2, i & 4) == branches(i & 1, i & 2, i & 4)));
  }
  for (int i = 0; i < 6; i++)
    for (int j = 3; j < 9; j++)
      s = mix(s, (unsigned)kept(i, j));
  report("used", s);
  struct switches switches = {0};
  for (int i = 0; i < 20; i++)
    s = mix(s, members(&switches, i * 3));
  _Bool flags[40];
  for (int i = 0; i < 40; i++)
    flags[i] = i * i & 12;
  report("members", mix(s, (unsigned)count_true(flags, 40)));
  report("sizes", sizeof(_Bool) + sizeof flags);
  return 0;
}
