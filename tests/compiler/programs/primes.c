/* A sieve, greatest common divisors, modular powers. */
#include "report.h"
static unsigned char composite[2000];
__attribute__((noinline)) static unsigned sieve(unsigned n) {
  unsigned count = 0, sum = 0;
  for (unsigned i = 2; i < n; i++) {
    if (composite[i]) continue;
    count++;
    sum = mix(sum, i);
    for (unsigned j = i * i; j < n; j += i) composite[j] = 1;
  }
  return mix(sum, count);
}
__attribute__((noinline)) static unsigned gcd(unsigned a, unsigned b) { return b ? gcd(b, a % b) : a; }
__attribute__((noinline)) static unsigned power(unsigned base, unsigned exponent, unsigned modulus) {
  unsigned r = 1, b = base % modulus;
  for (; exponent; exponent >>= 1) {
    if (exponent & 1) r = r * b % modulus;
    b = b * b % modulus;
  }
  return r;
}
int main(void) {
  report("sieve", sieve(2000));
  report("gcd", gcd(3 * 5 * 7 * 64, 7 * 11 * 32));
  report("power", power(3, 1000, 40961));
  return 0;
}
