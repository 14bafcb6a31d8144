/* Sums of absolute differences of bytes: rows and blocks at every alignment, step and size, small
 * and too large for SAA's halves at once; loops that look like them and are not. */
#include <stdint.h>

#include "report.h"

static uint8_t one[5000];
static uint8_t other[5000];

static void fill(unsigned seed) {
  for (unsigned i = 0; i < sizeof one; i++) {
    seed = seed * 1103515245U + 12345U;
    one[i] = (uint8_t)(seed >> 16);
    other[i] = (uint8_t)(seed >> 24);
  }
}

__attribute__((noinline)) static unsigned row(const uint8_t* a, const uint8_t* b, int count) {
  unsigned sum = 7;
  for (int i = 0; i < count; i++) {
    int difference = a[i] - b[i];
    sum += (unsigned)(difference < 0 ? -difference : difference);
  }
  return sum;
}

__attribute__((noinline)) static int by_comparison(const uint8_t* a, const uint8_t* b, int count) {
  int sum = -1000;
  for (int i = 0; i < count; i++)
    sum += a[i] > b[i] ? a[i] - b[i] : b[i] - a[i];
  return sum;
}

__attribute__((noinline)) static unsigned block(const uint8_t* a, const uint8_t* b, int step_a,
                                                int step_b, int columns, int rows) {
  unsigned sum = 0;
  for (int y = 0; y < rows; y++) {
    for (int x = 0; x < columns; x++)
      sum += (unsigned)__builtin_abs(a[x] - b[x]);
    a += step_a;
    b += step_b;
  }
  return sum;
}

#define BLOCK(columns, rows)                                                   \
  __attribute__((noinline)) static unsigned block_##columns##_##rows(          \
      const uint8_t* a, const uint8_t* b, int step_a, int step_b) {            \
    unsigned sum = 0;                                                          \
    for (int y = 0; y < (rows); y++)                                           \
      for (int x = 0; x < (columns); x++)                                      \
        sum += (unsigned)__builtin_abs(a[y * step_a + x] - b[y * step_b + x]); \
    return sum;                                                                \
  }
BLOCK(16, 16)
BLOCK(8, 8)
BLOCK(12, 3)
BLOCK(23, 40)
BLOCK(64, 70)
BLOCK(1, 60)

/* The sum is wanted in each round, the bytes go backwards, or something is stored. */
__attribute__((noinline)) static int until(const uint8_t* a, const uint8_t* b, int limit) {
  int sum = 0;
  for (int i = 0; i < 400; i++) {
    sum += __builtin_abs(a[i] - b[i]);
    if (sum > limit)
      return i;
  }
  return -1;
}

__attribute__((noinline)) static unsigned backwards(const uint8_t* a, const uint8_t* b, int count) {
  unsigned sum = 0;
  while (count-- > 0)
    sum += (unsigned)__builtin_abs(*a++ - b[count]);
  return sum;
}

__attribute__((noinline)) static unsigned with_store(const uint8_t* a, uint8_t* b, int count) {
  unsigned sum = 0;
  for (int i = 0; i < count; i++) {
    sum += (unsigned)__builtin_abs(a[i] - b[i]);
    b[i + 1] = a[i];
  }
  return sum;
}

__attribute__((noinline)) static int of_signed(const int8_t* a, const int8_t* b, int count) {
  int sum = 0;
  for (int i = 0; i < count; i++)
    sum += __builtin_abs(a[i] - b[i]);
  return sum;
}

int main(void) {
  fill(1);
  for (int a = 0; a < 4; a++)
    for (int b = 0; b < 4; b++) {
      for (int count = 0; count < 20; count++)
        report("sum", row(one + a, other + b, count) +
                          3U * (unsigned)by_comparison(one + b, other, count));
      report("sum", row(one + a, other + b, 3000));
      report("sum", block(one + a, other + b, 40, 40, 7 + a, 9));
      report("sum", block(one + a, other + b, 40, 52, 16, 5 + b));
      report("sum", block(one + a, other + b, 41, 52, 13, 11));
      report("sum", block_16_16(one + a, other + b, 64, 32));
      report("sum", block_16_16(one + a, other + b, 17, -3 + 16));
      report("sum", block_8_8(one + a, other + b, 8, 16) + block_12_3(one + a, other + b, 0, 16));
      report("sum", block_23_40(one + a, other + b, 100, 24));
      report("sum", block_64_70(one + a, other + b, 64, 64) + block_1_60(one + a, other + b, 4, 8));
      report("sum", block_8_8(one + 3000 + a, other + 3000 + b, -32, -48));
    }
  for (unsigned i = 0; i < sizeof one; i++) {
    one[i] = 255;
    other[i] = 0;
  }
  report("sum", row(one, other, 4900) + row(one + 1, other + 2, 520));
  report("sum", block_64_70(one, other, 64, 64) + block_64_70(one + 3, other, 65, 66));
  fill(2);
  report("sum", (unsigned)until(one, other, 900));
  report("sum", (unsigned)until(one, other, 90000));
  report("sum", backwards(one, other, 77));
  report("sum", with_store(one, other, 50));
  report("sum", (unsigned)of_signed((const int8_t*)one, (const int8_t*)other + 1, 99));
  return 0;
}
