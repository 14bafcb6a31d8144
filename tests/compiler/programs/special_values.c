/* Infinities, what is no number, zeros with signs and subnormal numbers in conditions, loops,
 * selections, minima, sorting, classification by bits and by builtins. */
#include "float_values.h"
#include "report.h"

static const unsigned bits[] = {0x00000000, 0x80000000, 0x00000001, 0x807fffff,
                                0x00800000, 0x3f800000, 0xbf800000, 0x7f7fffff,
                                0x7f800000, 0xff800000, 0x7fc00000};
#define COUNT 11

APART static int branches(float a, float b) {
  int n = 0;
  if (a < b)
    n |= 1;
  if (!(a < b))
    n |= 2;
  if (a <= b)
    n |= 4;
  if (!(a >= b))
    n |= 8;
  if (a == b)
    n |= 16;
  if (a != b)
    n |= 32;
  if (a)
    n |= 64;
  if (!b)
    n |= 128;
  if (a > 0 && b < 0)
    n |= 256;
  if (a < 0 || b != b)
    n |= 512;
  while (a > b && n < 1024)
    n += 1024;
  return n;
}
APART static int of_doubles(double a, double b) {
  return (a < b) | (a > b) << 1 | __builtin_isless(a, b) << 2 |
         __builtin_isgreaterequal(a, b) << 3 | __builtin_isunordered(a, b) << 4 |
         __builtin_islessgreater(a, b) << 5 | (a == -b) << 6;
}
APART static int class_of(float x) {
  return (__builtin_isnan(x) != 0) | (__builtin_isinf(x) != 0) << 1 |
         (__builtin_isfinite(x) != 0) << 2 | (__builtin_isnormal(x) != 0) << 3 |
         (__builtin_signbit(x) != 0) << 4;
}
APART static int class_by_bits(float x) {
  unsigned b = float_bits(x) & 0x7fffffff;
  return b > 0x7f800000 ? 0 : b == 0x7f800000 ? 1 : b >= 0x00800000 ? 2 : b != 0 ? 3 : 4;
}
APART static float smaller(float a, float b) { return a < b ? a : b; }
APART static double larger(double a, double b) { return a > b ? a : b == b ? b : a; }
APART static float clamped(float x) { return x < -1 ? -1 : x > 1 ? 1 : x; }
APART static double signed_as(double x, double sign) { return __builtin_copysign(x, sign); }
APART static int steps_until(float from, float to) {
  int n = 0;
  for (float x = from; x < to && n < 50; x = x * 2 + 1)
    n++;
  return n;
}
APART static void sort(float* p, int n) {
  for (int i = 1; i < n; i++) {
    float kept = p[i];
    int k = i;
    for (; k > 0 && kept < p[k - 1]; k--)
      p[k] = p[k - 1];
    p[k] = kept;
  }
}
APART static int equal_arrays(const double* a, const double* b, int n) {
  for (int i = 0; i < n; i++)
    if (a[i] != b[i])
      return i;
  return -1;
}

int main(void) {
  unsigned s = 0, chosen = 0;
  float values[COUNT];
  for (int i = 0; i < COUNT; i++)
    values[i] = float_from_bits(bits[i]);
  for (int i = 0; i < COUNT; i++) {
    for (int k = 0; k < COUNT; k++) {
      float a = values[i], b = values[k];
      s = mix(s, (unsigned)branches(a, b));
      s = mix(s, (unsigned)of_doubles(a, b));
      chosen = mix(chosen, float_bits(smaller(a, b)));
      chosen = mix_long(chosen, double_bits(larger(a, b)));
      if (a == a)
        chosen = mix_long(chosen, double_bits(signed_as(a, b == b ? b : 1)));
      s = mix(s, (unsigned)steps_until(a, b));
    }
    s = mix(s, (unsigned)(class_of(values[i]) * 8 + class_by_bits(values[i])));
    chosen = mix(chosen, float_bits(clamped(values[i])));
  }
  report("conditions", s);
  report("chosen", chosen);
  sort(values, COUNT - 1);
  for (int i = 0; i < COUNT - 1; i++)
    s = mix(s, values[i] == 0 ? 0 : float_bits(values[i]));
  report("sorted", s);
  double a[3] = {0.0, 1, __builtin_nan("")}, b[3] = {-0.0, 1, a[2]};
  report("equal", (unsigned)(equal_arrays(a, b, 2) * 10 + equal_arrays(a, b, 3)));
  report("made", float_bits(1 / values[0] > 0 ? __builtin_inff() : -__builtin_huge_valf()));
  return 0;
}
