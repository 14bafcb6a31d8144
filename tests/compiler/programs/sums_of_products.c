/* Sums of products of halves, which live in accumulators where C allows it: two at once, from other
 * starts than 0, of no element and of one, in nested loops; and sums that must not: those that wrap, that
 * are looked at on the way, that are wider. */
#include "report.h"

enum { COUNT = 300 };

static short a[COUNT];
static short b[COUNT];

__attribute__((noinline)) static int dot(const short *x, const short *y, int count, int start) {
  int sum = start;
  for (int i = 0; i < count; i++) sum += x[i] * y[i];
  return sum;
}

__attribute__((noinline)) static void two(const short *x, const short *y, int count, int *sums) {
  int forward = 5;
  int backward = -7;
  for (int i = 0; i < count; i++) {
    forward += x[i] * y[i];
    backward += x[i] * x[count - 1 - i];
  }
  sums[0] = forward;
  sums[1] = backward;
}

__attribute__((noinline)) static unsigned wrapping(const short *x, const short *y, int count) {
  unsigned sum = 0;
  for (int i = 0; i < count; i++) sum += (unsigned)(x[i] * y[i]);
  return sum;
}

__attribute__((noinline)) static int partial(const short *x, int count, int *seen) {
  int sum = 0;
  for (int i = 0; i < count; i++) {
    sum += x[i] * 3;
    seen[i & 3] = sum;
  }
  return sum;
}

__attribute__((noinline)) static int minus(const short *x, const short *y, int count) {
  int sum = 0;
  for (int i = 0; i < count; i++) sum -= x[i] * y[i];
  return sum;
}

__attribute__((noinline)) static long long wide(const short *x, const short *y, int count) {
  long long sum = 0;
  for (int i = 0; i < count; i++) sum += x[i] * y[i];
  return sum;
}

__attribute__((noinline)) static int nested(int rows, int count) {
  int total = 0;
  for (int row = 0; row < rows; row++) {
    int sum = row;
    for (int i = 0; i < count; i++) sum += a[i + row] * b[i];
    total ^= sum;
    for (int i = 0; i < count; i++) total += b[i] * a[i + row] >> 3;
  }
  return total;
}

int main(void) {
  unsigned state = 9;
  int seen[4] = {0};
  for (int i = 0; i < COUNT; i++) {
    a[i] = (short)((int)(next_number(&state) % 4001) - 2000);
    b[i] = (short)((int)(next_number(&state) % 401) - 200);
  }
  report("dot", (unsigned)dot(a, b, COUNT, 12));
  report("none", (unsigned)dot(a, b, 0, 99));
  report("one", (unsigned)dot(a, b, 1, -1));
  two(a, b, 200, seen);
  report("forward", (unsigned)seen[0]);
  report("backward", (unsigned)seen[1]);
  for (int i = 0; i < COUNT; i++) a[i] = b[i] = -32768;
  report("wrapping", wrapping(a, b, COUNT));
  for (int i = 0; i < COUNT; i++) {
    a[i] = (short)(i * 7 - 900);
    b[i] = (short)(COUNT - i);
  }
  report("partial", (unsigned)partial(a, 100, seen));
  report("seen", (unsigned)seen[1]);
  report("minus", (unsigned)minus(a, b, COUNT));
  report("wide", (unsigned)(wide(a, b, COUNT) >> 3));
  report("nested", (unsigned)nested(7, 50));
  return 0;
}
