/* Loops on the loop counters: unknown counts, none, nests, long bodies, calls inside. */
#include "report.h"
static unsigned short row[31];
static unsigned grid[6][5][4];
__attribute__((noinline)) static void fill(unsigned short *p, int n, unsigned short v) {
  for (int i = 0; i < n; i++) p[i] = v;
}
__attribute__((noinline)) static unsigned unknown_counts(int a, int b, int c) {
  unsigned s = 0;
  for (int i = 0; i < a; i++) {
    for (int j = i; j < b; j++) s += (unsigned)(i ^ j);
    for (int k = 0; k < c - i; k++) s = s * 3 + (unsigned)k;
  }
  return s;
}
__attribute__((noinline)) static unsigned same_end(void) {
  unsigned s = 0;
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 5; j++)
      for (int k = 0; k < 4; k++) s = mix(s, grid[i][j][k] += (unsigned)(i + j * k));
  return s;
}
__attribute__((noinline)) static unsigned steps_of_three(unsigned n) {
  unsigned s = 0;
  for (unsigned i = 1; i < n; i += 3) s += i * i;
  return s;
}
__attribute__((noinline)) static int leaves_early(const unsigned short *p, int n) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < 3; j++)
      if (p[i] == j + 100) return i * 10 + j;
  return -1;
}
__attribute__((noinline)) static unsigned call_inside(int n) {
  unsigned s = 0;
  for (int i = 0; i < n; i++) s += steps_of_three((unsigned)i) / 3u;
  return s;
}
__attribute__((noinline)) static unsigned branches_to_latch(int n) {
  unsigned s = 1;
  for (int i = 0; i < n; i++) {
    if (s & 1) {
      if (s & 2) continue;
      s += 7;
      continue;
    }
    if (s % 5 == 0) continue;
    s = s * 9 + (unsigned)i;
  }
  return s;
}
int main(void) {
  fill(row, 31, 7);
  fill(row, 0, 9);
  fill(row + 3, 1, 101);
  unsigned s = 0;
  for (int i = 0; i < 31; i++) s = mix(s, row[i]);
  report("fill", s);
  report("unknown", mix(unknown_counts(7, 9, 5), unknown_counts(0, 1, 2)));
  report("same", same_end());
  report("three", steps_of_three(100) + steps_of_three(0));
  report("early", (unsigned)leaves_early(row, 31));
  report("call", call_inside(40));
  report("latch", branches_to_latch(33));
  return 0;
}
