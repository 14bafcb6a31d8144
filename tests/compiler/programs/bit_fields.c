/* Bit-fields within words and across them, stepped in a loop. */
#include "report.h"
struct flags { unsigned ready : 1, kind : 3; int level : 5; unsigned count : 13; signed char small : 4; };
struct packed_words { unsigned a : 20, b : 12; unsigned long long c : 40, d : 24; };
__attribute__((noinline)) static unsigned update(struct flags *f, int n) {
  f->ready ^= 1;
  f->kind = (unsigned)n;
  f->level -= n;
  f->count += (unsigned)n * 37;
  f->small = (signed char)(f->small + n);
  return f->ready + f->kind * 2 + (unsigned)f->level * 16 + f->count * 1024 + (unsigned)f->small;
}
int main(void) {
  struct flags f = {0};
  struct packed_words p = {1, 2, 3, 4};
  unsigned s = 0;
  for (int i = 0; i < 40; i++) {
    s = mix(s, update(&f, i));
    p.a += 77777;
    p.b ^= p.a;
    p.c = p.c * 3 + p.b;
    p.d -= (unsigned)i;
    s = mix(s, p.a ^ p.b ^ (unsigned)p.c ^ (unsigned)(p.c >> 32) ^ (unsigned)p.d);
  }
  report("bits", s);
  return 0;
}
