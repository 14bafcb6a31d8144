/* Structs among other arguments: split between registers and stack, after 64-bit ones, many at
 * once, through pointers to functions, as results that are used at once. */
#include "report.h"

typedef long long i64;
struct small {
  short a, b;
};
struct eight {
  int a, b;
};
struct wide {
  i64 a;
};
struct twelve {
  int v[3];
};
struct mixed {
  char c;
  double d;
  struct small s;
};

APART static unsigned first_words(int a, struct eight b, int c) {
  return mix(mix((unsigned)a, (unsigned)b.a), mix((unsigned)b.b, (unsigned)c));
}
APART static unsigned split(int a, int b, struct eight c, int d) {
  return mix(mix((unsigned)a, (unsigned)b), mix((unsigned)c.a * 3 + (unsigned)c.b, (unsigned)d));
}
APART static unsigned split_large(int a, struct twelve b, struct twelve c) {
  unsigned s = (unsigned)a;
  for (int i = 0; i < 3; i++)
    s = mix(s, (unsigned)(b.v[i] * 7 - c.v[2 - i]));
  return s;
}
APART static unsigned after_long(i64 a, struct wide b, char c, struct small d, i64 e) {
  return mix_long(mix_long((unsigned)c, (unsigned long long)(a - b.a)),
                  (unsigned long long)(e + d.a - d.b));
}
APART static unsigned many(struct small a, struct eight b, struct twelve c, struct wide d,
                           struct small e, struct mixed f, struct eight g) {
  unsigned s = (unsigned)(a.a + a.b * 2 + b.a * 3 + b.b * 4 + c.v[0] + c.v[1] * 5 + c.v[2] * 6);
  s = mix_long(s, (unsigned long long)d.a);
  return mix(s,
             (unsigned)(e.a * 7 + e.b * 8 + f.c + (int)f.d + f.s.a + f.s.b * 9 + g.a * 10 + g.b));
}
APART static struct mixed make(char c, int n) {
  return (struct mixed){c, n * 0.5, {(short)n, (short)-n}};
}
APART static struct twelve rotate(struct twelve x) {
  return (struct twelve){{x.v[1], x.v[2], x.v[0]}};
}
APART static struct eight pair(int a, int b) { return (struct eight){a, b}; }
APART static struct small narrow(struct eight x) { return (struct small){(short)x.a, (short)x.b}; }
APART static struct wide widen(struct small x) {
  return (struct wide){(i64)x.a << 32 | (unsigned short)x.b};
}
static struct twelve (*const turned)(struct twelve) = rotate;
typedef struct eight (*maker)(int, int);
APART static struct eight twice(maker make_one, int n) {
  struct eight a = make_one(n, n + 1);
  return make_one(a.b, a.a + make_one(7, 8).b);
}
APART static int changed(struct twelve x) {
  x.v[1] = 99;
  struct twelve* p = &x;
  p->v[2]++;
  return x.v[0] + x.v[1] + x.v[2];
}

int main(void) {
  struct twelve t = {{10, 20, 30}};
  report("first", first_words(1, pair(2, 3), 4));
  report("split", split(1, 2, pair(3, 4), 5));
  report("large", split_large(9, t, rotate(t)));
  report("long", after_long(1ll << 40, (struct wide){5}, 'x', (struct small){-3, 4}, -1));
  report("many", many((struct small){1, 2}, pair(3, 4), t, widen(narrow(pair(70000, -5))),
                      narrow(pair(6, 7)), make('m', 25), twice(pair, 100)));
  report("nested", (unsigned)rotate(turned(rotate(rotate(t)))).v[1]);
  report("member", (unsigned)(make('q', 8).s.b + narrow(pair(1, 2)).b + turned(t).v[0]));
  report("copy", (unsigned)(changed(t) * 100 + t.v[1] + t.v[2]));
  struct mixed all[3] = {make('a', 1), make('b', 2), make('c', 3)};
  unsigned s = 0;
  for (int i = 0; i < 3; i++) {
    all[i] = all[(i + 1) % 3];
    s = mix(s, (unsigned)(all[i].c + (int)(all[i].d * 4) + all[i].s.a));
  }
  report("array", s);
  return 0;
}
