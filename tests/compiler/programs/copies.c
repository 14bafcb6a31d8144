/* memcpy, memmove and memset at every alignment, for every length up to some words, and large ones. */
#include <string.h>

#include "report.h"

static unsigned char source[4096], target[4096];

static void refill(int seed) {
  for (int i = 0; i < 80; i++) {
    source[i] = (unsigned char)(i * 7 + seed);
    target[i] = (unsigned char)(i * 11 + 100);
  }
}

static unsigned sum_of(const unsigned char *bytes, int count) {
  unsigned sum = 0;
  for (int i = 0; i < count; i++) sum = sum * 31 + bytes[i];
  return sum;
}

int main(void) {
  unsigned wrong = 0;
  for (int to = 0; to < 4; to++)
    for (int from = 0; from < 4; from++) {
      unsigned sum = 0;
      for (int length = 0; length <= 44; length++) {
        refill(length);
        wrong += memcpy(target + to + 8, source + from, (size_t)length) != target + to + 8;
        sum = mix(sum, sum_of(target, 80));
        memset(target + from + 4, length + 250, (size_t)length);
        sum = mix(sum, sum_of(target, 80));
        /* Over itself, both ways, near and far. */
        memmove(source + 8 + to, source + from, (size_t)length);
        sum = mix(sum, sum_of(source, 80));
        memmove(source + from, source + 9 + to, (size_t)length);
        sum = mix(sum, sum_of(source, 80));
        memmove(source + from + 4 * (length & 3), source + to + 4, (size_t)length);
        sum = mix(sum, sum_of(source, 80));
      }
      report("sum", sum);
    }
  for (int i = 0; i < 4096; i++) source[i] = (unsigned char)(i * 13 ^ i >> 8);
  for (int shift = 0; shift < 4; shift++) {
    memcpy(target + 1, source + shift, 4000);
    report("large", sum_of(target, 4096));
    memmove(target + shift, target + 20, 4000);
    memmove(target + 40 + shift, target + 4, 4000);
    report("moved", sum_of(target, 4096));
    memset(target + shift, shift + 1, 1000);
    report("set", sum_of(target, 4096));
  }
  report("wrong", wrong);
  return 0;
}
