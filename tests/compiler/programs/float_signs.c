/* What works on a float's bits alone: negation, absolute values, copied signs, classes; loads, stores,
 * constants and selections of floats. */
#include "float_values.h"
#include "report.h"

__attribute__((noinline)) static float negate(float v) { return -v; }
__attribute__((noinline)) static double negate_double(double v) { return -v; }
__attribute__((noinline)) static float absolute(float v) { return __builtin_fabsf(v); }
__attribute__((noinline)) static double absolute_double(double v) { return __builtin_fabs(v); }
__attribute__((noinline)) static float signed_as(float v, double s) {
  return __builtin_copysignf(v, (float)s);
}
__attribute__((noinline)) static double double_signed_as(double v, float s) {
  return __builtin_copysign(v, s);
}

__attribute__((noinline)) static unsigned classes(float f, double d) {
  return (unsigned)!!__builtin_isnan(f) | (unsigned)!!__builtin_isnan(d) << 1 |
         (unsigned)!!__builtin_isinf(f) << 2 | (unsigned)!!__builtin_isinf(d) << 3 |
         (unsigned)!!__builtin_isfinite(f) << 4 | (unsigned)!!__builtin_isfinite(d) << 5 |
         (unsigned)!!__builtin_isnormal(f) << 6 | (unsigned)!!__builtin_isnormal(d) << 7 |
         (unsigned)!!__builtin_signbit(f) << 8 | (unsigned)!!__builtin_signbit(d) << 9;
}

__attribute__((noinline)) static double choose(int which, double a, double b) {
  return which ? a : b;
}

__attribute__((noinline)) static float constant(int which) {
  switch (which) {
    case 0: return 1.5f;
    case 1: return -0.0f;
    case 2: return 3.4028235e38f;
    default: return 1e-45f;
  }
}

int main(void) {
  static double kept[EDGES];
  for (int i = 0; i < EDGES; i++) {
    float f = float_from_bits(float_edges[i]);
    double d = double_from_bits(double_edges[i]);
    kept[EDGES - 1 - i] = choose(i & 1, d, -d);
    report("negate", float_bits(negate(f)));
    report("negate", (unsigned)(double_bits(negate_double(d)) >> 32));
    report("absolute", float_bits(absolute(f)));
    report("absolute", (unsigned)(double_bits(absolute_double(d)) >> 32));
    report("classes", classes(f, d));
    if (f == f && d == d) {
      report("sign", float_bits(signed_as(f, d)));
      report("sign", (unsigned)(double_bits(double_signed_as(d, f)) >> 32));
    }
  }
  for (int i = 0; i < EDGES; i++) report("kept", (unsigned)(double_bits(kept[i]) >> 20));
  for (int i = 0; i < 4; i++) report("constant", float_bits(constant(i)));
  return 0;
}
