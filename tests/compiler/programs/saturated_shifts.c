/* Shifts into 16 bits that saturate, by every number of places, rounded and not, next to the limits
 * of the word and of the half. */
#include "report.h"

#define BETWEEN(x, least, most) ((x) > (most) ? (most) : (x) < (least) ? (least) : (x))
#define SHIFT(by)                                                                                 \
  APART int cut_##by(int x) { return BETWEEN(x >> by, -32768, 32767); }                           \
  APART int round_##by(int x) { return BETWEEN((x + (1 << (by - 1))) >> by, -32768, 32767); }      \
  APART short half_##by(int x) {                                                                  \
    int r = (x + (1 << (by - 1))) >> by;                                                          \
    if (r < -32768) return -32768;                                                                \
    return r > 32767 ? 32767 : (short)r;                                                          \
  }                                                                                               \
  APART int wrapping_##by(unsigned x) {                                                           \
    int r = (int)(x + (1u << (by - 1))) >> by;                                                    \
    return BETWEEN(r, -32768, 32767);                                                             \
  }
SHIFT(1) SHIFT(2) SHIFT(3) SHIFT(4) SHIFT(5) SHIFT(6) SHIFT(7) SHIFT(8) SHIFT(9) SHIFT(10)
SHIFT(11) SHIFT(12) SHIFT(13) SHIFT(14) SHIFT(15) SHIFT(16)

static unsigned s;
static void use(int a, int b, int c, int d) {
  s = mix(mix(mix(mix(s, (unsigned)a), (unsigned)b), (unsigned)c), (unsigned)d);
}
/* What rounds may not overflow: the largest words are for the others. */
#define TRY(by)                                                                                   \
  {                                                                                               \
    int y = x > 0x7fffffff - (1 << (by - 1)) ? x - (1 << by) : x;                                 \
    use(cut_##by(x), round_##by(y), half_##by(y), wrapping_##by((unsigned)x));                    \
  }
static void all(int x) {
  TRY(1) TRY(2) TRY(3) TRY(4) TRY(5) TRY(6) TRY(7) TRY(8) TRY(9) TRY(10)
  TRY(11) TRY(12) TRY(13) TRY(14) TRY(15) TRY(16)
}

/* Other limits, other numbers to add, and what somebody else wants of the parts. */
APART int narrower(int x) { return BETWEEN((x + 128) >> 8, -32767, 32767); }
APART int biased(int x) { return BETWEEN((x + 127) >> 8, -32768, 32767); }
APART int twice(int x) {
  int r = (x + 128) >> 8;
  return BETWEEN(r, -32768, 32767) * 3 + r;
}

int main(void) {
  unsigned state = 11;
  for (int bit = 0; bit < 31; bit++)
    for (int d = -2; d <= 2; d++) {
      all((int)((1u << bit) + (unsigned)d));
      all(-(int)((1u << bit) + (unsigned)d));
      all((int)(0x7fffu << (bit % 16)) + d);
      all(-(int)(0x8000u << (bit % 16)) + (d < 0 ? 0 : d));
    }
  all(0x7fffffff);
  all(-0x7fffffff - 1);
  report("edges", s);
  for (int i = 0; i < 300; i++) {
    int x = (int)(next_number(&state) << 16 ^ next_number(&state) << 3) >> (i % 17);
    int y = x > 0x7fffff00 ? 5 : x;
    all(x);
    use(narrower(y), biased(y), twice(y / 4), 0);
  }
  report("random", s);
  return 0;
}
