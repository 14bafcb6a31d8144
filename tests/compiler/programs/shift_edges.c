/* Shifts at their edges: by nothing, by one, by all bits but one, by constants, by variables, by
 * narrow counts, and in compound assignments to narrow objects. */
#include "report.h"

static const unsigned patterns[] = {0,          1,           0x80,       0x8000,    0x80000000u,
                                    0x7fffffff, 0xffffffffu, 0x12345678, 0xdeadbeef};
#define COUNT ((int)(sizeof patterns / sizeof *patterns))

#define BY(n)                                                                              \
  APART static unsigned by_##n(unsigned x, unsigned short h, unsigned char b) {            \
    int i = (int)x;                                                                        \
    unsigned s = mix(x << n, x >> n);                                                      \
    s = mix(s, (unsigned)(i >> n));                                                        \
    s = mix(s, (unsigned)h >> n);                                                          \
    s = mix(s, (unsigned)((short)h >> n));                                                 \
    s = mix(s, (unsigned short)(h >> n) + (unsigned)((signed char)b >> n));                \
    return mix(s, (unsigned short)((unsigned)h << n) + (unsigned char)((unsigned)b << n)); \
  }
BY(0)
BY(1)
BY(8)
BY(16)
BY(17)
BY(31)

APART static unsigned left(unsigned x, int n) { return x << n; }
APART static unsigned right(unsigned x, unsigned char n) { return x >> n; }
APART static int arithmetic(int x, short n) { return x >> n; }
APART static unsigned masked(unsigned x, unsigned n) {
  return (x << (n & 31)) | (x >> (31 - (n & 31)));
}
APART static unsigned one_bit(int n) { return 1u << n | 0x80000000u >> n; }
APART static unsigned low_bits(unsigned x, int n) { return x & ((1u << n) - 1); }
APART static unsigned field(unsigned x, int at, int width) {
  return x << (32 - at - width) >> (32 - width);
}
APART static int signed_field(unsigned x, int at, int width) {
  return (int)(x << (32 - at - width)) >> (32 - width);
}
APART static unsigned divided_by_power(int x, int n) {
  return (unsigned)((x < 0 ? x + ((1 << n) - 1) : x) >> n);
}

static unsigned compound(unsigned x, int n) {
  unsigned char b = (unsigned char)x;
  signed char c = (signed char)x;
  unsigned short h = (unsigned short)x;
  short k = (short)x;
  b = (unsigned char)(b << (n & 7));
  c >>= n & 7;
  h = (unsigned short)(h << (n & 15));
  k >>= n & 15;
  b >>= 1;
  h >>= 2;
  return mix(mix(b, (unsigned)c), mix(h, (unsigned)k));
}

int main(void) {
  unsigned constant = 0, variable = 0, fields = 0, assigned = 0;
  for (int i = 0; i < COUNT; i++) {
    unsigned x = patterns[i];
    unsigned (*const by[])(unsigned, unsigned short, unsigned char) = {by_0,  by_1,  by_8,
                                                                       by_16, by_17, by_31};
    for (unsigned k = 0; k < sizeof by / sizeof *by; k++)
      constant = mix(constant, by[k](x, (unsigned short)(x >> 3), (unsigned char)(x >> 5)));
    for (int n = 0; n < 32; n++) {
      variable = mix(variable, left(x, n));
      variable = mix(variable, right(x, (unsigned char)n));
      variable = mix(variable, (unsigned)arithmetic((int)x, (short)n));
      variable = mix(variable, masked(x, (unsigned)n + 64));
      variable = mix(variable, one_bit(n) + low_bits(x, n));
      if (n < 30)
        variable = mix(variable, divided_by_power((int)x / 2, n));
      for (int width = 1; width <= 32 - n; width += 5) {
        fields = mix(fields, field(x, n, width));
        fields = mix(fields, (unsigned)signed_field(x, n, width));
      }
      assigned = mix(assigned, compound(x, n));
    }
  }
  report("constant", constant);
  report("variable", variable);
  report("fields", fields);
  report("assigned", assigned);
  return 0;
}
