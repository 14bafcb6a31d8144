/* Two loops on counters inside one; correlations. */
#include "report.h"
static short a[64], b[64], c[128];
__attribute__((noinline)) static int dot(const short *x, const short *y, int n) {
  int s = 0;
  for (int i = 0; i < n; i++) s += x[i] * y[i];
  return s;
}
__attribute__((noinline)) static void correlate(int n, int lags, int *to) {
  for (int lag = 0; lag < lags; lag++) {
    int s = 0;
    for (int i = 0; i < n; i++) s += a[i] * c[i + lag];
    int t = 0;
    for (int i = 0; i < n; i++) t += b[i] ^ c[i + lag];
    to[lag] = s - t;
  }
}
int main(void) {
  int out[20];
  unsigned state = 12, s = 0;
  for (int i = 0; i < 64; i++) a[i] = (short)(next_number(&state) % 2000 - 1000), b[i] = (short)next_number(&state);
  for (int i = 0; i < 128; i++) c[i] = (short)(next_number(&state) % 4000 - 2000);
  correlate(64, 20, out);
  for (int i = 0; i < 20; i++) s = mix(s, (unsigned)out[i]);
  report("lags", s);
  report("dot", (unsigned)dot(a, c, 64));
  return 0;
}
