/* Filters of 16-bit fractions as signal processing writes them: finite and recursive ones,
 * decimating, interpolating, adaptive, in cascades, over rings; rounding, saturation, block
 * exponents. */
#include "report.h"

#define N 96
static short input[N], output[N], ring[16];
static const short taps[16] = {120,   -340, 560,   -900, 1500, -2600, 5200, 20000,
                               20000, 5200, -2600, 1500, -900, 560,   -340, 120};

static inline short clip(int x) { return (short)(x > 32767 ? 32767 : x < -32768 ? -32768 : x); }
static inline short rounded(int x) { return clip((x + 0x4000) >> 15); }

APART static void direct(short* out, const short* in, int n, const short* h, int count) {
  for (int i = 0; i + count <= n; i++) {
    int sum = 0;
    for (int k = 0; k < count; k++)
      sum += in[i + k] * h[k];
    out[i] = rounded(sum);
  }
}
APART static void symmetric(short* out, const short* in, int n) {
  for (int i = 0; i + 16 <= n; i++) {
    int sum = 0;
    for (int k = 0; k < 8; k++)
      sum += ((in[i + k] >> 1) + (in[i + 15 - k] >> 1)) * taps[k];
    out[i] = clip(sum >> 14);
  }
}
APART static int decimate(short* out, const short* in, int n, int by) {
  int written = 0;
  for (int i = 0; i + 16 <= n; i += by) {
    int sum = 1 << 14;
    for (int k = 0; k < 16; k++)
      sum += taps[k] * in[i + k];
    out[written++] = clip(sum >> 15);
  }
  return written;
}
APART static void through_ring(short* out, const short* in, int n) {
  unsigned at = 0;
  for (int i = 0; i < n; i++) {
    int sum = 0;
    ring[at] = in[i];
    for (unsigned k = 0; k < 16; k++)
      sum += taps[k] * ring[(at - k) & 15];
    at = (at + 1) & 15;
    out[i] = rounded(sum);
  }
}
struct section {
  short b0, b1, b2, a1, a2, x1, x2, y1, y2;
};
APART static void cascade(short* samples, int n, struct section* sections, int count) {
  for (int s = 0; s < count; s++) {
    struct section* p = &sections[s];
    for (int i = 0; i < n; i++) {
      long long sum = (long long)p->b0 * samples[i] + p->b1 * p->x1 + p->b2 * p->x2;
      sum -= (long long)p->a1 * p->y1 + p->a2 * p->y2;
      p->x2 = p->x1;
      p->x1 = samples[i];
      p->y2 = p->y1;
      samples[i] = p->y1 = clip((int)(sum >> 14));
    }
  }
}
APART static int adapt(short* h, const short* x, const short* wanted, int n) {
  int last = 0;
  for (int i = 7; i < n; i++) {
    int sum = 0;
    for (int k = 0; k < 8; k++)
      sum += h[k] * x[i - k];
    last = clip(wanted[i] - (sum >> 15));
    for (int k = 0; k < 8; k++)
      h[k] = clip(h[k] + (last * x[i - k] >> 18));
  }
  return last;
}
APART static int energy(const short* x, int n, int* exponent) {
  int sum = 0, shift = 0;
  for (int i = 0; i < n; i++) {
    int square = x[i] * x[i] >> shift;
    while (sum > 0x7fffffff - square) {
      sum >>= 1;
      square >>= 1;
      shift++;
    }
    sum += square;
  }
  *exponent = shift;
  return sum;
}
APART static int normalise(short* x, int n) {
  int largest = 1, shift = 0;
  for (int i = 0; i < n; i++) {
    int size = x[i] < 0 ? -x[i] : x[i];
    largest = size > largest ? size : largest;
  }
  while (largest < 0x4000) {
    largest <<= 1;
    shift++;
  }
  for (int i = 0; i < n; i++)
    x[i] = (short)(x[i] * (1 << shift));
  return shift;
}
static unsigned sum_of(const short* p, int n) {
  unsigned s = (unsigned)n;
  for (int i = 0; i < n; i++)
    s = mix(s, (unsigned)p[i]);
  return s;
}

int main(void) {
  unsigned state = 17;
  for (int i = 0; i < N; i++)
    input[i] = (short)(next_number(&state) / (i & 8 ? 1 : 7));
  direct(output, input, N, taps, 16);
  report("direct", sum_of(output, N - 15));
  direct(output, input + 1, N - 1, taps + 3, 5);
  report("five", sum_of(output, N - 5));
  symmetric(output, input, N);
  report("symmetric", sum_of(output, N - 15));
  report("decimated", sum_of(output, decimate(output, input, N, 3)));
  through_ring(output, input, N);
  report("ring", sum_of(output, N));
  struct section sections[2] = {{3000, 6000, 3000, -20000, 8000, 0, 0, 0, 0},
                                {16000, -16000, 0, -9000, 0, 0, 0, 0, 0}};
  cascade(output, N, sections, 2);
  report("cascade", sum_of(output, N));
  short h[8] = {0};
  report("adapted", (unsigned)adapt(h, input, output, N) + sum_of(h, 8));
  int exponent;
  unsigned sum = (unsigned)energy(input, N, &exponent);
  report("energy", mix(sum, (unsigned)exponent));
  for (int i = 0; i < N; i++)
    output[i] = (short)(output[i] >> 7);
  sum = (unsigned)normalise(output, N);
  report("normalised", mix(sum, sum_of(output, N)));
  return 0;
}
