/* Numbers of several words: sums, differences, negations, shifts, products and quotients whose
 * carries go from word to word. */
#include "report.h"

typedef unsigned long long u64;
#define WORDS 5

APART static unsigned add(unsigned* to, const unsigned* a, const unsigned* b) {
  unsigned carry = 0;
  for (int i = 0; i < WORDS; i++) {
    u64 sum = (u64)a[i] + b[i] + carry;
    to[i] = (unsigned)sum;
    carry = (unsigned)(sum >> 32);
  }
  return carry;
}
APART static unsigned add_by_comparing(unsigned* to, const unsigned* a, const unsigned* b) {
  unsigned carry = 0;
  for (int i = 0; i < WORDS; i++) {
    unsigned sum = a[i] + carry;
    carry = sum < carry;
    sum += b[i];
    carry += sum < b[i];
    to[i] = sum;
  }
  return carry;
}
APART static unsigned subtract(unsigned* to, const unsigned* a, const unsigned* b) {
  unsigned borrow = 0;
  for (int i = 0; i < WORDS; i++) {
    unsigned x = a[i], y = b[i] + borrow;
    borrow = y < borrow || x < y;
    to[i] = x - y;
  }
  return borrow;
}
APART static void negate(unsigned* a) {
  unsigned carry = 1;
  for (int i = 0; i < WORDS; i++) {
    a[i] = ~a[i] + carry;
    carry = carry && a[i] == 0;
  }
}
APART static void shift_left(unsigned* a, unsigned n) {
  for (int i = WORDS - 1; i >= 0; i--)
    a[i] = a[i] << n | (i > 0 && n > 0 ? a[i - 1] >> (32 - n) : 0);
}
APART static void multiply(unsigned* a, unsigned by) {
  unsigned carry = 0;
  for (int i = 0; i < WORDS; i++) {
    u64 product = (u64)a[i] * by + carry;
    a[i] = (unsigned)product;
    carry = (unsigned)(product >> 32);
  }
}
APART static unsigned divide(unsigned* a, unsigned by) {
  unsigned rest = 0;
  for (int i = WORDS - 1; i >= 0; i--) {
    u64 part = (u64)rest << 32 | a[i];
    a[i] = (unsigned)(part / by);
    rest = (unsigned)(part % by);
  }
  return rest;
}
APART static void add_bytes(unsigned char* a, const unsigned char* b, int n) {
  unsigned carry = 0;
  for (int i = 0; i < n; i++) {
    carry += (unsigned)a[i] + b[i];
    a[i] = (unsigned char)carry;
    carry >>= 8;
  }
}
APART static u64 three(u64 a, u64 b, unsigned c) { return a + b + c - (a > b) - ((u64)c << 31); }

static unsigned sum_of(const unsigned* a) {
  unsigned s = 0;
  for (int i = 0; i < WORDS; i++)
    s = mix(s, a[i]);
  return s;
}

int main(void) {
  unsigned a[WORDS] = {0xffffffff, 0xffffffff, 0, 0xffffffff, 0x7fffffff},
           b[WORDS] = {1, 0, 0xffffffff, 0, 1}, c[WORDS];
  unsigned s = 0;
  for (int i = 0; i < 12; i++) {
    s = mix(s, add(c, a, b));
    s = mix(s, sum_of(c));
    s = mix(s, add_by_comparing(a, c, a) + sum_of(a));
    s = mix(s, subtract(b, b, c) + sum_of(b));
    negate(b);
    shift_left(c, (unsigned)i * 3 % 32);
    multiply(a, 0x10001u + (unsigned)i);
    s = mix(s, divide(c, 10 + (unsigned)i));
    add_bytes((unsigned char*)b, (const unsigned char*)c, 3 + i);
    s = mix_long(s, three((u64)a[0] << 32 | a[1], (u64)b[0] << 32 | b[1], c[0]));
  }
  report("chains", s);
  report("a", sum_of(a));
  report("b", sum_of(b));
  report("c", sum_of(c));
  return 0;
}
