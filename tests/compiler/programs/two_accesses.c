/* Loops over two and more arrays, which can take two accesses a packet: words and halves, up and
 * down, read and written at one place, of no element and of one, over each other, with pointers and
 * values that are wanted afterwards, in loops around them, and halves whose upper part matters. */
#include "report.h"

enum { COUNT = 64 };

static unsigned words[COUNT + 4];
static unsigned other[COUNT + 4];
static short halves[COUNT + 4];
static short more[COUNT + 4];
static unsigned short counts[COUNT + 4];

static void fill(unsigned seed) {
  for (int i = 0; i < COUNT + 4; i++) {
    words[i] = next_number(&seed);
    other[i] = next_number(&seed);
    halves[i] = (short)next_number(&seed);
    more[i] = (short)next_number(&seed);
    counts[i] = (unsigned short)next_number(&seed);
  }
}

static unsigned sum_of_all(void) {
  unsigned sum = 0;
  for (int i = 0; i < COUNT + 4; i++) {
    sum = mix(mix(sum, words[i]), other[i]);
    sum = mix(mix(sum, (unsigned)halves[i]), (unsigned)more[i] ^ counts[i]);
  }
  return sum;
}

/* Where they lie over each other, a word copied is copied again. */
__attribute__((noinline)) static unsigned* copy(unsigned* to, const unsigned* from, int count) {
  for (; count > 0; count--)
    *to++ = *from++;
  return to;
}

__attribute__((noinline)) static const unsigned* copy_apart(unsigned* restrict to,
                                                            const unsigned* restrict from,
                                                            int count) {
  while (count-- > 0)
    *to++ = *from++;
  return from;
}

__attribute__((noinline)) static void copy_down(unsigned* to, const unsigned* from, int count) {
  while (count-- > 0)
    *--to = *--from;
}

__attribute__((noinline)) static void exchange(unsigned* x, unsigned* y, int count) {
  for (; count > 0; count--) {
    unsigned kept = *x;
    *x++ = *y;
    *y++ = kept;
  }
}

__attribute__((noinline)) static int products(const short* x, const short* y, int count) {
  int sum = 3;
  for (int i = 0; i < count; i++)
    sum += x[i] * y[i];
  return sum;
}

/* The last loads are wanted in full behind the loop. */
__attribute__((noinline)) static int last_product(const short* x, const short* y, int count,
                                                  int* last) {
  int sum = 0;
  int a = 0;
  int b = 0;
  for (int i = 0; i < count; i++) {
    a = x[i];
    b = y[i];
    sum += a * b;
  }
  *last = a - b;
  return sum;
}

/* Halves read as numbers with and without a sign, and written. */
__attribute__((noinline)) static unsigned widened(const short* x, const unsigned short* y, short* z,
                                                  int count) {
  unsigned sum = 0;
  for (; count > 0; count--) {
    int a = *x++;
    unsigned b = *y++;
    *z++ = (short)(a + (int)b);
    sum += ((unsigned)a ^ b) >> 3;
  }
  return sum;
}

__attribute__((noinline)) static void accumulate(unsigned short* restrict total,
                                                 unsigned short* restrict window,
                                                 const unsigned short* restrict from, unsigned mask,
                                                 int count) {
  for (int i = 0; i < count; i++) {
    unsigned ones = (unsigned)__builtin_popcount(mask ^ *from--);
    unsigned sum = *total + ones - *window;
    *window++ = (unsigned short)ones;
    *total++ = (unsigned short)sum;
  }
}

__attribute__((noinline)) static unsigned rows(const unsigned* x, unsigned* y, int width,
                                               int height) {
  unsigned sum = 0;
  for (int i = 0; i < height; i++) {
    unsigned* to = y + i;
    const unsigned* from = x;
    for (int j = 0; j < width; j++) {
      unsigned value = *from++;
      *to++ = value + sum;
      sum ^= value;
    }
    x += width;
    sum += (unsigned)(to - y);
  }
  return sum;
}

int main(void) {
  int last = 0;
  for (int count = 0; count < 5; count++) {
    fill((unsigned)count);
    report("copied", (unsigned)(copy(words, other, count) - words));
    report("copied apart", (unsigned)(copy_apart(words + 9, other + 3, count) - other));
    copy_down(words + 30, other + 40, count);
    exchange(words + 40, other + 50, count);
    report("products", (unsigned)products(halves, more, count));
    report("last products", (unsigned)last_product(halves + 1, more, count, &last));
    report("last", (unsigned)last);
    report("widened", widened(halves, counts, more + 2, count));
    accumulate(counts, counts + 20, counts + 50, 0xa5a5, count);
    report("rows", rows(words, other, count, 3));
    report("all", sum_of_all());
  }
  fill(7);
  copy(words + 1, words, COUNT);
  copy(other, other + 2, COUNT);
  report("over each other", sum_of_all());
  copy_down(words + COUNT, words + COUNT + 2, COUNT);
  exchange(words, words + 1, COUNT);
  exchange(other, other, COUNT);
  report("again", sum_of_all());
  report("widened", widened(halves, counts, halves + 1, COUNT - 1));
  report("widened back", widened(more, counts, (short*)counts, COUNT));
  report("rows", rows(words, words + 1, 8, 5));
  accumulate(counts, counts + 16, counts + COUNT, 0xffff5a5a, 16);
  report("all", sum_of_all());
  return 0;
}
