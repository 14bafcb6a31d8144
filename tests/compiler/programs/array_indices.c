/* Arrays of several dimensions and the pointers into them: rows, columns, negative indices, one
 * past the end, differences, comparisons, elements of odd sizes, indices of every type. */
#include "report.h"

struct three {
  unsigned char b[3];
};
struct twelve {
  int a;
  short b[4];
};
static int grid[5][7];
static short cube[3][4][5];
static struct three triples[20];
static struct twelve dozens[9];
static unsigned char bytes[400];

APART static int row_sum(const int (*rows)[7], int count) {
  int s = 0;
  for (; count > 0; count--, rows++)
    for (int x = 6; x >= 0; x--)
      s = (s & 0xffff) * 2 + (*rows)[x];
  return s & 0xfffff;
}
APART static int column_sum(const int* p, int column) {
  int s = 0;
  for (const int* q = p + column; q < p + 35; q += 7)
    s ^= *q * 3;
  return s;
}
APART static int negative(const int* middle, int n) {
  int s = 0;
  for (int i = -n; i <= n; i++)
    s += middle[i] * i;
  return s + middle[-1] - *(middle - 2);
}
APART static int backwards(const short* end, const short* begin) {
  int s = 0;
  while (end != begin)
    s = (s * 3 + *--end) & 0xffff;
  return s;
}
APART static unsigned by_types(signed char a, unsigned char b, short c, unsigned short d,
                               long long e) {
  const unsigned char* p = bytes + 140;
  return mix(mix(p[a], p[b]), mix(p[c], p[d])) + p[e] + a[p] + (unsigned)(&p[a] - &p[c]);
}
APART static unsigned odd_sizes(int i, int j) {
  struct three* t = &triples[i];
  struct twelve* d = dozens + j;
  t[1].b[2] = (unsigned char)(t->b[0] + i);
  t[-1].b[1] ^= 5;
  d->b[i & 3] = (short)(d[-1].a + j);
  (d + 1)->a += d->b[1];
  return (unsigned)(t - triples) * 100 + (unsigned)(&d[1] - dozens) + t[0].b[2] +
         (unsigned)d[0].b[3];
}
APART static int between(const int* p, const int* low, const int* high) {
  return p >= low && p < high ? (int)(p - low) : -1;
}
APART static void transpose(int n, int m[n][n]) {
  for (int y = 0; y < n; y++)
    for (int x = 0; x < y; x++) {
      int t = m[y][x];
      m[y][x] = m[x][y];
      m[x][y] = t;
    }
}
static int chosen(int (*table)[2][2], int i) { return table[i >> 2][i >> 1 & 1][i & 1]; }

int main(void) {
  for (int i = 0; i < 35; i++)
    grid[i / 7][i % 7] = i * i - 50;
  for (int i = 0; i < 60; i++)
    cube[i / 20][i / 5 % 4][i % 5] = (short)(i * 11 - 200);
  for (int i = 0; i < 400; i++)
    bytes[i] = (unsigned char)(i * 7);
  unsigned s = (unsigned)row_sum(grid, 5) + (unsigned)row_sum(grid + 2, 1);
  for (int i = 0; i < 7; i++)
    s = mix(s, (unsigned)column_sum(grid[0], i));
  for (int i = 0; i < 5; i++)
    s = mix(s, (unsigned)negative(&grid[2][3], i));
  report("grid", s);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 4; j++)
      s = mix(s, (unsigned)(backwards(cube[i][j] + 5, cube[i][j]) + *(*(cube[i] + j) + 2)));
  report("cube", s);
  for (int i = -100; i < 100; i += 9)
    s = mix(s, by_types((signed char)i, (unsigned char)(i + 100), (short)-i,
                        (unsigned short)(i + 120), i));
  report("types", s);
  for (int i = 1; i < 19; i++)
    s = mix(s, odd_sizes(i, 1 + i % 7));
  report("sizes", s);
  report("between", (unsigned)(between(&grid[1][3], grid[1], grid[2]) * 10 +
                               between(grid[4], grid[0], grid[4])));
  int square[36], pairs[2][2][2] = {{{1, 2}, {3, 4}}, {{5, 6}, {7, 8}}};
  for (int i = 0; i < 36; i++)
    square[i] = i;
  transpose(6, (int(*)[6])square);
  for (int i = 0; i < 36; i++)
    s = mix(s, (unsigned)square[i]);
  for (int i = 0; i < 8; i++)
    s = mix(s, (unsigned)chosen(pairs, i));
  report("square", s);
  return 0;
}
