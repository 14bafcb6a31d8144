/* 64-bit shifts by every constant and by variables, of both kinds; rotations; single bits; words
 * out of the middle. */
#include "report.h"

typedef unsigned long long u64;
typedef long long i64;

static const u64 patterns[] = {
    1, 0x8000000000000000ull, 0x0123456789abcdefull, 0xfedcba9876543210ull, ~0ull, 0xffffffffull};
#define COUNT ((int)(sizeof patterns / sizeof *patterns))

/* The compiler sees each count as a constant. */
#define ONE(n) s = mix_long(mix_long(mix_long(s, x << (n)), x >> (n)), (u64)((i64)x >> (n)));
#define EIGHT(n) ONE(n) ONE(n + 1) ONE(n + 2) ONE(n + 3) ONE(n + 4) ONE(n + 5) ONE(n + 6) ONE(n + 7)

APART static unsigned constants_low(u64 x) {
  unsigned s = 0;
  EIGHT(0) EIGHT(8) EIGHT(16) EIGHT(24) return s;
}
APART static unsigned constants_high(u64 x) {
  unsigned s = 0;
  EIGHT(32) EIGHT(40) EIGHT(48) EIGHT(56) return s;
}
APART static u64 left(u64 x, int n) { return x << n; }
APART static u64 right(u64 x, unsigned n) { return x >> n; }
APART static i64 arithmetic(i64 x, u64 n) { return x >> n; }
APART static u64 rotated(u64 x, unsigned n) { return x << (n & 63) | x >> (-n & 63); }
APART static unsigned middle(u64 x, int n) { return (unsigned)(x >> n); }
APART static u64 from_words(unsigned high, unsigned low) { return (u64)high << 32 | low; }
APART static u64 bit(int n) { return 1ull << n; }
APART static int test(u64 x, int n) { return (int)(x >> n) & 1; }
APART static u64 narrow_in(int x, int n) { return (u64)(i64)x << n; }
APART static int sign(i64 x) { return (int)(x >> 63) | (x != 0); }

int main(void) {
  unsigned constant = 0, variable = 0;
  for (int i = 0; i < COUNT; i++) {
    u64 x = patterns[i];
    constant = mix(constant, constants_low(x));
    constant = mix(constant, constants_high(x));
    for (int n = 0; n < 64; n++) {
      variable = mix_long(variable, left(x, n));
      variable = mix_long(variable, right(x, (unsigned)n));
      variable = mix_long(variable, (u64)arithmetic((i64)x, (u64)n));
      variable = mix_long(variable, rotated(x, (unsigned)n + 128));
      variable = mix(variable, middle(x, n));
      variable = mix_long(variable, bit(n) ^ narrow_in((int)x, n));
      variable = mix(variable, (unsigned)test(x, n));
    }
    variable = mix_long(variable, from_words((unsigned)x, (unsigned)(x >> 32)));
    variable = mix(variable, (unsigned)sign((i64)x));
  }
  report("constant", constant);
  report("variable", variable);
  report("zero", (unsigned)sign(0));
  return 0;
}
