/* Kernels on pictures of bytes: convolution, medians, thresholds, histograms with stretching,
 * integral pictures, erosion, differences of blocks, halving, colours, drawing of lines, filling of
 * areas. */
#include <string.h>

#include "report.h"

typedef unsigned char u8;
#define W 40
#define H 24
static u8 a[H][W], b[H][W], c[H][W];
static unsigned integral[H + 1][W + 1];

APART static void smooth(u8 (*out)[W], const u8 (*in)[W]) {
  for (int y = 1; y < H - 1; y++)
    for (int x = 1; x < W - 1; x++)
      out[y][x] =
          (u8)((in[y - 1][x] + in[y][x - 1] + 4 * in[y][x] + in[y][x + 1] + in[y + 1][x] + 4) >> 3);
}
APART static void edges(u8 (*out)[W], const u8 (*in)[W]) {
  for (int y = 1; y < H - 1; y++)
    for (int x = 1; x < W - 1; x++) {
      int dx = in[y - 1][x + 1] + 2 * in[y][x + 1] + in[y + 1][x + 1] - in[y - 1][x - 1] -
               2 * in[y][x - 1] - in[y + 1][x - 1];
      int dy = in[y + 1][x - 1] + 2 * in[y + 1][x] + in[y + 1][x + 1] - in[y - 1][x - 1] -
               2 * in[y - 1][x] - in[y - 1][x + 1];
      int size = (dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy);
      out[y][x] = (u8)(size > 255 ? 255 : size);
    }
}
static inline void order(u8* p, u8* q) {
  if (*p > *q) {
    u8 t = *p;
    *p = *q;
    *q = t;
  }
}
APART static void median(u8 (*out)[W], const u8 (*in)[W]) {
  for (int y = 1; y < H - 1; y++)
    for (int x = 1; x < W - 1; x++) {
      u8 v[9];
      for (int i = 0; i < 9; i++)
        v[i] = in[y - 1 + i / 3][x - 1 + i % 3];
      for (int i = 0; i < 5; i++)
        for (int k = 8; k > i; k--)
          order(&v[k - 1], &v[k]);
      out[y][x] = v[4];
    }
}
APART static int threshold_of(const u8* p, int n) {
  int histogram[256] = {0}, below = 0, best = 0;
  long long largest = -1, sum = 0, part = 0;
  for (int i = 0; i < n; i++)
    histogram[p[i]]++;
  for (int i = 0; i < 256; i++)
    sum += i * histogram[i];
  for (int i = 0; i < 256; i++) {
    below += histogram[i];
    part += i * histogram[i];
    if (below == 0 || below == n)
      continue;
    long long d = part * n - sum * below, between = d / below * (d / (n - below));
    if (between > largest) {
      largest = between;
      best = i;
    }
  }
  return best;
}
APART static void integrate(const u8 (*in)[W]) {
  for (int y = 0; y < H; y++) {
    unsigned row = 0;
    for (int x = 0; x < W; x++)
      integral[y + 1][x + 1] = integral[y][x + 1] + (row += in[y][x]);
  }
}
static unsigned area(int x0, int y0, int x1, int y1) {
  return integral[y1][x1] - integral[y0][x1] - integral[y1][x0] + integral[y0][x0];
}
APART static int block_difference(const u8* p, const u8* q, int limit) {
  int sum = 0;
  for (int y = 0; y < 8 && sum < limit; y++, p += W, q += W)
    for (int x = 0; x < 8; x++)
      sum += p[x] > q[x] ? p[x] - q[x] : q[x] - p[x];
  return sum;
}
APART static void line(u8 (*out)[W], int x0, int y0, int x1, int y1, u8 value) {
  int dx = x1 > x0 ? x1 - x0 : x0 - x1, dy = y1 > y0 ? y0 - y1 : y1 - y0, error = dx + dy;
  for (;;) {
    out[y0][x0] = value;
    if (x0 == x1 && y0 == y1)
      return;
    int twice = 2 * error;
    if (twice >= dy)
      error += dy, x0 += x0 < x1 ? 1 : -1;
    if (twice <= dx)
      error += dx, y0 += y0 < y1 ? 1 : -1;
  }
}
static int fill(u8 (*out)[W], int x, int y, u8 from, u8 to) {
  if (x < 0 || y < 0 || x >= W || y >= H || out[y][x] != from)
    return 0;
  out[y][x] = to;
  return 1 + fill(out, x + 1, y, from, to) + fill(out, x - 1, y, from, to) +
         fill(out, x, y + 1, from, to) + fill(out, x, y - 1, from, to);
}
static unsigned sum_of(const u8 (*p)[W]) {
  unsigned s = 0;
  for (int i = 0; i < W * H; i++)
    s = mix(s, p[i / W][i % W]);
  return s;
}

int main(void) {
  unsigned state = 7, s = 0;
  for (int y = 0; y < H; y++)
    for (int x = 0; x < W; x++)
      a[y][x] = (u8)(x * 4 + y * 2 + (int)(next_number(&state) & 31) + (x > 20 && y > 9 ? 70 : 0));
  smooth(b, a);
  report("smooth", sum_of(b));
  edges(c, b);
  report("edges", sum_of(c));
  median(c, a);
  report("median", sum_of(c));
  report("threshold", (unsigned)threshold_of(a[0], W * H));
  integrate(a);
  for (int i = 0; i < 20; i++)
    s = mix(s, area(i, i / 2, 20 + i, 10 + i / 2));
  report("areas", s);
  int best = 1 << 30, at = 0;
  for (int x = 0; x <= W - 8; x++) {
    int d = block_difference(&a[8][12], &b[8][x], best);
    if (d < best)
      best = d, at = x;
  }
  report("block", (unsigned)(best * 100 + at));
  memset(c, 0, sizeof c);
  line(c, 2, 3, 37, 9, 1);
  line(c, 37, 9, 5, 22, 1);
  line(c, 5, 22, 2, 3, 1);
  report("filled", (unsigned)fill(c, 8, 10, 0, 2) + sum_of(c));
  return 0;
}
