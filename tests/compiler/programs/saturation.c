/* Saturating arithmetic as C programs write it: by wider types, by comparisons, by signs, by
 * overflow's bits; sums, differences, shifts, products of fractions, of 8, 16 and 32 bits. */
#include "report.h"

typedef long long i64;

static const int values[] = {0,
                             1,
                             -1,
                             5,
                             -5,
                             127,
                             -128,
                             255,
                             16384,
                             -16384,
                             32767,
                             -32768,
                             65535,
                             0x3fffffff,
                             0x40000000,
                             0x7fffffff,
                             -0x40000000,
                             -0x7fffffff,
                             -0x7fffffff - 1};
#define COUNT ((int)(sizeof values / sizeof *values))

APART static int add32(int a, int b) {
  i64 sum = (i64)a + b;
  return sum > 0x7fffffff ? 0x7fffffff : sum < -0x7fffffff - 1 ? -0x7fffffff - 1 : (int)sum;
}
APART static int subtract32(int a, int b) {
  unsigned difference = (unsigned)a - (unsigned)b;
  if (((unsigned)(a ^ b) & ((unsigned)a ^ difference)) >> 31)
    return a < 0 ? -0x7fffffff - 1 : 0x7fffffff;
  return (int)difference;
}
APART static short add16(short a, short b) {
  int sum = a + b;
  if (sum > 32767)
    sum = 32767;
  if (sum < -32768)
    sum = -32768;
  return (short)sum;
}
APART static short multiply16(short a, short b) {
  if (a == -32768 && b == -32768)
    return 32767;
  return (short)(a * b >> 15);
}
APART static short rounded16(short a, short b) {
  int product = a * b;
  product = product == 0x40000000 ? 0x7fffffff : product * 2;
  i64 sum = (i64)product + 0x8000;
  return (short)((sum > 0x7fffffff ? 0x7fffffff : (int)sum) >> 16);
}
APART static unsigned char add8(unsigned char a, unsigned char b) {
  unsigned sum = (unsigned)a + b;
  return (unsigned char)(sum | -(sum >> 8));
}
APART static unsigned char subtract8(unsigned char a, unsigned char b) {
  return a > b ? (unsigned char)(a - b) : 0;
}
APART static signed char clip8(int a) { return (signed char)(a < -128 ? -128 : a > 127 ? 127 : a); }
APART static unsigned clip_unsigned(int a, int bits) {
  return a < 0 ? 0 : a >> bits ? (1u << bits) - 1 : (unsigned)a;
}
APART static int shift32(int a, int n) {
  if (n < 0)
    return a >> (-n > 31 ? 31 : -n);
  i64 wide = (i64)a * (1ll << (n > 31 ? 31 : n));
  return wide > 0x7fffffff ? 0x7fffffff : wide < -0x7fffffff - 1 ? -0x7fffffff - 1 : (int)wide;
}
APART static int negate32(int a) { return a == -0x7fffffff - 1 ? 0x7fffffff : -a; }
APART static int absolute32(int a) { return a < 0 ? negate32(a) : a; }
APART static void mix_signals(short* out, const short* a, const short* b, int n) {
  for (int i = 0; i < n; i++)
    out[i] = add16(multiply16(a[i], 23170), multiply16(b[i], 23170));
}

int main(void) {
  unsigned s = 0, t = 0;
  short left[COUNT], right[COUNT], out[COUNT];
  for (int i = 0; i < COUNT; i++) {
    for (int j = 0; j < COUNT; j++) {
      int a = values[i], b = values[j];
      s = mix(s, (unsigned)add32(a, b));
      s = mix(s, (unsigned)subtract32(a, b));
      s = mix(s, (unsigned)add16((short)a, (short)b));
      s = mix(s, (unsigned)multiply16((short)a, (short)b));
      t = mix(t, (unsigned)rounded16((short)a, (short)b));
      t = mix(t, add8((unsigned char)a, (unsigned char)b) * 256u +
                     subtract8((unsigned char)a, (unsigned char)b));
      t = mix(t, (unsigned)shift32(a, (b & 63) - 20));
    }
    t = mix(t, (unsigned)clip8(values[i]) ^ (unsigned)absolute32(values[i]));
    t = mix(t, clip_unsigned(values[i], 8) + clip_unsigned(values[i], 12));
    left[i] = (short)values[i];
    right[i] = (short)values[COUNT - 1 - i];
  }
  mix_signals(out, left, right, COUNT);
  for (int i = 0; i < COUNT; i++)
    t = mix(t, (unsigned)out[i]);
  report("sums", s);
  report("others", t);
  return 0;
}
