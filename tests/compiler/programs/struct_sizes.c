/* Structs of 1 to 40 bytes by value: in, out, through, beside other arguments, with alignments of
 * one, two and four. */
#include "report.h"

#define BYTES(n)                                                              \
  struct bytes_##n {                                                          \
    unsigned char b[n];                                                       \
  };                                                                          \
  APART static struct bytes_##n turn_##n(struct bytes_##n x, int by) {        \
    struct bytes_##n y;                                                       \
    for (int i = 0; i < n; i++)                                               \
      y.b[i] = (unsigned char)(x.b[(i + by) % n] + i);                        \
    return y;                                                                 \
  }                                                                           \
  APART static unsigned sum_##n(char before, struct bytes_##n x, short after, \
                                struct bytes_##n y) {                         \
    unsigned s = mix((unsigned)before, (unsigned)after);                      \
    for (int i = 0; i < n; i++)                                               \
      s = mix(s, x.b[i] * 3u - y.b[n - 1 - i]);                               \
    return s;                                                                 \
  }
#define EACH(DO) DO(1) DO(3) DO(4) DO(6) DO(8) DO(9) DO(17) DO(40)
EACH(BYTES)

struct halves {
  short h[3];
};
struct words {
  int a;
  short b;
  char c;
};
struct nine_words {
  int w[9];
};
APART static struct halves next_halves(struct halves x) {
  return (struct halves){{x.h[2], (short)(x.h[0] + 1), x.h[1]}};
}
APART static struct words next_words(struct words x, struct halves y) {
  x.a += y.h[0];
  x.b = (short)(x.b - y.h[1]);
  x.c ^= (char)y.h[2];
  return x;
}
APART static struct nine_words add(struct nine_words a, struct nine_words b) {
  for (int i = 0; i < 9; i++)
    a.w[i] += b.w[8 - i];
  return a;
}

#define CHECK(n)                                     \
  {                                                  \
    struct bytes_##n x;                              \
    for (int i = 0; i < n; i++)                      \
      x.b[i] = (unsigned char)(i * 37 + n);          \
    for (int i = 0; i < 3; i++)                      \
      x = turn_##n(turn_##n(x, i), 1);               \
    report(#n, sum_##n('a', x, -5, turn_##n(x, 2))); \
  }

int main(void) {
  EACH(CHECK)
  struct halves h = {{1, -2, 3}};
  struct words w = {100000, 200, 'c'};
  struct nine_words n = {{1, 2, 3, 4, 5, 6, 7, 8, 9}};
  for (int i = 0; i < 10; i++) {
    h = next_halves(h);
    w = next_words(w, h);
    n = add(n, n);
  }
  report("words", mix(mix((unsigned)w.a, (unsigned)w.b), (unsigned)w.c));
  report("nine", mix((unsigned)n.w[0], (unsigned)n.w[7]));
  return 0;
}
