/* Designated initialisers: by index and by name, in any order, with ranges, overriding, nested,
 * going on behind a designator; arrays whose length follows; compound literals in and out of
 * functions. */
#include "report.h"

struct key {
  const char* name;
  int codes[4];
  struct {
    unsigned char low, high;
  } range;
};

enum { first = 2, second = 5, last = 9 };

static const short sparse[] = {[last] = -9, [first] = 2, 3, [second] = 50, 60, [first + 1] = 33};
static int ranges[12] = {[0 ... 3] = 7, [2] = 1, [5 ... 6] = 9, 10, [11] = -1};
static const struct key keys[] = {
    [1] = {.codes = {[2] = 22}, .name = "one", .range.high = 8},
    [0] = {"zero", {1, 2, 3, 4}, {5, 6}},
    [3] = {.range = {.high = 3, .low = 2}, .name = "three", .codes[1] = 11, .codes[3] = 13},
};
static int* numbers = (int[]){4, 5, 6, [6] = 7};
static const struct key* const kept = &(const struct key){.name = "kept", .codes = {9}};
static const char letters[2][3][4] = {{"abc", [2] = "xyz"}, [1][1] = "mno", [1][2][1] = 'q'};

APART static int sum(const int* p, int n) {
  int s = 0;
  for (int i = 0; i < n; i++)
    s = s * 3 + p[i];
  return s;
}
APART static unsigned weight(struct key k) {
  return (unsigned)(k.name[0] + sum(k.codes, 4) + k.range.low * 5 + k.range.high * 7);
}
APART static unsigned local(int a, int b) {
  struct key k = {.codes = {[1] = a, b, a + b}, .name = "local"};
  int filled[8] = {[2 ... 4] = a, [6] = b};
  struct key copy = (struct key){k.name + 1, {[0] = b}, .range = k.range};
  return weight(k) + weight(copy) * 3 + (unsigned)sum(filled, 8);
}
APART static int literals(int n) {
  int total = 0;
  for (int i = 0; i < n; i++) {
    int* p = (int[]){i, i * 2, 0, [4] = total};
    p[2] = p[0] + p[1];
    total = sum(p, 5) & 0xffff;
    struct key* k = &(struct key){"x", {i}, {1, 2}};
    k->codes[1] += total;
    total ^= k->codes[0] + k->codes[1];
  }
  return total;
}

int main(void) {
  unsigned s = sizeof sparse / sizeof *sparse;
  for (unsigned i = 0; i < sizeof sparse / sizeof *sparse; i++)
    s = mix(s, (unsigned)sparse[i]);
  report("sparse", s);
  report("ranges", (unsigned)sum(ranges, 12));
  for (int i = 0; i < 4; i++)
    if (keys[i].name != 0)
      s = mix(s, weight(keys[i]));
  report("keys", mix(s, sizeof keys / sizeof *keys));
  numbers[1] = 55;
  report("numbers", (unsigned)sum(numbers, 7) + weight(*kept));
  for (int i = 0; i < 24; i++)
    s = mix(s, (unsigned char)(&letters[0][0][0])[i]);
  report("letters", s);
  report("local", local(3, -4));
  report("literals", (unsigned)literals(9));
  report("direct", (unsigned)(sum((const int[]){1, 2, 3}, 3) + (int)sizeof((char[]){1, 2, 3}) +
                              ((struct key){.name = "direct"}).name[2]));
  return 0;
}
