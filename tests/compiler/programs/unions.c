/* Unions: one memory as several types, by value, in arrays, anonymous in structs, of structs with a
 * common head, of different sizes, initialised by name. */
#include "report.h"

union word {
  unsigned whole;
  unsigned short halves[2];
  unsigned char bytes[4];
  struct {
    unsigned low : 12, middle : 8, high : 12;
  } parts;
};
struct value {
  enum { integer, pair, wide, text } kind;
  union {
    int number;
    struct {
      short x, y;
    };
    long long large;
    char letters[8];
  };
};
union shapes {
  struct {
    int kind;
  } any;
  struct {
    int kind, radius;
  } circle;
  struct {
    int kind;
    short width, height;
  } box;
};

APART static union word swapped(union word w) {
  union word r;
  for (int i = 0; i < 4; i++)
    r.bytes[i] = w.bytes[3 - i];
  return r;
}
APART static unsigned pieces(unsigned x) {
  union word w = {x};
  w.halves[0] ^= w.halves[1];
  w.bytes[3] += w.bytes[0];
  w.parts.middle += 7;
  return w.whole + w.parts.high;
}
APART static unsigned weight(struct value v) {
  switch (v.kind) {
    case integer:
      return (unsigned)v.number * 3;
    case pair:
      return (unsigned)(v.x * 1000 + v.y);
    case wide:
      return (unsigned)(v.large >> 20);
    case text:
      return mix((unsigned char)v.letters[0], (unsigned char)v.letters[7]);
  }
  return 0;
}
APART static int area(const union shapes* s) {
  return s->any.kind == 1   ? 3 * s->circle.radius * s->circle.radius
         : s->any.kind == 2 ? s->box.width * s->box.height
                            : -1;
}
APART static unsigned exponent(double d) {
  union {
    double d;
    unsigned long long bits;
    struct {
      unsigned low, high;
    } words;
  } u = {d};
  return (u.words.high >> 20 & 0x7ff) + (unsigned)(u.bits >> 63) * 10000;
}
APART static float halved(float f) {
  union {
    float f;
    unsigned bits;
  } u = {.f = f};
  u.bits -= 1u << 23;
  return u.f;
}
APART static unsigned network_order(const unsigned char* p) {
  union {
    unsigned char b[4];
    unsigned w;
  } u = {{p[3], p[2], p[1], p[0]}};
  return u.w;
}

int main(void) {
  unsigned s = 0, state = 6;
  for (int i = 0; i < 20; i++) {
    union word w = {.whole = next_number(&state) * 77u};
    s = mix(s, swapped(w).whole);
    s = mix(s, pieces(w.whole));
    s = mix(s, network_order(w.bytes));
  }
  report("words", s);
  struct value values[] = {{integer, {-5}},
                           {.kind = pair, .x = 7, .y = -8},
                           {wide, .large = 1ll << 50 | 99},
                           {text, .letters = "letters"}};
  for (int i = 0; i < 4; i++)
    s = mix(s, weight(values[i]));
  values[0] = values[2];
  values[1].y += values[1].x;
  report("values", mix(mix(s, weight(values[0])), weight(values[1])));
  union shapes shapes[] = {{.circle = {1, 9}}, {.box = {2, 30, -4}}, {.any = {3}}};
  for (int i = 0; i < 3; i++)
    s = mix(s, (unsigned)area(&shapes[i]));
  report("shapes", s);
  report("double", exponent(-8.5) + exponent(0.001) * 3);
  report("float", (unsigned)(int)(halved(12345.0f) * 4));
  report("sizes", sizeof(union word) * 100 + sizeof(union shapes) * 10 + sizeof values[0].letters);
  return 0;
}
