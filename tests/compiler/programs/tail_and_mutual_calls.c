/* Calls in last position, chains of them, results that pass through. */
#include "report.h"
typedef unsigned (*step)(unsigned, unsigned);
static unsigned trace;
static unsigned first(unsigned x, unsigned n);
static unsigned second(unsigned x, unsigned n);
static const step steps[] = {first, second};
__attribute__((noinline)) static unsigned first(unsigned x, unsigned n) {
  trace = mix(trace, x);
  return n == 0 ? x : steps[x & 1](x * 3 + 1, n - 1);
}
__attribute__((noinline)) static unsigned second(unsigned x, unsigned n) {
  if (n == 0)
    return x ^ 0x55;
  return first(x / 2, n - 1);
}
__attribute__((noinline)) static long long through(long long v, int depth) {
  return depth == 0 ? v : through(v + depth, depth - 1);
}
__attribute__((noinline)) static void nothing(void) { trace++; }
__attribute__((noinline)) static void ends_in_a_call(int n) {
  while (n-- > 0)
    nothing();
  nothing();
}
int main(void) {
  unsigned s = 0;
  for (unsigned i = 0; i < 12; i++)
    s = mix(s, first(i * 977, i));
  ends_in_a_call(5);
  long long v = through(1LL << 35, 30);
  s = mix(s, (unsigned)v ^ (unsigned)(v >> 32));
  report("calls", s);
  report("trace", trace);
  return 0;
}
