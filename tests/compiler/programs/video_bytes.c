/* Operations on four bytes, from every place in a pair of words. */
#include "fract_reference.h"

struct pair {
  long long words;
  const char* at;
};
static const char places[4] __attribute__((aligned(4)));
static struct pair next_pair(unsigned* state, unsigned i) {
  struct pair pair;
  const unsigned low = (unsigned)edge_or_any(state, i % 31);
  pair.words = (long long)edge_or_any(state, i % 29) << 32 | low;
  pair.at = places + (i & 3);
  return pair;
}

#define FOUR(name)                                                                      \
  static __attribute__((noinline)) unsigned four_##name(struct pair a, struct pair b) { \
    return (unsigned)name(a.words, a.at, b.words, b.at);                                \
  }
#define THREE(name)                                                                     \
  static __attribute__((noinline)) unsigned four_##name(struct pair a, struct pair b) { \
    return (unsigned)name(a.words, a.at, b.words);                                      \
  }
#define INTO_TWO(name)                                                                  \
  static __attribute__((noinline)) unsigned four_##name(struct pair a, struct pair b) { \
    int upper, lower;                                                                   \
    name(a.words, a.at, b.words, b.at, upper, lower);                                   \
    return mix((unsigned)upper, (unsigned)lower);                                       \
  }
FOUR(avg_i4x8)
FOUR(avg_i4x8_t)
FOUR(avg_i4x8_r)
FOUR(avg_i4x8_tr)
FOUR(addclip_lo)
FOUR(addclip_hi)
FOUR(addclip_lor)
FOUR(addclip_hir)
THREE(avg_i2x8_lo)
THREE(avg_i2x8_lot)
THREE(avg_i2x8_lor)
THREE(avg_i2x8_lotr)
THREE(avg_i2x8_hi)
THREE(avg_i2x8_hit)
THREE(avg_i2x8_hir)
THREE(avg_i2x8_hitr)
INTO_TWO(add_i4x8)
INTO_TWO(add_i4x8_r)
INTO_TWO(sub_i4x8)
INTO_TWO(sub_i4x8_r)

static __attribute__((noinline)) unsigned others(struct pair a) {
  int upper, lower;
  const int low = (int)a.words, high = (int)(a.words >> 32);
  byteunpack(a.words, a.at, upper, lower);
  unsigned sum = mix((unsigned)upper, (unsigned)lower);
  byteunpackr(a.words, a.at, upper, lower);
  sum = mix(sum, mix((unsigned)upper, (unsigned)lower));
  sum = mix(sum, (unsigned)align8(high, low));
  sum = mix(sum, (unsigned)align16(high, low));
  sum = mix(sum, (unsigned)align24(high, low));
  return mix(sum, (unsigned)bytepack(low, high));
}

/* Rows of pixels that begin anywhere: an average of both, four at a time. */
static __attribute__((noinline)) unsigned averaged(const int* a, const char* at_a, const int* b,
                                                   const char* at_b, int n) {
  unsigned sum = 0;
  for (int i = 0; i < n; ++i) {
    const long long left = (long long)a[i + 1] << 32 | (unsigned)a[i];
    const long long right = (long long)b[i + 1] << 32 | (unsigned)b[i];
    sum += (unsigned)avg_i4x8(left, at_a, right, at_b) * (unsigned)(i + 1);
  }
  return sum;
}

#define RUN(name)                                               \
  do {                                                          \
    unsigned state = 8, sum = 0;                                \
    for (unsigned i = 0; i < 50; ++i) {                         \
      const struct pair a = next_pair(&state, i);               \
      sum = mix(sum, four_##name(a, next_pair(&state, i / 3))); \
    }                                                           \
    report(#name, sum);                                         \
  } while (0);

int main(void) {
  RUN(avg_i4x8)
  RUN(avg_i4x8_t)
  RUN(avg_i4x8_r)
  RUN(avg_i4x8_tr)
  RUN(addclip_lo)
  RUN(addclip_hi)
  RUN(addclip_lor)
  RUN(addclip_hir)
  RUN(avg_i2x8_lo)
  RUN(avg_i2x8_lot)
  RUN(avg_i2x8_lor)
  RUN(avg_i2x8_lotr)
  RUN(avg_i2x8_hi)
  RUN(avg_i2x8_hit)
  RUN(avg_i2x8_hir)
  RUN(avg_i2x8_hitr)
  RUN(add_i4x8)
  RUN(add_i4x8_r)
  RUN(sub_i4x8)
  RUN(sub_i4x8_r)
  unsigned state = 9, sum = 0;
  for (unsigned i = 0; i < 50; ++i)
    sum = mix(sum, others(next_pair(&state, i)));
  report("others", sum);
  int a[20], b[20];
  for (int i = 0; i < 20; ++i) {
    a[i] = edge_or_any(&state, 99);
    b[i] = edge_or_any(&state, 99);
  }
  for (int i = 0; i < 4; ++i)
    sum = mix(sum, averaged(a, places + i, b, places + 3 - i, 19));
  report("averaged", sum);
  return 0;
}
