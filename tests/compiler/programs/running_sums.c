/* Sums over windows that are updated, not made anew. */
#include "report.h"
static unsigned char image[20][24];
static unsigned short columns[24];
static unsigned means[20][24], variances[20][24];
__attribute__((noinline)) static void means_of(int half) {
  for (int y = half; y < 20 - half; y++) {
    for (int x = 0; x < 24; x++) {
      unsigned s = 0;
      for (int k = -half; k <= half; k++) s += image[y + k][x];
      columns[x] = (unsigned short)s;
    }
    unsigned window = 0;
    for (int x = 0; x < 2 * half; x++) window += columns[x];
    for (int x = half; x < 24 - half; x++) {
      window += columns[x + half];
      means[y][x] = window;
      window -= columns[x - half];
    }
  }
}
__attribute__((noinline)) static unsigned variance(int y, int x, int half) {
  unsigned sum = 0, squares = 0, n = (unsigned)((2 * half + 1) * (2 * half + 1));
  for (int dy = -half; dy <= half; dy++)
    for (int dx = -half; dx <= half; dx++) {
      unsigned p = image[y + dy][x + dx];
      sum += p;
      squares += p * p;
    }
  return (squares * n - sum * sum) / (n * n);
}
int main(void) {
  unsigned state = 31, s = 0;
  for (int i = 0; i < 480; i++) image[0][i] = (unsigned char)next_number(&state);
  means_of(2);
  for (int y = 4; y < 16; y++)
    for (int x = 4; x < 20; x++) variances[y][x] = variance(y, x, 4);
  for (int i = 0; i < 480; i++) s = mix(mix(s, means[0][i]), variances[0][i]);
  report("sums", s);
  return 0;
}
