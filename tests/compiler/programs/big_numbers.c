/* Integers without end: factorials and powers in base 10^9, long division, a square root by digits,
 * modular powers, a test of primes. */
#include <stdio.h>
#include <string.h>

#include "report.h"

#define DIGITS 24
#define BASE 1000000000u
struct big {
  int size;
  unsigned d[DIGITS];
};
typedef unsigned long long u64;

static void set(struct big* b, unsigned value) {
  memset(b, 0, sizeof *b);
  b->d[0] = value;
  b->size = 1;
}
APART static void multiply_small(struct big* b, unsigned by) {
  u64 carry = 0;
  for (int i = 0; i < b->size; i++) {
    carry += (u64)b->d[i] * by;
    b->d[i] = (unsigned)(carry % BASE);
    carry /= BASE;
  }
  if (carry != 0)
    b->d[b->size++] = (unsigned)carry;
}
APART static struct big multiply(const struct big* a, const struct big* b) {
  struct big r;
  set(&r, 0);
  for (int i = 0; i < a->size; i++) {
    u64 carry = 0;
    for (int k = 0; k < b->size || carry != 0; k++) {
      u64 t = r.d[i + k] + carry + (k < b->size ? (u64)a->d[i] * b->d[k] : 0);
      r.d[i + k] = (unsigned)(t % BASE);
      carry = t / BASE;
    }
  }
  r.size = a->size + b->size;
  while (r.size > 1 && r.d[r.size - 1] == 0)
    r.size--;
  return r;
}
APART static unsigned divide_small(struct big* b, unsigned by) {
  u64 rest = 0;
  for (int i = b->size - 1; i >= 0; i--) {
    rest = rest * BASE + b->d[i];
    b->d[i] = (unsigned)(rest / by);
    rest %= by;
  }
  while (b->size > 1 && b->d[b->size - 1] == 0)
    b->size--;
  return (unsigned)rest;
}
static void add(struct big* a, const struct big* b) {
  unsigned carry = 0;
  if (b->size > a->size)
    a->size = b->size;
  for (int i = 0; i < a->size; i++) {
    unsigned t = a->d[i] + b->d[i] + carry;
    carry = t >= BASE;
    a->d[i] = carry ? t - BASE : t;
  }
  if (carry)
    a->d[a->size++] = 1;
}
static void print(const char* name, const struct big* b) {
  printf("%s %u", name, b->d[b->size - 1]);
  for (int i = b->size - 2; i >= 0; i--)
    printf("%09u", b->d[i]);
  putchar('\n');
}
static unsigned power_modulo(unsigned base, unsigned exponent, unsigned modulus) {
  u64 result = 1, b = base % modulus;
  for (; exponent != 0; exponent >>= 1) {
    if (exponent & 1)
      result = result * b % modulus;
    b = b * b % modulus;
  }
  return (unsigned)result;
}
static int is_prime(unsigned n) {
  static const unsigned bases[] = {2, 3, 5, 7};
  unsigned d = n - 1, s = 0;
  for (; d % 2 == 0; d /= 2)
    s++;
  for (int i = 0; i < 4; i++) {
    u64 x = power_modulo(bases[i], d, n);
    unsigned k = 0;
    if (n == bases[i])
      return 1;
    if (x == 1 || x == n - 1)
      continue;
    while (++k < s && x != n - 1)
      x = x * x % n;
    if (x != n - 1)
      return 0;
  }
  return 1;
}
static unsigned root(u64 x) {
  u64 r = 0;
  for (int bit = 31; bit >= 0; bit--) {
    u64 t = r | 1ull << bit;
    if (t * t <= x)
      r = t;
  }
  return (unsigned)r;
}

int main(void) {
  struct big f, p, a, b;
  set(&f, 1);
  for (unsigned i = 2; i <= 50; i++)
    multiply_small(&f, i);
  print("50!", &f);
  set(&p, 7);
  for (int i = 0; i < 6; i++)
    p = multiply(&p, &p);
  print("7^64", &p);
  printf("rest %u\n", divide_small(&f, 1000003));
  printf("rest %u\n", divide_small(&f, 999999999));
  printf("rest %u\n", divide_small(&p, 4294967291u));
  print("rest", &f);
  set(&a, 0);
  set(&b, 1);
  for (int i = 0; i < 300; i++) {
    struct big t = b;
    add(&b, &a);
    a = t;
  }
  print("fibonacci", &a);
  printf("powers %u %u\n", power_modulo(3, 1000000, 1000000007),
         power_modulo(123456789, 987654321, 4294967291u));
  for (unsigned n = 4294967200u; n > 4294967100u; n--)
    if (is_prime(n))
      report("prime", n);
  printf("\nroots %u %u %u\n", root(~0ull), root(1ull << 62), root(999999999999ull));
  return 0;
}
