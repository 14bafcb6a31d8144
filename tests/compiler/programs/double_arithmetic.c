/* The four operations on double: edge values against each other, and a stream of other ones. */
#include "float_values.h"
#include "report.h"

__attribute__((noinline)) static double add(double a, double b) { return a + b; }
__attribute__((noinline)) static double subtract(double a, double b) { return a - b; }
__attribute__((noinline)) static double multiply(double a, double b) { return a * b; }
__attribute__((noinline)) static double divide(double a, double b) { return a / b; }

static unsigned fold(double value) {
  unsigned long long bits = double_bits(value);
  return (unsigned)(bits >> 32) * 31 + (unsigned)bits;
}

static unsigned long long next_bits(unsigned *state) {
  unsigned long long high = next_number(state);
  return high << 40 ^ (unsigned long long)next_number(state) << 20 ^ next_number(state);
}

int main(void) {
  static double (*const operations[])(double, double) = {add, subtract, multiply, divide};
  static const char *const names[] = {"add", "subtract", "multiply", "divide"};
  for (int op = 0; op < 4; op++) {
    for (int i = 0; i < EDGES; i++) {
      unsigned sum = 0;
      for (int j = 0; j < EDGES; j++)
        sum = mix(sum, fold(operations[op](double_from_bits(double_edges[i]),
                                           double_from_bits(double_edges[j]))));
      report(names[op], sum);
    }
    unsigned state = 5, sum = 0;
    for (int i = 0; i < 300; i++) {
      double a = double_from_bits(next_bits(&state));
      double b = double_from_bits(next_bits(&state));
      double c = double_from_bits((double_bits(b) & 0x800fffffffffffffull) |
                                  (double_bits(a) & 0x7ff0000000000000ull));
      sum = mix(sum, fold(operations[op](a, b)));
      sum = mix(sum, fold(operations[op](a, c)));
    }
    report("stream", sum);
  }
  return 0;
}
