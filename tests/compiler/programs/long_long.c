/* Sums, products, shifts and comparisons of 64 bits. */
#include "report.h"
typedef long long i64;
typedef unsigned long long u64;
static unsigned fold(u64 v) { return mix((unsigned)v, (unsigned)(v >> 32)); }
__attribute__((noinline)) static unsigned ops(i64 a, i64 b, int n) {
  u64 ua = (u64)a, ub = (u64)b;
  unsigned s = 0;
  s = mix(s, fold(ua + ub));
  s = mix(s, fold(ua - ub));
  s = mix(s, fold(ua * ub));
  s = mix(s, fold(ua & ub));
  s = mix(s, fold(ua ^ ub));
  s = mix(s, fold(-ua));
  s = mix(s, fold(ua << n));
  s = mix(s, fold(ua >> n));
  s = mix(s, fold((u64)(a >> n)));
  s = mix(s, fold(ua << 32));
  s = mix(s, fold(ua >> 33));
  s = mix(s, (unsigned)(a < b) | (unsigned)(ua < ub) << 1 | (unsigned)(a == b) << 2 |
                 (unsigned)(a >= b) << 3 | (unsigned)(ua > ub) << 4);
  s = mix(s, (unsigned)__builtin_popcountll(ua));
  return s;
}
__attribute__((noinline)) static u64 widen(unsigned a, unsigned b) { return (u64)a * b; }
__attribute__((noinline)) static i64 widen_signed(int a, int b) { return (i64)a * b; }
__attribute__((noinline)) static i64 middle(int a, i64 b, int c, i64 d) { return b - d + a * c; }
int main(void) {
  unsigned state = 1, s = 0;
  for (int i = 0; i < 64; i++) {
    u64 a = (u64)next_number(&state) << 40 ^ (u64)next_number(&state) << 20 ^ next_number(&state);
    u64 b = (u64)next_number(&state) << (i % 40) ^ next_number(&state);
    if (i % 3 == 0)
      a = -a;
    s = mix(s, ops((i64)a, (i64)b, i));
    s = mix(s, fold(widen((unsigned)a, (unsigned)b)));
    s = mix(s, fold((u64)widen_signed((int)a, (int)b)));
    s = mix(s, fold((u64)middle(i, (i64)a, (int)b, (i64)b)));
  }
  report("long long", s);
  return 0;
}
