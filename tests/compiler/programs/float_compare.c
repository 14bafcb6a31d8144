/* Comparisons of float and double as values, in branches, in selections, negated, and with what is no
 * number. */
#include "float_values.h"
#include "report.h"

__attribute__((noinline)) static unsigned compare_floats(float a, float b) {
  unsigned found = 0;
  found |= (unsigned)(a == b) << 0 | (unsigned)(a != b) << 1 | (unsigned)(a < b) << 2;
  found |= (unsigned)(a <= b) << 3 | (unsigned)(a > b) << 4 | (unsigned)(a >= b) << 5;
  found |= (unsigned)!(a < b) << 6 | (unsigned)!(a <= b) << 7 | (unsigned)!(a > b) << 8;
  found |= (unsigned)!(a >= b) << 9 | (unsigned)__builtin_isunordered(a, b) << 10;
  found |= (unsigned)__builtin_islessgreater(a, b) << 11 | (unsigned)__builtin_isless(a, b) << 12;
  return found;
}

__attribute__((noinline)) static unsigned compare_doubles(double a, double b) {
  unsigned found = 0;
  found |= (unsigned)(a == b) << 0 | (unsigned)(a != b) << 1 | (unsigned)(a < b) << 2;
  found |= (unsigned)(a <= b) << 3 | (unsigned)(a > b) << 4 | (unsigned)(a >= b) << 5;
  found |= (unsigned)!(a < b) << 6 | (unsigned)!(a <= b) << 7 | (unsigned)!(a > b) << 8;
  found |= (unsigned)!(a >= b) << 9 | (unsigned)__builtin_isunordered(a, b) << 10;
  found |= (unsigned)__builtin_islessgreater(a, b) << 11 | (unsigned)__builtin_isless(a, b) << 12;
  return found;
}

__attribute__((noinline)) static float larger(float a, float b) { return a > b ? a : b; }
__attribute__((noinline)) static double smaller(double a, double b) { return a < b ? a : b; }

__attribute__((noinline)) static int branches(double a, double b) {
  int found = 0;
  if (a < b) found += 1;
  if (!(a >= b)) found += 10;
  if (a == b || a > 1.0) found += 100;
  while (a < b && found < 100000) {
    a += 1e300;
    found += 1000;
  }
  return found;
}

int main(void) {
  for (int i = 0; i < EDGES; i++) {
    unsigned floats = 0, doubles = 0, chosen = 0;
    for (int j = 0; j < EDGES; j++) {
      float a = float_from_bits(float_edges[i]), b = float_from_bits(float_edges[j]);
      double c = double_from_bits(double_edges[i]), d = double_from_bits(double_edges[j]);
      floats = mix(floats, compare_floats(a, b));
      doubles = mix(doubles, compare_doubles(c, d));
      chosen = mix(chosen, float_bits(larger(a, b)) ^ (unsigned)(double_bits(smaller(c, d)) >> 20));
      chosen = mix(chosen, (unsigned)branches(c, d));
    }
    report("floats", floats);
    report("doubles", doubles);
    report("chosen", chosen);
  }
  return 0;
}
