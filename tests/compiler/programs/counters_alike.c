/* Counters and pointers that step alike: at a distance from each other in outer loops, rows that go
 * on where the row before ended, searches whose end is asked for in several ways, and sums of
 * products with few pairs. */
#include <stdint.h>

#include "report.h"

static int16_t samples[80];
static int16_t taps[24];
static int16_t filtered[64];
static int32_t words[64];

static void fill(uint32_t seed) {
  for (int i = 0; i < 80; ++i) {
    seed = seed * 1664525u + 1013904223u;
    samples[i] = (int16_t)((int32_t)seed >> 20);
    if (i < 24)
      taps[i] = (int16_t)((int32_t)seed >> 22);
    if (i < 64)
      words[i] = (int32_t)(seed >> 8) % 200 - 100;
  }
}

APART static void filter(const int16_t* restrict in, const int16_t* restrict by,
                         int16_t* restrict out, int count, int tap_count) {
  for (int i = 0; i < count; ++i) {
    int32_t sum = 0;
    for (int k = 0; k < tap_count; ++k)
      sum += by[k] * in[i + k];
    out[i] = (int16_t)(sum >> 9);
  }
}

/* What is behind the row is where the next one begins. */
APART static void rows_of(const int16_t* restrict in, int16_t* restrict out, int rows, int columns,
                          int gap) {
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      out[row * columns + column] = (int16_t)(in[column] - row);
    in += columns - gap;
  }
}

/* The same with the sum of each row's products. */
APART static int32_t products_of(const int16_t a[restrict 6][6], const int16_t b[restrict 6][6],
                                 int16_t product[restrict 6][6]) {
  int32_t all = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column) {
      int32_t sum = 0;
      for (int k = 0; k < 6; ++k)
        sum += a[row][k] * b[k][column];
      product[row][column] = (int16_t)(sum >> 4);
      all ^= sum;
    }
  return all;
}

struct place {
  int from_begin;
  int to_end;
  const int32_t* at;
};

/* Downwards until something is not larger; it is asked how far that is from both ends. */
APART static struct place search_down(const int32_t* begin, const int32_t* end, int32_t limit) {
  const int32_t* high = end - 1;
  while (*high > limit)
    --high;
  struct place place = {(int)(high + 1 - begin), (int)(end - high - 1), high};
  return place;
}

/* Both ways, as quicksort does; returns the distance of the last exchange from the begin. */
APART static int partition(int32_t* begin, int32_t* end) {
  const int32_t pivot = begin[(end - begin - 1) / 2];
  int32_t* low = begin;
  int32_t* high = end - 1;
  for (;;) {
    while (*low < pivot)
      ++low;
    while (*high > pivot)
      --high;
    if (low >= high)
      return (int)(high + 1 - begin) * 100 + (int)(end - high);
    const int32_t swapped = *low;
    *low++ = *high;
    *high-- = swapped;
  }
}

/* An index, its complement and twice its value, of which only the last ones count. */
APART static unsigned counters(const uint8_t* text, unsigned from) {
  unsigned index = from;
  unsigned left = 1000 - from;
  unsigned twice = 2 * from;
  while (text[index] != 0) {
    ++index;
    --left;
    twice += 2;
  }
  return index * 7 + left * 11 + twice * 13;
}

int main(void) {
  for (uint32_t seed = 1; seed < 5; ++seed) {
    fill(seed);
    for (int count = 0; count <= 5; ++count)
      for (int tap_count = 0; tap_count <= 9; ++tap_count) {
        filter(samples + (seed & 1), taps + (seed & 2), filtered, count, tap_count);
        uint32_t sum = 0;
        for (int i = 0; i < count; ++i)
          sum = sum * 31 + (uint16_t)filtered[i];
        report("filter", sum);
      }
    for (int gap = 0; gap < 3; ++gap) {
      rows_of(samples, filtered, 5, 8, gap);
      uint32_t sum = 0;
      for (int i = 0; i < 40; ++i)
        sum = sum * 31 + (uint16_t)filtered[i];
      report("rows", sum);
    }
    int16_t product[6][6];
    report("products", (unsigned)products_of((const int16_t(*)[6])samples,
                                             (const int16_t(*)[6])(samples + 40), product));
    for (int i = 0; i < 6; ++i)
      report("product", (unsigned)product[i][5 - i]);
    words[0] = -200;
    for (int limit = -150; limit < 100; limit += 50) {
      const struct place place = search_down(words, words + 64, limit);
      report("down", (unsigned)(place.from_begin * 1000 + place.to_end));
      report("at", (unsigned)(place.at - words));
    }
    report("partition", (unsigned)partition(words, words + 64));
    report("first", (unsigned)(words[0] + 3 * words[31] + 5 * words[63]));
    report("counters", counters((const uint8_t*)"how many letters are these?", seed));
  }
  return 0;
}
