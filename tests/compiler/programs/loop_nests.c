/* Nests of loops up to five deep: rectangular, triangular, with bounds from memory, with code
 * between the loops, several inner ones in a row, empty inner ones, and a nest inside a branch. */
#include "report.h"

static short cube[4][5][6];
static unsigned char widths[8] = {3, 0, 5, 1, 0, 2, 7, 4};

APART static unsigned five_deep(int n) {
  unsigned s = 0;
  for (int a = 0; a < n; a++)
    for (int b = a; b < n; b++)
      for (int c = 0; c <= b; c++)
        for (int d = n; d > c; d--)
          for (int e = d; e < n + 1; e += 2)
            s += (unsigned)(a + b * c - d * e);
  return s;
}
APART static int ragged(void) {
  int s = 0;
  for (int row = 0; row < 8; row++) {
    s += row * 1000;
    for (int column = 0; column < widths[row]; column++)
      s ^= row * column + 1;
    s -= 3;
  }
  return s;
}
APART static void fill(void) {
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 5; j++)
      for (int k = 0; k < 6; k++)
        cube[i][j][k] = (short)(i * 100 + j * 10 - k * 3);
}
APART static int sums_of_planes(int* plane, int* row) {
  int all = 0;
  for (int i = 0; i < 4; i++) {
    plane[i] = 0;
    for (int j = 0; j < 5; j++) {
      int sum = 0, largest = -32768;
      for (int k = 0; k < 6; k++)
        sum += cube[i][j][k];
      for (int k = 0; k < 6; k++)
        if (cube[i][j][k] > largest)
          largest = cube[i][j][k];
      row[i * 5 + j] = sum - largest;
      plane[i] += sum;
    }
    all ^= plane[i];
  }
  return all;
}
APART static int in_a_branch(int n, int flag) {
  int s = 0;
  for (int i = 0; i < n; i++) {
    if ((i & 1) == flag) {
      for (int j = 0; j < i; j++)
        s += j * i;
    } else {
      for (int j = i; j > 0; j -= 2)
        for (int k = 0; k < j; k++)
          s ^= k + j;
    }
  }
  return s;
}
APART static int same_counter(int n) {
  int i, s = 0;
  for (i = 0; i < n; i++)
    s += i;
  for (i--; i >= 0; i -= 2)
    s -= i;
  for (; i < n; i += 3)
    s = s * 2 + i;
  return s + i;
}
APART static unsigned convolve(const unsigned char* p, int width, int height) {
  static const signed char kernel[3][3] = {{-1, 2, -1}, {2, 4, 2}, {-1, 2, -1}};
  unsigned s = 0;
  for (int y = 1; y < height - 1; y++)
    for (int x = 1; x < width - 1; x++) {
      int sum = 0;
      for (int v = -1; v <= 1; v++)
        for (int u = -1; u <= 1; u++)
          sum += kernel[v + 1][u + 1] * p[(y + v) * width + x + u];
      s = mix(s, (unsigned)sum);
    }
  return s;
}

int main(void) {
  for (int n = 0; n < 7; n++)
    report("five", five_deep(n));
  report("ragged", (unsigned)ragged());
  fill();
  int plane[4], row[20];
  unsigned s = (unsigned)sums_of_planes(plane, row);
  for (int i = 0; i < 20; i++)
    s = mix(s, (unsigned)(row[i] + plane[i & 3]));
  report("planes", s);
  for (int n = 0; n < 14; n++)
    s = mix(s, (unsigned)(in_a_branch(n, n & 1) + same_counter(n)));
  report("branches", s);
  unsigned char image[12 * 9];
  for (int i = 0; i < 12 * 9; i++)
    image[i] = (unsigned char)(i * i * 7);
  report("convolved", convolve(image, 12, 9) + convolve(image, 2, 9));
  return 0;
}
