/* Division of 64-bit integers, signed and not, and what the compiler makes of constant divisors. */
#include "report.h"

static unsigned fold(unsigned long long v) { return (unsigned)(v >> 32) * 31 + (unsigned)v; }

__attribute__((noinline)) static unsigned unsigned_both(unsigned long long a, unsigned long long b) {
  return mix(fold(a / b), fold(a % b));
}
__attribute__((noinline)) static unsigned signed_both(long long a, long long b) {
  return mix(fold((unsigned long long)(a / b)), fold((unsigned long long)(a % b)));
}
__attribute__((noinline)) static unsigned constants(unsigned long long a) {
  unsigned sum = fold(a / 10) + fold(a % 10);
  sum = mix(sum, fold(a / 7) + fold(a % 1000000007));
  sum = mix(sum, fold((unsigned long long)((long long)a / -3)));
  return mix(sum, fold((unsigned long long)((long long)a % 65536)));
}

int main(void) {
  static const unsigned long long values[] = {
      1, 2, 3, 7, 10, 255, 65536, 0x7fffffff, 0x80000000, 0xffffffff, 0x100000000, 0x100000001,
      0x123456789abcdef0, 0x7fffffffffffffff, 0x8000000000000000, 0xfffffffffffffffe,
      0xffffffffffffffff};
  const int count = sizeof values / sizeof *values;
  for (int i = 0; i < count; i++) {
    unsigned sum = constants(values[i]);
    for (int j = 0; j < count; j++) {
      sum = mix(sum, unsigned_both(values[i], values[j]));
      if (values[i] != 0x8000000000000000 || values[j] != 0xffffffffffffffff)
        sum = mix(sum, signed_both((long long)values[i], (long long)values[j]));
    }
    report("values", sum);
  }
  unsigned state = 3, sum = 0;
  for (int i = 0; i < 300; i++) {
    unsigned long long a = (unsigned long long)next_number(&state) << 40 ^ next_number(&state);
    unsigned long long b = a * next_number(&state) >> (i & 63) | 1;
    sum = mix(sum, unsigned_both(a * 0x10001, b));
    sum = mix(sum, signed_both((long long)(a * 3), (long long)b));
    sum = mix(sum, constants(a));
  }
  report("stream", sum);
  return 0;
}
