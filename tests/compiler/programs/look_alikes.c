/* Loops on halves that look like a signal processor's idioms and differ in one thing: sources that
 * are written in the loop, sums that wrap or are wider, odd addresses, steps, counts of none to
 * nine, signs, results that are read inside, filters in place, copies with a difference. */
#include "report.h"

typedef long long i64;
static short x[80], h[24], y[80];
static int words[40];

APART static int plain(const short* a, const short* b, int n) {
  int s = 0;
  for (int i = 0; i < n; i++)
    s += a[i] * b[i];
  return s;
}
APART static unsigned wrapping(const short* a, const short* b, int n) {
  unsigned s = 0xfffffff0u;
  for (int i = 0; i < n; i++)
    s += (unsigned)(a[i] * b[i]) * 3u;
  return s;
}
APART static i64 wide(const short* a, const short* b, int n) {
  i64 s = 1ll << 40;
  for (int i = 0; i < n; i++)
    s -= a[i] * b[i];
  return s;
}
APART static int unsigned_halves(const unsigned short* a, const short* b, int n) {
  int s = 0;
  for (int i = 0; i < n; i++)
    s += (a[i] >> 1) * (b[i] >> 2);
  return s;
}
APART static int written(short* a, const short* b, int n) {
  int s = 0;
  for (int i = 0; i < n; i++) {
    s += a[i] * b[i];
    a[i + 1] = (short)(s >> 9);
  }
  return s;
}
APART static int backwards(const short* a, const short* b, int n) {
  int s = 0;
  for (int i = 0; i < n; i++)
    s += a[i] * b[n - 1 - i] - a[n - 1 - i] * 5;
  return s;
}
APART static int steps(const short* a, int by, const short* b, int n) {
  int s = 0;
  for (int i = 0; i < n; i++, a += by)
    s += *a * b[2 * i];
  return s;
}
APART static int watched(const short* a, const short* b, int n, int* high) {
  int s = 0;
  for (int i = 0; i < n; i++) {
    s += a[i] * b[i];
    if (s > *high)
      *high = s;
  }
  return s;
}
APART static void two_sums(const short* a, const short* b, const short* c, int n, int* out) {
  int s = out[0], t = out[1];
  for (int i = 0; i < n; i++) {
    s += a[i] * b[i];
    t -= a[i] * c[i];
  }
  out[0] = s;
  out[1] = t;
}
APART static void complex_product(short* out, const short* a, const short* b, int n) {
  for (int i = 0; i < n; i += 2) {
    int re = a[i] * b[i] - a[i + 1] * b[i + 1], im = a[i] * b[i + 1] + a[i + 1] * b[i];
    out[i] = (short)(re >> 15);
    out[i + 1] = (short)(im >> 15);
  }
}
APART static void filter(short* out, const short* in, int n, const short* taps, int count) {
  for (int i = 0; i < n; i++) {
    int s = 0x4000;
    for (int k = 0; k < count; k++)
      s += in[i + k] * taps[k];
    out[i] = (short)(s >> 15);
  }
}
APART static void into_words(int* out, const short* in, int n, int count) {
  for (int i = 0; i < n; i++) {
    out[i] = 0;
    for (int k = 0; k <= count; k++)
      out[i] += in[i + k] * in[k];
  }
}
APART static void shifted_copy(short* to, const short* from, int n) {
  for (int i = 0; i < n; i++)
    to[i] = (short)((from[i] + from[i + 1]) >> 1);
}
APART static void halves_and_words(int* to, const short* from, int n) {
  for (int i = 0; i < n; i++)
    to[i] += from[2 * i] * 65536 / 2 + from[2 * i + 1];
}
APART static int mixed(const short* a, const int* b, const signed char* c, int n) {
  int s = 0;
  for (int i = 0; i < n; i++)
    s += a[i] * c[i] + (b[i] >> 20) * a[i];
  return s;
}
static void fill(unsigned seed) {
  for (int i = 0; i < 80; i++)
    x[i] = (short)((int)next_number(&seed) >> 3), y[i] = (short)(i * 77);
  for (int i = 0; i < 24; i++)
    h[i] = (short)((int)next_number(&seed) & 0x1fff);
  for (int i = 0; i < 40; i++)
    words[i] = (int)next_number(&seed) * 64;
}
static unsigned sum_of(void) {
  unsigned s = 0;
  for (int i = 0; i < 80; i++)
    s = mix(s, (unsigned)(x[i] * 3 + y[i]));
  for (int i = 0; i < 40; i++)
    s = mix(s, (unsigned)words[i]);
  return s;
}

int main(void) {
  unsigned s = 0;
  for (int n = 0; n < 10; n++)
    for (int odd = 0; odd < 2; odd++) {
      int high = 5, out[2] = {n, -n};
      fill((unsigned)(n + odd));
      s = mix(s, (unsigned)plain(x + odd, h, n) + wrapping(x, h + odd, n));
      s = mix_long(s, (unsigned long long)wide(x + odd, h + odd, n));
      s = mix(s, (unsigned)unsigned_halves((unsigned short*)x + odd, h, n));
      s = mix(s, (unsigned)(backwards(x, h + odd, n) + steps(x + 30, odd ? -3 : 2, h, n)));
      s = mix(s, (unsigned)(watched(x + odd, h, n, &high) ^ high));
      two_sums(x, h + odd, odd ? h : x + 1, n, out);
      s = mix(mix(s, (unsigned)out[0]), (unsigned)out[1]);
      s = mix(s, (unsigned)(mixed(x, words + odd, (signed char*)h + odd, n)));
      s = mix(s, (unsigned)written(x + odd, h, n));
      complex_product(odd ? x + 40 : y + 1, x + 40, h, 2 * n);
      filter(y, x, n * 3, h, n);
      filter(x + odd, x, 9, h, 4);
      into_words(words + odd, x, n * 2, n);
      shifted_copy(x + 50 + odd, x + 50, n * 2);
      halves_and_words(words, y + odd, n * 3);
      s = mix(s, sum_of());
    }
  report("sums", s);
  return 0;
}
