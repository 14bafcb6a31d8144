/* Pointers that go on from one run of an inner loop to the next, sums of products that are short
 * enough to be written out, bytes at pointers that each round loads, calls in return position. */
#include <stdint.h>

#include "report.h"

static uint8_t picture[64][32];
static int16_t halves[16 * 16 + 64];
static int32_t results[400];

/* In and out run on through all groups; the factors begin anew with each. */
APART static void groups(const int32_t* restrict in, const int32_t* restrict factors,
                         int32_t* restrict out, int count, int of) {
  do {
    const int32_t* factor = factors;
    for (int k = 0; k < of; ++k)
      *out++ = *in++ + (*factor++ << 2);
  } while (--count != 0);
}

APART static int columns(const int16_t* restrict a, const int16_t* restrict b, int16_t* restrict to) {
  for (int row = 0; row < 12; ++row)
    for (int column = 0; column < 8; ++column) {
      int sum = 0;
      for (int k = 0; k < 16; ++k)
        sum += a[16 * row + k] * b[8 * k + column];
      to[8 * row + column] = (int16_t)(sum >> 15);
    }
  return to[95];
}

APART static void outputs(const int16_t* restrict in, const int16_t* restrict taps,
                          int32_t* restrict out) {
  for (int i = 0; i < 24; ++i) {
    int sum = 0;
    for (int k = 0; k < 10; ++k)
      sum += taps[k] * in[i + k];
    out[i] = sum;
  }
}

/* Four neighbours at a pointer from a table; the row is what the table does not lead to. */
APART static void mixed(const uint8_t* const* restrict from, uint8_t* restrict row, int count) {
  for (int x = 0; x < count; ++x) {
    const uint8_t* at = from[x];
    const int upper = at[0] * 3 + at[1];
    const int lower = at[32] * 5 + at[33] - at[34];
    row[x] = (uint8_t)((upper * 7 + lower * 9 + 64) >> 6);
  }
}

/* As above, but the table leads into the row itself: order counts. */
APART static void onwards(uint8_t* const* from, uint8_t* row, int count) {
  for (int x = 0; x < count; ++x) {
    const uint8_t* at = from[x];
    row[x] = (uint8_t)(at[0] * 3 + at[1] * 5 + at[32] + at[33]);
  }
}

APART static unsigned last(unsigned a, unsigned b, unsigned c) { return mix(mix(a, b), c); }
APART static unsigned by_jump(unsigned a, unsigned b) { return last(b, a + 1, a ^ b); }
APART static unsigned of_local(unsigned a) {
  volatile unsigned here[3] = {a, a + 1, a + 2};
  return last(here[0], here[1], here[2]);
}
APART static unsigned read_of(const unsigned* at) { return at[0] * 31 + at[1]; }
APART static unsigned of_address(unsigned a) {
  unsigned here[2] = {a * 5, a * 7};
  return read_of(here);
}
APART static unsigned many(int a, int b, int c, int d, int e) {
  return (unsigned)(a + 2 * b + 3 * c + 4 * d + 5 * e);
}
APART static unsigned with_stack(int a) { return many(a, a + 1, a + 2, a + 3, a + 4); }
APART static unsigned even(unsigned n);
APART static unsigned odd(unsigned n) { return n == 0 ? 0 : even(n - 1); }
APART static unsigned even(unsigned n) { return n == 0 ? 1 : odd(n - 1); }

static unsigned sum_of(const void* bytes, unsigned count) {
  const uint8_t* at = bytes;
  unsigned sum = 1;
  for (unsigned i = 0; i < count; ++i)
    sum = mix(sum, at[i]);
  return sum;
}

int main(void) {
  unsigned seed = 3;
  for (int i = 0; i < 64 * 32; ++i) {
    seed = seed * 1103515245U + 12345U;
    picture[i / 32][i % 32] = (uint8_t)(seed >> 16);
    if (i < 320)
      halves[i] = (int16_t)((seed >> 12 & 0xfff) - 0x800);
  }
  static int32_t numbers[200];
  for (int i = 0; i < 200; ++i)
    numbers[i] = i * i - 77;
  for (int of = 1; of <= 6; ++of) {
    groups(numbers, numbers + 100, results, 100 / of, of);
    report("groups", sum_of(results, 4 * (100 / of) * of));
  }
  static int16_t product[96];
  for (int shift = 0; shift < 3; ++shift) {
    report("columns", (unsigned)columns(halves + shift, halves + 192 - shift, product));
    report("all", sum_of(product, sizeof product));
    outputs(halves + shift, halves + 100 + 2 * shift, results);
    report("outputs", sum_of(results, 96));
  }
  static const uint8_t* table[40];
  static uint8_t* inner[40];
  static uint8_t row[40 + 64];
  for (int i = 0; i < 40; ++i) {
    table[i] = &picture[(i * 7) % 60][(i * 5) % 29];
    inner[i] = row + (i * 11) % 40;
  }
  for (int count = 1; count <= 40; count += 13) {
    mixed(table, row, count);
    report("mixed", sum_of(row, 40));
    onwards(inner, row, count);
    report("onwards", sum_of(row, 40));
  }
  report("jump", by_jump(5, 9));
  report("local", of_local(11));
  report("address", of_address(12));
  report("stack", with_stack(3));
  report("odd", odd(1001) + 2 * even(1000));
  return 0;
}
