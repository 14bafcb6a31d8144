/* Arrays of halves, with the values where they wrap around or saturate, for programs about them. */
#ifndef HALVES_H
#define HALVES_H

#include "report.h"

enum { COUNT = 80 };

static short a[COUNT + 8], b[COUNT + 8], c[COUNT + 8];
static const short edges[] = {0,      1,   -1,   32767, -32768, 32766,
                              -32767, 255, -256, 16384, -16384, 12345};

#define MAGNITUDE(x) ((x) < 0 ? -(x) : (x))
#define LEAST(x, y) ((x) < (y) ? (x) : (y))
#define MOST(x, y) ((x) > (y) ? (x) : (y))
static short half(int x) { return (short)x; }
static int clamp(int x) { return x > 32767 ? 32767 : x < -32768 ? -32768 : x; }

static void fill(void) {
  unsigned state = 99;
  for (int i = 0; i < COUNT + 8; i++) {
    a[i] = i < 40 ? edges[i % 12] : half((int)next_number(&state));
    b[i] = i < 40 ? edges[i * 5 / 7 % 12] : half((int)next_number(&state));
    c[i] = half(i);
  }
}
static unsigned result(unsigned sum) {
  for (int i = 0; i < COUNT + 8; i++)
    sum = mix(sum, ((unsigned)a[i] << 16) ^ (unsigned)c[i]);
  fill();
  return sum;
}

#endif
