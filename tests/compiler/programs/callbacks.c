/* Pointers to functions in every place: returned, in tables of tables, in structs with a context,
 * compared, called through several levels, with many arguments and structs, chosen by conditions,
 * as iterators. */
#include <stddef.h>

#include "report.h"

typedef int (*unary)(int);
typedef unary (*chooser)(int);
struct pair {
  int a, b;
};
struct large {
  int v[6];
};

static int increase(int x) { return x + 1; }
static int twice(int x) { return x * 2; }
static int square(int x) { return (x & 0xff) * (x & 0xff); }
static unary by_sign(int n) { return n < 0 ? increase : n > 100 ? square : twice; }
static unary always(int n) {
  (void)n;
  return square;
}
static int (*pick(chooser c, int n))(int) { return c(n); }
static const chooser choosers[2] = {by_sign, always};
static const unary tables[2][3] = {{increase, twice, square}, {square, NULL, increase}};

struct stream {
  int (*read)(struct stream*);
  void (*reset)(struct stream*, int);
  int state, left;
};
static int count_up(struct stream* s) { return s->left-- > 0 ? s->state++ : -1; }
static int halve(struct stream* s) {
  int value = s->state;
  s->state /= 2;
  if (value == 0)
    s->read = count_up;
  return value;
}
static void reset(struct stream* s, int to) {
  s->state = to;
  s->left = 3;
}
APART static int drain(struct stream* s) {
  int sum = 0, value;
  while ((value = s->read(s)) >= 0)
    sum = sum * 3 + value;
  return sum;
}
APART static void each(const int* p, int n, void (*visit)(void*, int), void* context) {
  while (n-- > 0)
    visit(context, *p++);
}
static void add_to(void* context, int value) { *(int*)context += value; }
static void largest(void* context, int value) {
  struct pair* p = context;
  if (value > p->a)
    p->a = value;
  p->b++;
}
static long long wide(char a, long long b, short c, struct pair d, double e, struct large f,
                      int g) {
  return a + b * c + d.a - d.b + (long long)(e * 4) + f.v[5] * g;
}
static struct large make(int from, unary step) {
  struct large l;
  for (int i = 0; i < 6; i++)
    l.v[i] = from = step(from);
  return l;
}
APART static int compose(unary f, unary g, int x) {
  return f == g ? f(x) : g != NULL ? f(g(x)) : -1;
}
APART static int repeat(unary f, int times, int x) {
  for (int i = 0; i < times; i++)
    x = f(x);
  return x;
}
static int self(int n, int (*again)(int, void*), void* what) {
  return n <= 0 ? 1 : n + again(n - 1, what);
}
static int bounce(int n, void* what) { return self(n - 1, bounce, what) * 2; }

int main(void) {
  unsigned s = 0;
  for (int i = -150; i < 200; i += 50)
    s = mix(s, (unsigned)(pick(choosers[i & 1], i)(i) + by_sign(i)(3)));
  report("chosen", s);
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < 3; k++)
      s = mix(s, tables[i][k] == NULL ? 77 : (unsigned)(*tables[i][k])(i + k * 9));
  report("tables", s);
  struct stream stream = {halve, reset, 100, 2};
  report("drained", (unsigned)drain(&stream));
  stream.reset(&stream, 50);
  report("again", (unsigned)drain(&stream));
  static const int numbers[] = {4, -7, 19, 3, 8};
  int sum = 0;
  struct pair found = {-1000, 0};
  each(numbers, 5, add_to, &sum);
  each(numbers, 5, largest, &found);
  report("visited", (unsigned)(sum * 10000 + found.a * 10 + found.b));
  long long (*volatile function)(char, long long, short, struct pair, double, struct large, int) =
      wide;
  struct large (*const maker)(int, unary) = make;
  report("wide", mix_long(0, (unsigned long long)function('a', 1ll << 34, -3, found, 2.75,
                                                          maker(1, twice), 5)));
  report("composed", (unsigned)(compose(twice, increase, 5) * 100 + compose(square, square, 9) +
                                compose(twice, NULL, 1)));
  report("repeated", (unsigned)(repeat(twice, 9, 3) + repeat(by_sign(-1), 100, 0)));
  report("self", (unsigned)self(7, bounce, NULL));
  return 0;
}
