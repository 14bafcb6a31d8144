/* More values than registers: deep expressions, many locals across calls and loops, arguments of
 * all types and sizes, sums whose operands wait for calls, several 64-bit accumulators at once. */
#include "report.h"

typedef long long i64;

APART static int id(int x) { return x; }
APART static int deep(int a, int b, int c, int d, int e, int f, int g, int h) {
  return ((((a + b) * (c - d)) ^ ((e * f) - (g ^ h))) +
          (((a * c) ^ (b * d)) - ((e - g) * (f + h)))) *
             ((((a ^ h) + (b ^ g)) ^ ((c ^ f) - (d ^ e))) | 1) -
         ((a * b - c * d) ^ (e * f + g * h) ^ (a * h - b * g));
}
APART static int across_calls(int a, int b) {
  int c = id(a + 1), d = id(b + 2), e = id(c * 3), f = id(d - 4), g = id(e ^ 5), h = id(f + 6),
      i = id(g - 7), j = id(h * 8), k = id(i + 9), l = id(j ^ 10);
  return id(a + b) * 2 + id(c + d) * 3 + id(e + f) * 5 + id(g + h) * 7 + id(i + j) * 11 +
         id(k + l) * 13;
}
APART static i64 all_types(char a, unsigned char b, short c, unsigned short d, int e, unsigned f,
                           i64 g, unsigned long long h, float i, double j, _Bool k, const int* l,
                           char m, i64 n, short o) {
  return a * 2 + b * 3 + c * 5 + d * 7 + e * 11 + (i64)f * 13 + g * 17 + (i64)h * 19 +
         (i64)(i * 4) + (i64)(j * 8) + k * 1000000 + *l + m * 23 + n * 29 + o * 31;
}
APART static unsigned twelve_sums(const short* p, int n) {
  int a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0, i = 0, j = 0, k = 0, l = 0;
  for (int t = 0; t < n; t++) {
    int x = p[t];
    a += x;
    b ^= x * 3;
    c -= x >> 1;
    d |= x;
    e += x * t;
    f ^= t << 2;
    g = (g & 0xffff) + (a & b);
    h -= c ^ t;
    i += x > 0;
    j ^= d + e;
    k += x < t;
    l = l / 2 + x;
  }
  return mix(
      mix(mix((unsigned)(a + b), (unsigned)(c + d)), mix((unsigned)(e + f), (unsigned)(g + h))),
      mix((unsigned)(i + j), (unsigned)(k + l)));
}
APART static i64 wide_sums(const int* p, int n) {
  i64 a = 1, b = 2, c = 3, d = 4;
  for (int i = 0; i < n; i++) {
    a += (i64)p[i] * 3;
    b ^= a + i;
    c = c + (b >> 7) - p[i];
    d -= c ^ a;
  }
  return a + b + c + d;
}
APART static int nested_calls(int x) {
  return id(id(id(x) + id(x + 1)) * id(id(x - 1) - id(id(x + 2)))) + id(x ? id(x * 2) : id(3));
}
APART static double mixed(double a, float b, int c, i64 d) {
  double e = a * b, f = a + c, g = b - (double)d, h = e / 2, i = f * g, j = a - g;
  return id(c) + e + f * 0.5 + g * 0.25 + h + i + j * id((int)d);
}
APART static unsigned in_loops(const unsigned char* p, int width, int height, int a, int b, int c,
                               int d) {
  unsigned s = 0;
  for (int y = 0; y < height; y++) {
    int left = a * y, right = b + y, third = c ^ y, fourth = d - y;
    for (int x = 0; x < width; x++) {
      int v = p[y * width + x];
      s += (unsigned)((v + left) * a ^ (v - right) * b ^ (v * third + c) ^ (fourth * x - d));
      if ((v & 7) == 3)
        s += (unsigned)id(left + right + third + fourth);
    }
  }
  return s;
}

int main(void) {
  unsigned s = 0, state = 3;
  short halves[50];
  int words[30], seven = 7;
  unsigned char bytes[120];
  for (int i = 0; i < 50; i++)
    halves[i] = (short)next_number(&state);
  for (int i = 0; i < 30; i++)
    words[i] = (int)next_number(&state) - 8000000;
  for (int i = 0; i < 120; i++)
    bytes[i] = (unsigned char)next_number(&state);
  for (int i = 0; i < 10; i++) {
    s = mix(s, (unsigned)deep(i, i + 1, 2 * i, 7, i - 3, 4, 9 - i, i ^ 5));
    s = mix(s, (unsigned)across_calls(i, i * i));
    s = mix(s, (unsigned)nested_calls(i));
  }
  report("deep", s);
  report("types", mix_long(0, (unsigned long long)all_types('a', 200, -300, 60000, -100000,
                                                            3000000000u, 1ll << 33, 1ull << 40,
                                                            1.75f, -2.5, 1, &seven, 'm', -5, 6)));
  report("sums", twelve_sums(halves, 50));
  report("wide", mix_long(0, (unsigned long long)wide_sums(words, 30)));
  report("mixed", (unsigned)(int)(mixed(1.5, 2.25f, 7, -3) * 1000));
  report("loops", in_loops(bytes, 12, 10, 3, 5, 7, 11) + in_loops(bytes, 1, 9, -1, -2, -3, -4));
  return 0;
}
