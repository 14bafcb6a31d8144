/* Floats and doubles as arguments, results, members of structs and unnamed arguments. */
#include <stdarg.h>

#include "float_values.h"
#include "report.h"

struct point {
  float x, y;
};
struct mixed {
  char tag;
  double value;
  float weight;
};

__attribute__((noinline)) static double weigh(float a, double b, int c, float d, double e,
                                              long long f, float g) {
  return a + 2 * b + 3 * c + 4 * d + 5 * e + 6 * (double)f + 7 * g;
}

__attribute__((noinline)) static struct point turned(struct point p, float by) {
  return (struct point){p.x - by * p.y, p.y + by * p.x};
}

__attribute__((noinline)) static struct mixed mixed(struct mixed m, double by) {
  m.value *= by;
  m.weight += m.tag;
  return m;
}

__attribute__((noinline)) static double total(int count, ...) {
  va_list list;
  va_start(list, count);
  double sum = 0;
  for (int i = 0; i < count; i++) {
    double value = va_arg(list, double);
    int scale = va_arg(list, int);
    sum += value * scale;
  }
  va_end(list);
  return sum;
}

static void report_double(const char *name, double value) {
  report(name, (unsigned)(double_bits(value) >> 32));
  report(name, (unsigned)double_bits(value));
}

int main(void) {
  volatile float third = 1.0f / 3;
  volatile double seventh = 1.0 / 7;
  report_double("weigh", weigh(third, seventh, 3, -third, seventh * 5, 1ll << 40, 0.5f));
  struct point p = {third, 2};
  for (int i = 0; i < 5; i++) p = turned(p, 0.25f);
  report("turned", float_bits(p.x));
  report("turned", float_bits(p.y));
  struct mixed m = {'a', seventh, third};
  m = mixed(m, third);
  report_double("mixed", m.value);
  report("mixed", float_bits(m.weight));
  report_double("total", total(4, (double)third, 2, seventh, -3, 1e10, 4, 0.1, 5));
  double (*volatile through)(float, double, int, float, double, long long, float) = weigh;
  report_double("through", through(1, 2, 3, 4, 5, 6, 7));
  return 0;
}
