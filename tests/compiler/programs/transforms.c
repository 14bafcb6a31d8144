/* Transforms in integers: a Fourier transform of 64 points in 16 bits with scaling, a cosine
 * transform of 8 by 8, Hadamard's, a wavelet by lifting and back, angles by shifts and sums. */
#include "report.h"

struct complex {
  short re, im;
};
static short sines[64];

static int sine(int angle) { /* 0 to 63 is a turn; by the recurrence of a rotation, once */
  return sines[angle & 63];
}
static void make_sines(void) {
  long long c = 1 << 30, s = 0;
  for (int i = 0; i < 64; i++) {
    sines[i] = (short)((s >> 15) - (s >> 30));
    long long t = (c * 1068571464 - s * 105245103) >> 30;
    s = (s * 1068571464 + c * 105245103) >> 30;
    c = t;
  }
}
APART static void fourier(struct complex* x) {
  for (int i = 0; i < 64; i++) {
    int j = 0;
    for (int bit = 0; bit < 6; bit++)
      j |= (i >> bit & 1) << (5 - bit);
    if (j > i) {
      struct complex t = x[i];
      x[i] = x[j];
      x[j] = t;
    }
  }
  for (int half = 1; half < 64; half *= 2)
    for (int start = 0; start < 64; start += 2 * half)
      for (int k = 0; k < half; k++) {
        int wr = sine(k * 32 / half + 16), wi = -sine(k * 32 / half);
        struct complex *a = &x[start + k], *b = a + half;
        int re = (b->re * wr - b->im * wi) >> 15, im = (b->re * wi + b->im * wr) >> 15;
        *b = (struct complex){(short)((a->re - re) >> 1), (short)((a->im - im) >> 1)};
        *a = (struct complex){(short)((a->re + re) >> 1), (short)((a->im + im) >> 1)};
      }
}
APART static void cosine(short block[8][8]) {
  static const short c[8][8] = {
      {91, 91, 91, 91, 91, 91, 91, 91},         {126, 106, 71, 25, -25, -71, -106, -126},
      {118, 49, -49, -118, -118, -49, 49, 118}, {106, -25, -126, -71, 71, 126, 25, -106},
      {91, -91, -91, 91, 91, -91, -91, 91},     {71, -126, 25, 106, -106, -25, 126, -71},
      {49, -118, 118, -49, -49, 118, -118, 49}, {25, -71, 106, -126, 126, -106, 71, -25}};
  int middle[8][8];
  for (int v = 0; v < 8; v++)
    for (int x = 0; x < 8; x++) {
      int sum = 0;
      for (int y = 0; y < 8; y++)
        sum += c[v][y] * block[y][x];
      middle[v][x] = (sum + 128) >> 8;
    }
  for (int v = 0; v < 8; v++)
    for (int u = 0; u < 8; u++) {
      int sum = 0;
      for (int x = 0; x < 8; x++)
        sum += c[u][x] * middle[v][x];
      block[v][u] = (short)((sum + 128) >> 8);
    }
}
APART static void hadamard(int* x, int n) {
  for (int half = 1; half < n; half *= 2)
    for (int i = 0; i < n; i++)
      if (!(i & half)) {
        int a = x[i], b = x[i + half];
        x[i] = a + b;
        x[i + half] = a - b;
      }
}
APART static void wavelet(short* x, int n, int back) {
  for (int pass = 0; pass < 2; pass++) {
    int odd = pass == back, sign = back ? -1 : 1;
    if (!odd)
      for (int i = 1; i < n; i += 2)
        x[i] = (short)(x[i] - sign * ((x[i - 1] + x[i + 1 < n ? i + 1 : i - 1]) >> 1));
    else
      for (int i = 0; i < n; i += 2)
        x[i] = (short)(x[i] + sign * ((x[i > 0 ? i - 1 : 1] + x[i + 1] + 2) >> 2));
  }
}
APART static int angle(int x, int y, int* length) {
  static const short turns[] = {8192, 4836, 2555, 1297, 651, 326, 163, 81, 41, 20, 10, 5, 3, 1};
  int sum = 0;
  if (x < 0) {
    sum = y < 0 ? -32768 : 32767;
    x = -x;
    y = -y;
  }
  for (int i = 0; i < 14; i++) {
    int t = x;
    if (y > 0) {
      x += y >> i;
      y -= t >> i;
      sum += turns[i];
    } else {
      x -= y >> i;
      y += t >> i;
      sum -= turns[i];
    }
  }
  *length = x;
  return sum;
}

int main(void) {
  static struct complex x[64];
  static short block[8][8], line[64];
  int numbers[32], length;
  unsigned state = 3, s = 0;
  make_sines();
  for (int i = 0; i < 64; i++)
    x[i] = (struct complex){(short)(sine(i * 5) / 2 + (int)(next_number(&state) % 200)),
                            (short)(i * 90)};
  fourier(x);
  for (int i = 0; i < 64; i++)
    s = mix(s, (unsigned)(x[i].re * 65536 + x[i].im));
  report("fourier", s);
  for (int i = 0; i < 64; i++)
    block[i / 8][i % 8] = (short)((int)(next_number(&state) & 255) - 128);
  cosine(block);
  for (int i = 0; i < 64; i++)
    s = mix(s, (unsigned)block[i / 8][i % 8]);
  report("cosine", s);
  for (int i = 0; i < 32; i++)
    numbers[i] = i * i - 200;
  hadamard(numbers, 32);
  for (int i = 0; i < 32; i++)
    s = mix(s, (unsigned)numbers[i]);
  report("hadamard", s);
  for (int i = 0; i < 64; i++)
    line[i] = (short)(i * i % 211 + i);
  wavelet(line, 64, 0);
  for (int i = 0; i < 64; i++)
    s = mix(s, (unsigned)line[i]);
  wavelet(line, 64, 1);
  int same = 1;
  for (int i = 0; i < 64; i++)
    same &= line[i] == i * i % 211 + i;
  report("wavelet", mix(s, (unsigned)same));
  for (int i = -5; i < 6; i++)
    s = mix(s, (unsigned)(angle(3000 * i + 7, 20000 - 3100 * i, &length) + length));
  report("angles", s);
  return 0;
}
