/* Quotients and remainders of 32 bits, by registers and by constants, at their edges. */
#include "report.h"
__attribute__((noinline)) static unsigned by_register(int a, int b) {
  unsigned s = 0, ua = (unsigned)a, ub = (unsigned)b;
  s = mix(s, ua / ub);
  s = mix(s, ua % ub);
  if (!(a == (int)0x80000000u && b == -1)) {
    s = mix(s, (unsigned)(a / b));
    s = mix(s, (unsigned)(a % b));
  }
  return s;
}
__attribute__((noinline)) static unsigned by_constant(int a) {
  unsigned u = (unsigned)a, s = 0;
  s = mix(s, u / 3);
  s = mix(s, u / 7);
  s = mix(s, u / 10);
  s = mix(s, u % 10);
  s = mix(s, u / 641);
  s = mix(s, u / 1000000007u);
  s = mix(s, (unsigned)(a / 3));
  s = mix(s, (unsigned)(a / -7));
  s = mix(s, (unsigned)(a % 10));
  s = mix(s, (unsigned)(a / 16));
  s = mix(s, (unsigned)(a % 16));
  s = mix(s, (unsigned)(a / 1000));
  return s;
}
int main(void) {
  unsigned state = 5, s = 0, t = 0;
  for (int i = 0; i < 300; i++) {
    int a = (int)(next_number(&state) << 9 ^ next_number(&state));
    int b = (int)(next_number(&state) >> (i % 24)) + 1;
    s = mix(s, by_register(a, i & 1 ? b : -b));
    t = mix(t, by_constant(a));
  }
  t = mix(t, by_constant((int)0x80000000u));
  report("register", s);
  report("constant", t);
  return 0;
}
