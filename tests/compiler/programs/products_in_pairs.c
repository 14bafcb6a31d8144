/* Sums of products that the compiler takes two at a time: of every small count and of many, from
 * odd addresses, of the extreme values, that wrap around, of values that lie beside each other;
 * rows times columns and filters of all shapes, whose neighbours are summed up together, and those
 * whose results lie among what they read. */
#include "report.h"

enum { COUNT = 5200 };

static short a[COUNT + 2];
static short b[COUNT + 2];
static short out[COUNT];

__attribute__((noinline)) static int dot(const short* x, const short* y, int count) {
  int sum = 7;
  for (int i = 0; i < count; i++)
    sum += x[i] * y[i];
  return sum;
}

__attribute__((noinline)) static unsigned wrapping(const short* x, const short* y, int count) {
  unsigned sum = 3;
  for (int i = 0; i < count; i++)
    sum += (unsigned)(x[i] * y[i]);
  return sum;
}

__attribute__((noinline)) static int energy(const short* x, unsigned count) {
  int sum = 0;
  while (count--) {
    sum += *x * *x;
    x++;
  }
  return sum;
}

__attribute__((noinline)) static void filter(const short* restrict x, const short* restrict taps,
                                             short* restrict y, int outputs, int tap_count) {
  for (int i = 0; i < outputs; i++) {
    int sum = i;
    for (int k = 0; k < tap_count; k++)
      sum += taps[k] * x[i + k];
    y[i] = (short)(sum >> 9);
  }
}

__attribute__((noinline)) static void wrapping_filter(const short* restrict x,
                                                      const short* restrict taps,
                                                      unsigned* restrict y, int outputs,
                                                      int tap_count) {
  for (int i = 0; i < outputs; i++) {
    unsigned sum = 0;
    for (int k = 0; k < tap_count; k++)
      sum += (unsigned)(taps[k] * x[i + k]);
    y[i] += sum;
  }
}

/* The results of a round are the next one's samples: nothing may be summed up ahead. */
__attribute__((noinline)) static void recursive(const short* taps, short* y, int outputs,
                                                int tap_count) {
  for (int i = 0; i < outputs; i++) {
    int sum = 0;
    for (int k = 0; k < tap_count; k++)
      sum += taps[k] * y[i + k];
    y[i + tap_count] = (short)(sum >> 7);
  }
}

__attribute__((noinline)) static void multiply(const short* restrict x, const short* restrict y,
                                               int* restrict z, int rows, int inner, int columns) {
  for (int row = 0; row < rows; row++)
    for (int column = 0; column < columns; column++) {
      int sum = 0;
      for (int k = 0; k < inner; k++)
        sum += x[row * inner + k] * y[k * columns + column];
      z[row * columns + column] = sum;
    }
}

static short m[6][18];
static short n[18][10];
static int product[6][10];

__attribute__((noinline)) static void fixed_sizes(void) {
  for (int row = 0; row < 6; row++)
    for (int column = 0; column < 10; column++) {
      int sum = row - column;
      for (int k = 0; k < 18; k++)
        sum += m[row][k] * n[k][column];
      product[row][column] = sum;
    }
}

/* Two sums of one loop as somebody's own hand would write it. */
__attribute__((noinline)) static void by_hand(const short* x, const short* taps, int count,
                                              int* sums) {
  int first = 1;
  int second = -1;
  for (int k = 0; k < count; k++) {
    first += x[k] * taps[k];
    second += x[k + 1] * taps[k];
  }
  sums[0] = first;
  sums[1] = second;
}

static unsigned mixed(unsigned hash, unsigned value) { return (hash ^ value) * 16777619U; }

static void report_dots(void) {
  static const int kCounts[] = {0, 1, 2, 3, 4, 5, 7, 8, 9, 255, 1022, 1023, 1024, 1025, 5000};
  unsigned hash = 1;
  for (unsigned i = 0; i < sizeof kCounts / sizeof kCounts[0]; i++)
    for (int x = 0; x < 2; x++)
      for (int y = 0; y < 2; y++) {
        hash = mixed(hash, (unsigned)dot(a + x, b + y, kCounts[i]));
        hash = mixed(hash, wrapping(a + x, b + y, kCounts[i]));
        hash = mixed(hash, (unsigned)energy(b + y, (unsigned)kCounts[i]));
      }
  report("dots", hash);
}

static void report_filters(void) {
  static unsigned sums[64];
  unsigned hash = 1;
  for (int outputs = 0; outputs < 9; outputs++)
    for (int taps = 0; taps < 7; taps++)
      for (int at = 0; at < 4; at++) {
        filter(a + (at & 1), b + (at >> 1), out, outputs, taps);
        wrapping_filter(a + (at & 1), b + (at >> 1), sums, outputs, taps);
        for (int i = 0; i < outputs; i++)
          hash = mixed(mixed(hash, (unsigned)out[i]), sums[i]);
      }
  report("filters", hash);
}

static void report_matrices(void) {
  static int z[49];
  unsigned hash = 1;
  for (int rows = 0; rows < 3; rows++)
    for (int inner = 0; inner < 8; inner++)
      for (int columns = 0; columns < 8; columns++)
        for (int at = 0; at < 4; at++) {
          multiply(a + (at & 1), b + (at >> 1), z, rows, inner, columns);
          for (int i = 0; i < rows * columns; i++)
            hash = mixed(hash, (unsigned)z[i]);
        }
  report("matrices", hash);
}

int main(void) {
  unsigned state = 5;
  int sums[2];
  unsigned hash = 0;
  for (int i = 0; i < COUNT + 2; i++) {
    a[i] = (short)((int)(next_number(&state) % 601) - 300);
    b[i] = (short)((int)(next_number(&state) % 801) - 400);
  }
  report_dots();
  report_filters();
  report_matrices();
  for (int i = 0; i < 6 * 18; i++)
    m[i / 18][i % 18] = a[i];
  for (int i = 0; i < 18 * 10; i++)
    n[i / 10][i % 10] = b[i];
  fixed_sizes();
  for (int i = 0; i < 60; i++)
    hash = mixed(hash, (unsigned)product[i / 10][i % 10]);
  report("fixed sizes", hash);
  by_hand(a, b, 501, sums);
  report("by hand", (unsigned)sums[0] ^ (unsigned)sums[1] << 1);
  recursive(b, a, 100, 5);
  report("recursive", (unsigned)dot(a, b, 105));
  /* All lanes go to the limits of 40 bits one after the other. */
  for (int i = 0; i < COUNT; i++) {
    a[i] = i % 2 ? 32767 : -32768;
    b[i] = -32768;
  }
  report("extremes", wrapping(a, b, COUNT));
  report("opposite lanes", (unsigned)dot(a, b, 1600) ^ wrapping(b, b, COUNT));
  return 0;
}
