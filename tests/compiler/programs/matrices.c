/* Products of matrices, convolution, fixed point rows. */
#include "report.h"
static int a[7][9], b[9][5], c[7][5];
static short fixed[16][16];
__attribute__((noinline)) static void multiply(void) {
  for (int i = 0; i < 7; i++)
    for (int j = 0; j < 5; j++) {
      int sum = 0;
      for (int k = 0; k < 9; k++) sum += a[i][k] * b[k][j];
      c[i][j] = sum;
    }
}
__attribute__((noinline)) static int convolve(const short (*m)[16], int y, int x) {
  static const signed char kernel[3][3] = {{-1, 2, -1}, {2, 5, 2}, {-1, 2, -1}};
  int sum = 0;
  for (int dy = 0; dy < 3; dy++)
    for (int dx = 0; dx < 3; dx++) sum += kernel[dy][dx] * m[y + dy][x + dx];
  return sum >> 3;
}
int main(void) {
  unsigned state = 8, s = 0;
  for (int i = 0; i < 63; i++) a[0][i] = (int)(next_number(&state) % 200) - 100;
  for (int i = 0; i < 45; i++) b[0][i] = (int)(next_number(&state) % 3000) - 1500;
  multiply();
  for (int i = 0; i < 35; i++) s = mix(s, (unsigned)c[0][i]);
  report("product", s);
  for (int i = 0; i < 256; i++) fixed[0][i] = (short)next_number(&state);
  for (int y = 0; y < 14; y++)
    for (int x = 0; x < 14; x++) s = mix(s, (unsigned)convolve((const short (*)[16])fixed, y, x));
  report("convolution", s);
  return 0;
}
