/* Small loops, whose passes may run two at once: of no pass, one, two and many; what one pass
 * stores is loaded by the next, or by the one after it, or never; values that are wanted
 * afterwards; conditions; members of structures; products that take long; more values than there
 * are registers. */
#include "report.h"

enum { COUNT = 40 };

struct point {
  short x;
  short y;
  int weight;
};

static unsigned words[COUNT + 8];
static unsigned other[COUNT + 8];
static short halves[COUNT + 8];
static unsigned char bytes[COUNT + 8];
static struct point points[COUNT + 8];

static void fill(unsigned seed) {
  for (int i = 0; i < COUNT + 8; i++) {
    words[i] = next_number(&seed);
    other[i] = next_number(&seed) - (1 << 23);
    halves[i] = (short)next_number(&seed);
    bytes[i] = (unsigned char)next_number(&seed);
    points[i].x = (short)next_number(&seed);
    points[i].y = (short)next_number(&seed);
    points[i].weight = (int)next_number(&seed);
  }
}

static unsigned sum_of_all(void) {
  unsigned sum = 0;
  for (int i = 0; i < COUNT + 8; i++) {
    sum = mix(mix(sum, words[i]), other[i]);
    sum = mix(mix(sum, (unsigned)halves[i]), bytes[i]);
    sum = mix(mix(sum, (unsigned)points[i].x), (unsigned)(points[i].y ^ points[i].weight));
  }
  return sum;
}

/* What it loads may be what it has just stored, or stored a pass before. */
__attribute__((noinline)) static void chain(unsigned* to, const unsigned* from, int count) {
  for (int i = 0; i < count; i++)
    to[i] = (from[i] >> 1) + (from[i] ^ 0x55) + to[i];
}

__attribute__((noinline)) static void chain_of_one(unsigned* values, int count) {
  for (int i = 1; i < count; i++)
    values[i] = values[i - 1] * 3 + (values[i] >> 2);
}

__attribute__((noinline)) static void chain_of_two(unsigned* values, int count) {
  for (int i = 2; i < count; i++)
    values[i] = (values[i - 2] ^ values[i]) + (values[i] >> 5);
}

__attribute__((noinline)) static void against(unsigned* values, int count) {
  for (int i = 0; i < count; i++)
    values[i] += values[i + 1] - (values[i + 2] >> 3);
}

__attribute__((noinline)) static void backwards(unsigned* values, int count) {
  for (int i = count - 1; i >= 0; i--)
    values[i + 1] = values[i] + (values[i + 2] ^ 77);
}

__attribute__((noinline)) static int best(const int* values, const int* costs, int count, int* at,
                                          int* last) {
  int found = 0x7fffffff;
  int value = 0;
  for (int i = 0; i < count; i++) {
    value = (values[i] >> 1) + (costs[i] >> 2);
    if (value < found) {
      found = value;
      *at = i;
    }
  }
  *last = value;
  return found;
}

__attribute__((noinline)) static int limits(const int* values, int* restrict clipped, int count) {
  int low = 0x7fffffff;
  int high = -low - 1;
  for (; count > 0; count--) {
    int value = *values++;
    low = value < low ? value : low;
    high = value > high ? value : high;
    *clipped++ = value > 1000 ? 1000 : value < -1000 ? -1000 : value;
  }
  return low ^ high;
}

__attribute__((noinline)) static long long weigh(struct point* restrict to, const short* from,
                                                 int count) {
  long long sum = 0;
  for (int i = 0; i < count; i++) {
    int x = to[i].x;
    to[i].x = (short)(to[i].y + from[i]);
    to[i].y = (short)(x - from[i]);
    to[i].weight = (to[i].weight >> 1) + x * (to[i].x >> 2);
    sum += to[i].weight;
  }
  return sum;
}

__attribute__((noinline)) static unsigned blend(unsigned char* restrict to,
                                                const unsigned char* restrict from,
                                                const unsigned* restrict weights, unsigned by,
                                                int count) {
  unsigned sum = by;
  for (int i = 0; i < count; i++) {
    unsigned mixed = (unsigned)from[i] * weights[i] * by + to[i];
    to[i] = (unsigned char)(mixed >> 3);
    sum = (sum << 1 | sum >> 31) ^ mixed;
  }
  return sum;
}

__attribute__((noinline)) static unsigned crowd(const unsigned* restrict from,
                                                unsigned* restrict to, unsigned a, unsigned b,
                                                unsigned c, int count) {
  unsigned d = a + 9;
  unsigned e = a ^ 1;
  unsigned f = b ^ 2;
  for (int i = 0; i < count; i++) {
    unsigned g = *from++;
    unsigned h = *to;
    a += g & b;
    b ^= h | c;
    c -= g ^ d;
    d += h & e;
    e ^= g + f;
    f -= h;
    *to++ = a ^ b ^ c ^ d ^ e ^ f;
  }
  return a + 3 * b + 5 * c + 7 * d + 11 * e + 13 * f;
}

__attribute__((noinline)) static void table(unsigned (*restrict rows)[8],
                                            const short* restrict factors) {
  for (int i = 0; i < 5; i++) {
    const short* factor = factors + i;
    unsigned* value = rows[i];
    for (int k = 0; k < 8; k++)
      *value++ += (unsigned)(*factor++ * (i + 1));
  }
}

static void round_of(int count) {
  int at = -1;
  int last = -2;
  chain(words, other, count);
  chain_of_one(other, count);
  chain_of_two(words + 1, count);
  report("best", (unsigned)best((int*)words, (int*)other, count, &at, &last));
  report("at", (unsigned)(at * 1000 + last));
  report("limits", (unsigned)limits((int*)other, (int*)words + 3, count));
  long long sum = weigh(points, halves, count);
  report("weigh", (unsigned)(sum ^ sum >> 32));
  report("blend", blend(bytes, bytes + COUNT / 2 + 1, other, 5, count < 20 ? count : 20));
  report("crowd", crowd(words, other, 2, 3, 4, count));
  report("all", sum_of_all());
}

int main(void) {
  for (int count = 0; count < 4; count++) {
    fill((unsigned)count + 3);
    round_of(count);
  }
  fill(1);
  round_of(COUNT);
  chain(words + 1, words, COUNT);
  chain(words, words + 1, COUNT);
  chain(other + 2, other, COUNT);
  chain(other, other, COUNT);
  report("over each other", sum_of_all());
  against(words, COUNT);
  backwards(other, COUNT);
  report("neighbours", sum_of_all());
  table((unsigned(*)[8])words, halves);
  report("table", sum_of_all());
  return 0;
}
