/* Conversions between float, double and integers of all widths, where C defines them. */
#include "float_values.h"
#include "report.h"

static unsigned fold(unsigned long long bits) { return (unsigned)(bits >> 32) * 31 + (unsigned)bits; }

__attribute__((noinline)) static unsigned from_int(int v) {
  return mix(float_bits((float)v), fold(double_bits((double)v)));
}
__attribute__((noinline)) static unsigned from_unsigned(unsigned v) {
  return mix(float_bits((float)v), fold(double_bits((double)v)));
}
__attribute__((noinline)) static unsigned from_long(long long v) {
  return mix(float_bits((float)v), fold(double_bits((double)v)));
}
__attribute__((noinline)) static unsigned from_unsigned_long(unsigned long long v) {
  return mix(float_bits((float)v), fold(double_bits((double)v)));
}
__attribute__((noinline)) static unsigned from_narrow(signed char a, unsigned char b, short c,
                                                      unsigned short d, _Bool e) {
  return mix(float_bits((float)a + (float)b * (float)c), fold(double_bits((double)d + (double)e)));
}

/* Only of values that fit. */
__attribute__((noinline)) static unsigned to_integers(double v) {
  unsigned sum = 0;
  float f = (float)v;
  if (v > -129 && v < 128) sum = mix(sum, (unsigned)(signed char)v);
  if (v > -1 && v < 65536) sum = mix(sum, (unsigned short)v);
  if (v > -2147483649.0 && v < 2147483648.0) sum = mix(sum, (unsigned)(int)v);
  if (f >= -2147483648.0f && f < 2147483648.0f) sum = mix(sum, (unsigned)(int)f);
  if (v > -1 && v < 4294967296.0) sum = mix(sum, (unsigned)v);
  if (f > -1 && f < 4294967296.0f) sum = mix(sum, (unsigned)f);
  if (v >= -9223372036854775808.0 && v < 9223372036854775808.0) sum = mix(sum, fold((long long)v));
  if (f >= -9223372036854775808.0f && f < 9223372036854775808.0f)
    sum = mix(sum, fold((long long)f));
  if (v > -1 && v < 18446744073709551616.0) sum = mix(sum, fold((unsigned long long)v));
  if (f > -1 && f < 18446744073709551616.0f) sum = mix(sum, fold((unsigned long long)f));
  return mix(sum, (_Bool)v + 2 * (_Bool)f);
}

__attribute__((noinline)) static float narrow(double v) { return (float)v; }
__attribute__((noinline)) static double widen(float v) { return v; }

int main(void) {
  unsigned sum = 0;
  for (int power = 0; power < 64; power++)
    for (int step = -2; step <= 2; step++) {
      unsigned long long v = (1ull << power) + (unsigned long long)(long long)step;
      sum = mix(sum, from_int((int)v));
      sum = mix(sum, from_unsigned((unsigned)v));
      sum = mix(sum, from_long((long long)v));
      sum = mix(sum, from_long(-(long long)v));
      sum = mix(sum, from_unsigned_long(v));
      sum = mix(sum, from_unsigned_long(v * 0x1000001));
      sum = mix(sum, from_narrow((signed char)v, (unsigned char)v, (short)v, (unsigned short)v, v));
    }
  report("from", sum);
  for (int i = 0; i < EDGES; i++) {
    double d = double_from_bits(double_edges[i]);
    float f = float_from_bits(float_edges[i]);
    report("narrow", float_bits(narrow(d)));
    report("widen", fold(double_bits(widen(f))));
    report("to", to_integers(d));
    report("to", to_integers(f));
  }
  sum = 0;
  for (double v = 0.25; v < 1e20; v *= 1.7) {
    sum = mix(sum, to_integers(v));
    sum = mix(sum, to_integers(-v));
    sum = mix(sum, float_bits(narrow(v * 1e-40)) ^ float_bits(narrow(v * 1e19)));
  }
  report("to", sum);
  return 0;
}
