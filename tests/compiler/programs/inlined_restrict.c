/* What restrict promises of an inlined function's loop holds for all rounds of that loop; what it
 * promises of a body that is inlined into a loop holds for one round. */
#include "report.h"

static inline void scale(const int *restrict in, int *restrict out, int count, int factor) {
  for (int i = 0; i < count; i++) out[i] = in[i] * factor + (in[i] >> 3);
}
/* In one call of the three, the two never meet; from round to round they do. */
static inline void one(const int *restrict in, int *restrict out, int factor) { *out = *in * factor + 1; }
static inline void pair(const int *restrict in, int *restrict out) {
  out[0] = in[0] + in[1];
  out[1] = in[0] - in[1];
}

APART void stages(int *a, int *b, int count, int rounds) {
  int *from = a, *to = b;
  for (int r = 0; r < rounds; r++) {
    int *results = to;
    scale(from, to, count, r + 3);
    to = from;
    from = results;
  }
}
APART void chain(int *a, int count) {
  for (int i = 0; i < count; i++) one(a + i, a + i + 1, i);
}
APART void backwards(int *a, int count) {
  for (int i = count; i-- > 0;) one(a + i + 1, a + i, i + 2);
}
APART void pairs(int *a, int count) {
  for (int i = 0; i < count; i++) pair(a + i, a + i + 2);
}
/* The loop around says nothing of its rounds: they shift by one. */
APART void rows(int *a, int count, int rounds) {
  for (int r = 0; r < rounds; r++) scale(a + r, a + r + count, count, r + 1);
}

int main(void) {
  unsigned state = 3, s = 0;
  static int a[200], b[200];
  for (int count = 1; count < 40; count += count < 5 ? 1 : 7) {
    for (int i = 0; i < 200; i++) {
      a[i] = (int)next_number(&state) % 100;
      b[i] = i;
    }
    stages(a, b, count, 4);
    for (int i = 0; i < 200; i++) a[i] %= 50, b[i] %= 50;
    rows(a, count, 5);
    for (int i = 0; i < 200; i++) a[i] %= 3;
    chain(a, count > 9 ? 9 : count);
    for (int i = 0; i < 200; i++) a[i] %= 3;
    backwards(a, count > 9 ? 9 : count);
    for (int i = 0; i < 200; i++) a[i] %= 5;
    pairs(a, count > 9 ? 9 : count);
    for (int i = 0; i < 200; i++) s = mix(mix(s, (unsigned)a[i]), (unsigned)b[i]);
  }
  report("restrict", s);
  return 0;
}
