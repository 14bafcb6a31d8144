/* What operations of the runtime cost on the simulated machine: a line of docs/runtime.md's table each,
 * with the best of three runs, all in L1. The cycles of loading operands and storing results count. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static inline unsigned cycles(void) {
  unsigned now;
  __asm__ volatile("%0 = CYCLES;" : "=d"(now));
  return now;
}

#define COST(name, operation)                 \
  do {                                        \
    unsigned best = ~0u;                      \
    for (int run = 0; run < 3; run++) {       \
      unsigned start = cycles();              \
      operation;                              \
      unsigned taken = cycles() - start;      \
      if (taken < best) best = taken;         \
    }                                         \
    printf("| %s | %u |\n", name, best);      \
  } while (0)

static volatile float f = 3.14159f, g = 2.71828f, float_result;
static volatile double d = 3.14159, e = 2.71828, double_result;
static volatile unsigned u = 123456789, v = 1234, unsigned_result;
static volatile int i = -5555, int_result;
static volatile unsigned long long l = 0x123456789abcdef, m = 1000, long_result;
static _Alignas(4) char from[4096], to[4096];

static void costs_of_arithmetic(void) {
  COST("`float` `+`", float_result = f + g);
  COST("`float` `-`", float_result = f - g);
  COST("`float` `*`", float_result = f * g);
  COST("`float` `/`", float_result = f / g);
  COST("`float` `<`", int_result = f < g);
  COST("`int` to `float`", float_result = (float)i);
  COST("`float` to `int`", int_result = (int)f);
  COST("`double` `+`", double_result = d + e);
  COST("`double` `-`", double_result = d - e);
  COST("`double` `*`", double_result = d * e);
  COST("`double` `/`", double_result = d / e);
  COST("`double` `<`", int_result = d < e);
  COST("`int` to `double`", double_result = i);
  COST("`double` to `int`", int_result = (int)d);
  COST("`float` to `double`", double_result = f);
  COST("`double` to `float`", float_result = (float)d);
  COST("`unsigned` `/`, 123456789 by 1234", unsigned_result = u / v);
  COST("`unsigned long long` `/`, 19 digits by 1000", long_result = l / m);
}

static void costs_of_the_library(void) {
  COST("`memcpy`, 4096 bytes", memcpy(to, from, 4096));
  COST("`memcpy`, 4095 bytes from between words", memcpy(to, from + 1, 4095));
  COST("`memmove`, 4000 bytes up by 4", memmove(to + 4, to, 4000));
  COST("`memset`, 4096 bytes", memset(to, 1, 4096));
  memset(from, 'a', 4095);
  memset(to, 'a', 4095);
  from[4095] = to[4095] = 0;
  COST("`strlen`, 4095 characters", unsigned_result = strlen(from));
  COST("`strcmp`, 4095 equal characters", int_result = strcmp(to, from));
  COST("`memchr`, 4095 characters", int_result = memchr(from, 'x', 4095) == NULL);
  char text[40];
  COST("`snprintf`, `%d` of -5555", snprintf(text, sizeof text, "%d", i));
  COST("`snprintf`, `%f` of 3.14159", snprintf(text, sizeof text, "%f", d));
  COST("`malloc` and `free`, nothing else there", free(malloc(100)));
}

int main(void) {
  costs_of_arithmetic();
  costs_of_the_library();
  return 0;
}
