/* Loops whose count is at an edge: none, one, the whole of a narrow type, wrapping unsigned
 * counters, steps that do not meet the bound, bounds that change, counts only known at run time. */
#include "report.h"

typedef unsigned char u8;
typedef unsigned short u16;
static int hits;
APART static void hit(int by) { hits += by; }

APART static int upward(int from, int to, int step) {
  int n = 0;
  for (int i = from; i < to; i += step)
    n += i & 3;
  return n;
}
APART static int downward(int from, int to, int step) {
  int n = 0;
  for (int i = from; i > to; i -= step)
    n += i ^ n;
  return n;
}
APART static unsigned inclusive(unsigned from, unsigned to) {
  unsigned n = 0;
  for (unsigned i = from; i <= to && n < 100; i++)
    n++;
  return n;
}
APART static int not_equal(const char* p, const char* end) {
  int n = 0;
  for (; p != end; p += 4)
    n += *p;
  return n;
}
APART static int all_bytes(u8 from) {
  int n = 0;
  u8 i = from;
  do
    n += i * 3;
  while (++i != from);
  return n;
}
APART static unsigned wraps(u16 from, u16 to) {
  unsigned n = 0;
  for (u16 i = from; i != to; i++)
    n += i;
  return n;
}
APART static unsigned unsigned_down(unsigned n) {
  unsigned s = 0;
  for (unsigned i = n; i-- > 0;)
    s = s * 3 + i;
  for (unsigned i = n; i; i /= 2)
    s ^= i;
  return s;
}
APART static unsigned past_zero(unsigned from) {
  unsigned n = 0;
  for (unsigned i = from; i < 0xfffffff0u; i--)
    n += i + 1;
  return n;
}
APART static int moving_bound(int n) {
  int rounds = 0;
  for (int i = 0; i < n; i += 2) {
    if (i % 3 == 0)
      n--;
    rounds++;
  }
  return rounds * 100 + n;
}
APART static int at_least_once(int n) {
  int rounds = 0;
  do
    rounds++;
  while (--n > 0);
  return rounds;
}
APART static int doubled(int from, int to) {
  int n = 0;
  for (int i = from; i < to; i *= 2)
    hit(i), n++;
  return n;
}
APART static int two_counters(int a, int b) {
  int n = 0;
  for (int i = 0, j = b; i < a && j > 0; i++, j -= 3)
    n = n * 5 + i - j;
  return n;
}
APART static int long_counter(long long from, long long to) {
  int n = 0;
  for (long long i = from; i < to; i += 0x40000000)
    n++;
  return n;
}

int main(void) {
  unsigned s = 0;
  for (int from = -3; from < 4; from++)
    for (int to = -3; to < 12; to += 2)
      for (int step = 1; step < 5; step++) {
        s = mix(s, (unsigned)upward(from, to, step));
        s = mix(s, (unsigned)downward(to, from, step));
      }
  report("steps", s);
  report("inclusive",
         inclusive(5, 4) + inclusive(5, 5) * 10 + inclusive(0xfffffffeu, 0xffffffffu) * 100);
  static const char text[41] = "some forty characters for a loop to read";
  for (int i = 0; i <= 40; i += 4)
    s = mix(s, (unsigned)not_equal(text, text + i));
  report("bytes", s + (unsigned)(all_bytes(0) + all_bytes(77)));
  report("wraps", wraps(65530, 5) + wraps(7, 7) + wraps(10, 5));
  report("down", unsigned_down(0) + unsigned_down(1) + unsigned_down(30) + past_zero(9));
  for (int i = -2; i < 20; i++)
    s = mix(s, (unsigned)(moving_bound(i) + at_least_once(i) * 7 + two_counters(i, 30 - i)));
  report("moving", s);
  report("doubled", (unsigned)(doubled(1, 1000) + doubled(5, 5) + hits));
  report("long", (unsigned)long_counter(-0x200000000ll, 0x200000001ll));
  return 0;
}
