/* Small numerical programs: roots, series, a linear system, an integral, a picture. */
#include <stdio.h>

static double root(double x) {
  double guess = x > 1 ? x : 1;
  for (int i = 0; i < 40; i++) guess = (guess + x / guess) / 2;
  return guess;
}

static double exponential(double x) {
  double sum = 1, term = 1;
  for (int n = 1; n < 40; n++) {
    term *= x / n;
    sum += term;
  }
  return sum;
}

static float sine(float x) {
  float sum = x, term = x;
  for (int n = 1; n < 10; n++) {
    term *= -x * x / (float)(2 * n * (2 * n + 1));
    sum += term;
  }
  return sum;
}

static void solve(double a[4][5]) {
  for (int i = 0; i < 4; i++) {
    double pivot = a[i][i];
    for (int k = 0; k < 5; k++) a[i][k] /= pivot;
    for (int j = 0; j < 4; j++) {
      double factor = a[j][i];
      if (j == i) continue;
      for (int k = 0; k < 5; k++) a[j][k] -= factor * a[i][k];
    }
  }
}

static int escape(float x, float y) {
  float a = 0, b = 0;
  int n = 0;
  for (; n < 20 && a * a + b * b < 4; n++) {
    float next = a * a - b * b + x;
    b = 2 * a * b + y;
    a = next;
  }
  return n;
}

int main(void) {
  printf("%.17g %.17g %.17g\n", root(2), root(1e-6), root(12345.678));
  printf("%.17g %.17g\n", exponential(1), exponential(-3.5));
  printf("%.9g %.9g\n", sine(1.0f), sine(-2.5f));
  double system[4][5] = {{4, -1, 0.5, 2, 3}, {1, 5, -2, 0.25, -1}, {0.3, 1, 6, -1, 2}, {2, 1, 1, 7, 0.1}};
  solve(system);
  for (int i = 0; i < 4; i++) printf("%.15f\n", system[i][4]);
  double integral = 0;
  for (int i = 0; i < 100; i++) integral += 4 / (1 + (i + 0.5) / 100 * ((i + 0.5) / 100)) / 100;
  printf("%.17g\n", integral);
  for (int y = 0; y < 8; y++) {
    for (int x = 0; x < 24; x++) putchar(" .:-=+*#%@"[escape(x / 8.0f - 2.1f, y / 4.0f - 1) / 2 % 10]);
    putchar('|');
    putchar('\n');
  }
  return 0;
}
