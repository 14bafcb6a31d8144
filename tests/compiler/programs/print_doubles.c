/* printf of doubles: exact in every digit. */
#include <stdio.h>

#include "float_values.h"

int main(void) {
  static const double values[] = {0, 1, -1, 0.1, 0.5, 1.5, 2.5, 1e-5, 123456.789, 1e15, 1e16, 1e22, 9.9999995, 5e-324};
  for (unsigned i = 0; i < sizeof values / sizeof *values; i++) {
    double v = values[i];
    printf("%f %e %g %G\n", v, v, v, v);
    printf("[%.0f][%.1f][%.3e][%.17g][%#.3g][%#.0f]\n", v, v, v, v, v, v);
    printf("[%12.4f][%-12.4f][%012.4f][%+.2f][% .2e][%25.10g]\n", v, v, v, v, v, v);
  }
  for (int i = 0; i < EDGES; i++) {
    double d = double_from_bits(double_edges[i]);
    float f = float_from_bits(float_edges[i]);
    if (d == d) printf("%.17g %.20e\n", d, d);
    if (f == f) printf("%.9g %.5f\n", f, f);
  }
  printf("%.60f\n%F %E\n", 0.1, 1 / 3.0, 2e100 / 3);
  return 0;
}
