/* The four operations on float: edge values against each other, and a stream of other ones. */
#include "float_values.h"
#include "report.h"

__attribute__((noinline)) static float add(float a, float b) { return a + b; }
__attribute__((noinline)) static float subtract(float a, float b) { return a - b; }
__attribute__((noinline)) static float multiply(float a, float b) { return a * b; }
__attribute__((noinline)) static float divide(float a, float b) { return a / b; }

int main(void) {
  static float (*const operations[])(float, float) = {add, subtract, multiply, divide};
  static const char *const names[] = {"add", "subtract", "multiply", "divide"};
  for (int op = 0; op < 4; op++) {
    for (int i = 0; i < EDGES; i++) {
      unsigned sum = 0;
      for (int j = 0; j < EDGES; j++)
        sum = mix(sum, float_bits(operations[op](float_from_bits(float_edges[i]),
                                                 float_from_bits(float_edges[j]))));
      report(names[op], sum);
    }
    unsigned state = 5, sum = 0;
    for (int i = 0; i < 300; i++) {
      float a = float_from_bits(next_number(&state) << 8 ^ next_number(&state));
      float b = float_from_bits(next_number(&state) << 8 ^ next_number(&state));
      float c = float_from_bits((float_bits(b) & 0x807fffff) | (float_bits(a) & 0x7f800000));
      sum = mix(sum, float_bits(operations[op](a, b)));
      sum = mix(sum, float_bits(operations[op](a, c)));
    }
    report("stream", sum);
  }
  return 0;
}
