/* Sums of Hamming distances over windows, in the shapes of a matcher. */
#include "report.h"
static unsigned short left[48], right[80], update[31], oldest[31], score[31];
__attribute__((noinline)) static void row(unsigned pair, const unsigned short *from) {
  unsigned short *u = update, *o = oldest, *s = score;
  for (int k = 0; k < 31; k++) {
    unsigned newest = (unsigned)__builtin_popcount(pair ^ *from--);
    unsigned sum = *u + newest - *o;
    *o++ = (unsigned short)newest;
    *u++ = (unsigned short)sum;
    *s = (unsigned short)(*s + sum);
    s++;
  }
}
__attribute__((noinline)) static unsigned two_at_once(const unsigned *a, const unsigned *b, int n) {
  unsigned s = 0, t = 1;
  for (int i = 0; i < n; i++) {
    s += (unsigned)__builtin_popcount(a[i] & b[i]);
    t = t * 3 + (unsigned)__builtin_popcount(a[i] | b[i]);
  }
  return s ^ t;
}
__attribute__((noinline)) static unsigned chained(unsigned x, int n) {
  for (int i = 0; i < n; i++)
    x += (unsigned)__builtin_popcount(x) * 0x10001u;
  return x;
}
__attribute__((noinline)) static unsigned conditional(const unsigned short *p, int n) {
  unsigned s = 0;
  for (int i = 0; i < n; i++)
    if (__builtin_popcount(p[i]) > 6)
      s += (unsigned)__builtin_popcount(p[i] ^ 0xff);
  return s;
}
int main(void) {
  unsigned state = 99, s = 0;
  for (int i = 0; i < 48; i++)
    left[i] = (unsigned short)next_number(&state);
  for (int i = 0; i < 80; i++)
    right[i] = (unsigned short)next_number(&state);
  for (int i = 0; i < 48; i++)
    row(left[i], right + 31 + i);
  for (int k = 0; k < 31; k++)
    s = mix(mix(s, score[k]), update[k]);
  report("row", s);
  report("two", two_at_once((unsigned *)(void *)left, (unsigned *)(void *)right, 24));
  report("chained", chained(7, 25));
  report("conditional", conditional(right, 80));
  return 0;
}
