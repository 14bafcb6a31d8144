/* Products of which only low bits are wanted, by factors that do not fit halves: bytes and halves
 * of them, shifted, summed and masked; and some whose upper bits are wanted after all. */
#include <stdint.h>

#include "report.h"

__attribute__((noinline)) static uint8_t byte_of(int a, int b) { return (uint8_t)((a * b) >> 8); }
__attribute__((noinline)) static uint16_t half_of(unsigned a, unsigned b) {
  return (uint16_t)(a * b + 77);
}
__attribute__((noinline)) static int16_t signed_half(int a, int b, int c) {
  return (int16_t)(a * b - c * (a + b));
}
__attribute__((noinline)) static unsigned bit_nine(unsigned a, unsigned b) {
  return (a * b) >> 9 & 0x7f;
}
__attribute__((noinline)) static unsigned bit_seventeen(unsigned a, unsigned b) {
  return (a * b) >> 9 & 0xff;
}
__attribute__((noinline)) static int both(int a, int b, uint8_t* low) {
  const int product = a * b;
  *low = (uint8_t)product;
  return product > 1000;
}
__attribute__((noinline)) static uint8_t mixed(const uint8_t* p, int across, int down) {
  int upper = p[0] + (((p[1] - p[0]) * across + 128) >> 8);
  int lower = p[2] + (((p[3] - p[2]) * across + 128) >> 8);
  return (uint8_t)(upper + (((lower - upper) * down + 128) >> 8));
}
__attribute__((noinline)) static unsigned power(unsigned base, unsigned n) {
  uint16_t result = 1;
  while (n-- != 0)
    result = (uint16_t)(result * base + n);
  return result;
}

int main(void) {
  static const int values[] = {0,
                               1,
                               -1,
                               255,
                               256,
                               -256,
                               32767,
                               -32768,
                               32768,
                               65535,
                               65536,
                               -65536,
                               0x12345,
                               -0x54321,
                               1 << 20,
                               46340,
                               -46340,
                               0x7fff0,
                               2147483647 / 65536};
  const int count = (int)(sizeof values / sizeof *values);
  unsigned sum = 0;
  for (int i = 0; i < count; i++) {
    for (int j = 0; j < count; j++) {
      /* Small enough for C's products. */
      const int a = values[i] % 30000;
      const int b = values[j];
      const unsigned x = (unsigned)values[i];
      const unsigned y = (unsigned)values[j];
      uint8_t low = 0;
      if ((long long)a * b < 2147483647LL && (long long)a * b > -2147483647LL) {
        sum = mix(sum, byte_of(a, b));
        sum = mix(sum, (unsigned)both(a, b, &low) + low);
      }
      sum = mix(sum, half_of(x, y));
      sum = mix(sum, (unsigned)(int)signed_half(a, (int16_t)b, (int16_t)(i * 1000)));
      sum = mix(sum, bit_nine(x, y) + bit_seventeen(x, y));
    }
    report("products", sum);
  }
  for (int i = 0; i < 40; i++) {
    const uint8_t p[4] = {(uint8_t)(i * 77), (uint8_t)(i * 31), (uint8_t)(255 - i),
                          (uint8_t)(i * i)};
    sum = mix(sum, mixed(p, i * 6, 255 - i * 5));
    sum = mix(sum, power((unsigned)i * 70001U, (unsigned)i % 9));
  }
  report("mixed", sum);
  return 0;
}
