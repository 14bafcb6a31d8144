/* Loops of many shapes: four deep, with breaks, with exits, downward, with branches inside. */
#include "report.h"
static unsigned char image[12][16][3];
static short out[16][12];
__attribute__((noinline)) static unsigned four_deep(int a, int b, int c, int d) {
  unsigned s = 0;
  for (int i = 0; i < a; i++)
    for (int j = 0; j < b; j++)
      for (int k = 0; k < c; k++)
        for (int l = 0; l < d; l++) s = mix(s, (unsigned)(i * 1000 + j * 100 + k * 10 + l));
  return s;
}
__attribute__((noinline)) static void transpose(void) {
  for (int y = 0; y < 12; y++)
    for (int x = 0; x < 16; x++) out[x][y] = (short)(image[y][x][0] + image[y][x][1] * 2 - image[y][x][2]);
}
__attribute__((noinline)) static int first_match(const unsigned char *p, int n, int what) {
  for (int i = 0; i < n; i++)
    if (p[i] == what) return i;
  return -1;
}
__attribute__((noinline)) static unsigned triangle(int n) {
  unsigned s = 0;
  for (int i = 0; i < n; i++)
    for (int j = i; j < n; j += 2) {
      if ((i ^ j) % 5 == 4) continue;
      s += (unsigned)(i * j);
      if (s > 100000) break;
    }
  return s;
}
__attribute__((noinline)) static unsigned with_exit(const unsigned char *p, int rows, int columns) {
  unsigned s = 0;
  for (int y = 0; y < rows; y++)
    for (int x = 0; x < columns; x++) {
      s += p[y * columns + x];
      if (s > 3000) goto done;
    }
done:
  return s;
}
__attribute__((noinline)) static unsigned downward(const unsigned *p, int n) {
  unsigned s = 0;
  while (n-- > 0) s = mix(s, p[n]);
  do s += 3; while (++n < 10);
  return s;
}
__attribute__((noinline)) static unsigned with_branch(const short *p, int n) {
  unsigned s = 0;
  for (int i = 0; i < n; i++) {
    if (p[i] < 0) s -= (unsigned)p[i] * 3;
    else if (p[i] & 1) s ^= (unsigned)p[i];
    else s += (unsigned)i;
  }
  return s;
}
int main(void) {
  unsigned state = 9, s = 0;
  for (unsigned i = 0; i < sizeof image; i++) ((unsigned char *)image)[i] = (unsigned char)next_number(&state);
  report("deep", four_deep(3, 4, 5, 6));
  report("empty", four_deep(3, 0, 5, 6));
  transpose();
  for (int i = 0; i < 16 * 12; i++) s = mix(s, (unsigned)out[0][i]);
  report("transpose", s);
  report("match", (unsigned)first_match(&image[0][0][0], 500, image[5][3][1]));
  report("none", (unsigned)first_match(&image[0][0][0], 0, 3));
  report("triangle", triangle(30));
  report("exit", with_exit(&image[0][0][0], 12, 48));
  report("downward", downward((unsigned *)(void *)image, 100));
  report("branch", with_branch(&out[0][0], 192));
  return 0;
}
