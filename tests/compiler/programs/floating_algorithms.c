/* Algorithms whose every bit must be right: sums with compensation, exact products by halves,
 * roots, polynomials, remainders, rounding to integers in five ways, decimal digits, vectors and
 * rotations. */
#include <stdio.h>

#include "float_values.h"

static double compensated(const float* p, int n) {
  double sum = 0, lost = 0;
  for (int i = 0; i < n; i++) {
    double y = p[i] - lost, t = sum + y;
    lost = (t - sum) - y;
    sum = t;
  }
  return sum;
}
static double product_error(double a, double b) {
  double p = a * b, c = 134217729.0 * a, ah = c - (c - a), al = a - ah;
  c = 134217729.0 * b;
  double bh = c - (c - b), bl = b - bh;
  return ((ah * bh - p) + ah * bl + al * bh) + al * bl;
}
static double root(double x) {
  double guess = double_from_bits((double_bits(x) >> 1) + (0x3ff0000000000000ull >> 1));
  for (int i = 0; i < 5; i++)
    guess = 0.5 * (guess + x / guess);
  return guess;
}
static float inverse_root(float x) {
  float y = float_from_bits(0x5f3759df - (float_bits(x) >> 1));
  for (int i = 0; i < 3; i++)
    y *= 1.5f - 0.5f * x * y * y;
  return y;
}
static double truncated(double x) {
  unsigned long long bits = double_bits(x);
  int exponent = (int)(bits >> 52 & 0x7ff) - 1023;
  if (exponent < 0)
    return double_from_bits(bits & 1ull << 63);
  return exponent >= 52 ? x : double_from_bits(bits & ~(0xfffffffffffffull >> exponent));
}
static double floored(double x) {
  double t = truncated(x);
  return t > x ? t - 1 : t;
}
static double nearest(double x) {
  double magic = 6755399441055744.0;
  return x + magic - magic;
}
static double remainder_of(double x, double y) { return x - y * floored(x / y); }
static double exponential(double x) {
  int n = (int)nearest(x * 1.4426950408889634);
  double r = x - n * 0.6931471803691238 - n * 1.9082149292705877e-10, sum = 1;
  for (int i = 14; i > 0; i--)
    sum = 1 + sum * r / i;
  return sum * double_from_bits((unsigned long long)(1023 + n) << 52);
}
static double logarithm(double x) {
  double y = (int)(double_bits(x) >> 52) - 1023;
  for (int i = 0; i < 6; i++)
    y += 2 * (x - exponential(y)) / (x + exponential(y));
  return y;
}
struct vector {
  float x, y, z;
};
static struct vector cross(struct vector a, struct vector b) {
  return (struct vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static struct vector turned(struct vector v, float c, float s) {
  return (struct vector){v.x * c - v.y * s, v.x * s + v.y * c, v.z};
}
static float next_after(float x) {
  unsigned b = float_bits(x);
  return float_from_bits(x < 0 ? b - 1 : b + 1);
}
static int decimal(double x, char* digits) {
  int exponent = 0;
  while (x >= 10)
    x /= 10, exponent++;
  while (x < 1)
    x *= 10, exponent--;
  for (int i = 0; i < 8; i++) {
    digits[i] = (char)('0' + (int)x);
    x = (x - (int)x) * 10;
  }
  digits[8] = 0;
  return exponent;
}

int main(void) {
  float values[100];
  for (int i = 0; i < 100; i++)
    values[i] = 1.0f / (float)(i + 1) * (i & 1 ? -1e3f : 1e-3f);
  printf("%.17g %.17g\n", compensated(values, 100), product_error(0.1, 1e15 / 3));
  printf("%.17g %.17g %.9g %.9g\n", root(2), root(1e-100), inverse_root(2), inverse_root(1e-20f));
  static const double numbers[] = {0.5,        -0.5,      2.5,        -2.5,
                                   1e15 + 0.5, -7.999999, 123456.789, 4503599627370497.0};
  for (int i = 0; i < 8; i++)
    printf("%.17g %.17g %.17g %d %.17g\n", truncated(numbers[i]), floored(numbers[i]),
           nearest(numbers[i]), (int)(long long)numbers[i], remainder_of(numbers[i], 0.7));
  printf("%.15g %.15g %.15g\n", exponential(1), exponential(-20.5), exponential(100));
  printf("%.15g %.15g\n", logarithm(10), logarithm(1e-5));
  struct vector v = cross((struct vector){1, 2, 3}, (struct vector){-2, 0.5f, 4});
  for (int i = 0; i < 20; i++)
    v = turned(v, 0.8f, 0.6f);
  printf("%.9g %.9g %.9g\n", v.x, v.y, v.z);
  printf("%.9g %.9g %.9g\n", next_after(1), next_after(0), next_after(-1));
  char digits[9];
  int exponent = decimal(6.02214076e23, digits);
  printf("%s %d", digits, exponent);
  exponent = decimal(1.25e-7, digits);
  printf(" %s %d\n", digits, exponent);
  return 0;
}
