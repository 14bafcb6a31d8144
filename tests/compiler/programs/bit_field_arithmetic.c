/* Bit-fields of every width, signed and unsigned, with a zero-width one between: assignments, their
 * values, increments, compound operations, promotions in comparisons and shifts, arrays of them. */
#include "report.h"

struct widths {
  unsigned a : 1, b : 2, c : 3, d : 5;
  int e : 7, f : 9;
  unsigned g : 15, h : 17;
  int i : 31, j : 1;
  unsigned : 0;
  signed char k : 3;
  unsigned char l : 5;
  short m : 11;
  unsigned short n : 16;
  int o : 32;
  long long p : 33;
  unsigned long long q : 45, r : 19;
};

APART static unsigned sum_of(const struct widths* w) {
  unsigned s = mix(w->a | w->b << 4 | w->c << 8 | w->d << 12, (unsigned)(w->e * 3 + w->f * 5));
  s = mix(mix(s, w->g), mix(w->h, (unsigned)w->i));
  s = mix(s, (unsigned)(w->j * 100 + w->k * 10 + w->l + w->m * 7));
  s = mix_long(mix(mix(s, w->n), (unsigned)w->o), (unsigned long long)w->p);
  return mix_long(mix_long(s, w->q), w->r);
}
APART static void set(struct widths* w, int x) {
  w->a = w->b = w->c = w->d = (unsigned)x;
  w->e = w->f = (short)x;
  w->h = w->g = (unsigned)x * 5;
  w->i = x % 0x1000000;
  w->j = -(x & 1);
  w->k = (signed char)(x & 3);
  w->l = (unsigned char)x;
  w->m = (short)(x >> 2 & 1023);
  w->o = x;
  w->n = (unsigned short)(w->p = x);
  w->r = w->q = (unsigned long long)x * 0x100001ull;
}
APART static void change(struct widths* w) {
  w->a++;
  w->b--;
  ++w->c;
  w->d += 9;
  w->e = (w->e - 5) % 60;
  w->f ^= 0x55;
  w->g *= 3;
  w->h <<= 2;
  w->i >>= 1;
  w->l |= 5;
  w->n -= 1000;
  w->p = w->p / 3 + w->g;
  w->q = w->q << 7 | w->q >> 38;
  w->r -= w->a;
}
APART static unsigned compared(const struct widths* w, int x, unsigned y) {
  return (unsigned)((w->d < x) | (w->e < x) << 1 | (w->g > y) << 2 | (w->k == -1) << 3 |
                    (w->d - 20 < 0) << 4 | (w->h - 200000 < 0) << 5 | (-w->c < 0) << 6 |
                    (w->r > (unsigned long long)x) << 7);
}
struct pixel {
  unsigned red : 5, green : 6, blue : 5;
};
APART static void brighten(struct pixel* p, int n, unsigned by) {
  for (int i = 0; i < n; i++) {
    p[i].red = p[i].red + by > 31 ? 31 : p[i].red + by;
    p[i].green = p[i].green + 2 * by > 63 ? 63 : p[i].green + 2 * by;
    p[i].blue += by;
  }
}

int main(void) {
  struct widths w = {0};
  unsigned s = 0;
  static const int values[] = {0,   1,    -1,    2,     5,          31,        -16,
                               127, 1000, -1000, 65535, 0x12345678, 0x7fffffff};
  for (unsigned i = 0; i < sizeof values / sizeof *values; i++) {
    int x = values[i] / 2;
    set(&w, x);
    s = mix(s, sum_of(&w));
    for (int k = 0; k < 4; k++) {
      change(&w);
      s = mix(s, sum_of(&w) ^ compared(&w, x, (unsigned)x));
    }
  }
  report("widths", s);
  struct pixel pixels[10];
  for (unsigned i = 0; i < 10; i++)
    pixels[i] = (struct pixel){i * 3 & 31, i * 7 & 63, i & 31};
  brighten(pixels, 10, 3);
  brighten(pixels + 3, 5, 9);
  for (int i = 0; i < 10; i++)
    s = mix(s, pixels[i].red | pixels[i].green << 8 | pixels[i].blue << 16);
  report("pixels", s);
  return 0;
}
