/* Operations on four bytes at a time. A pair is two words as one long long, the first bytes in its
 * low word; the low two bits of an address say at which of its bytes the four begin, the next ones
 * in order. What ends with r takes the pair's words the other way round, t truncates where the
 * others round upwards. */
#ifndef VIDEO_H
#define VIDEO_H

#include <builtins.h>

/* Four bytes out of two words: the low one, from its byte 1, 2 or 3 on. */
FINBACK_INLINE int align8(int high, int low) { return __builtin_bfin_align8(high, low); }
FINBACK_INLINE int align16(int high, int low) { return __builtin_bfin_align16(high, low); }
FINBACK_INLINE int align24(int high, int low) { return __builtin_bfin_align24(high, low); }
/* The low bytes of four halves, as one word; and four bytes as halves. */
FINBACK_INLINE int bytepack(int low, int high) { return __builtin_bfin_bytepack(low, high); }
/* The aligned word that an address points into. */
FINBACK_INLINE int loadbytes(const void* address) { return *(const int*)((unsigned)address & ~3u); }
FINBACK_INLINE long long compose_i64(int low, int high) {
  return (long long)high << 32 | (unsigned)low;
}

/* Averages of four and four bytes. */
FINBACK_INLINE int avg_i4x8(long long a, const void* at_a, long long b, const void* at_b) {
  return __builtin_bfin_avg_i4x8(a, at_a, b, at_b);
}
FINBACK_INLINE int avg_i4x8_t(long long a, const void* at_a, long long b, const void* at_b) {
  return __builtin_bfin_avg_i4x8_t(a, at_a, b, at_b);
}
FINBACK_INLINE int avg_i4x8_r(long long a, const void* at_a, long long b, const void* at_b) {
  return __builtin_bfin_avg_i4x8_r(a, at_a, b, at_b);
}
FINBACK_INLINE int avg_i4x8_tr(long long a, const void* at_a, long long b, const void* at_b) {
  return __builtin_bfin_avg_i4x8_tr(a, at_a, b, at_b);
}

/* Averages of two by two bytes, each in the low byte of a half (lo) or in the high one (hi). */
FINBACK_INLINE int avg_i2x8_lo(long long a, const void* at, long long b) {
  return __builtin_bfin_avg_i2x8_lo(a, at, b);
}
FINBACK_INLINE int avg_i2x8_lot(long long a, const void* at, long long b) {
  return __builtin_bfin_avg_i2x8_lot(a, at, b);
}
FINBACK_INLINE int avg_i2x8_lor(long long a, const void* at, long long b) {
  return __builtin_bfin_avg_i2x8_lor(a, at, b);
}
FINBACK_INLINE int avg_i2x8_lotr(long long a, const void* at, long long b) {
  return __builtin_bfin_avg_i2x8_lotr(a, at, b);
}
FINBACK_INLINE int avg_i2x8_hi(long long a, const void* at, long long b) {
  return __builtin_bfin_avg_i2x8_hi(a, at, b);
}
FINBACK_INLINE int avg_i2x8_hit(long long a, const void* at, long long b) {
  return __builtin_bfin_avg_i2x8_hit(a, at, b);
}
FINBACK_INLINE int avg_i2x8_hir(long long a, const void* at, long long b) {
  return __builtin_bfin_avg_i2x8_hir(a, at, b);
}
FINBACK_INLINE int avg_i2x8_hitr(long long a, const void* at, long long b) {
  return __builtin_bfin_avg_i2x8_hitr(a, at, b);
}

/* Two halves of a plus every other byte of b, clipped to bytes. */
FINBACK_INLINE int addclip_lo(long long a, const void* at_a, long long b, const void* at_b) {
  return __builtin_bfin_addclip_lo(a, at_a, b, at_b);
}
FINBACK_INLINE int addclip_hi(long long a, const void* at_a, long long b, const void* at_b) {
  return __builtin_bfin_addclip_hi(a, at_a, b, at_b);
}
FINBACK_INLINE int addclip_lor(long long a, const void* at_a, long long b, const void* at_b) {
  return __builtin_bfin_addclip_lor(a, at_a, b, at_b);
}
FINBACK_INLINE int addclip_hir(long long a, const void* at_a, long long b, const void* at_b) {
  return __builtin_bfin_addclip_hir(a, at_a, b, at_b);
}

/* Four sums, differences, or the bytes themselves, as halves: the upper two go to the variable
 * `upper`, the lower two to `lower`. */
#define add_i4x8(a, at_a, b, at_b, upper, lower) \
  FINBACK_TWO_WORDS(__builtin_bfin_add_i4x8(a, at_a, b, at_b), upper, lower)
#define add_i4x8_r(a, at_a, b, at_b, upper, lower) \
  FINBACK_TWO_WORDS(__builtin_bfin_add_i4x8_r(a, at_a, b, at_b), upper, lower)
#define sub_i4x8(a, at_a, b, at_b, upper, lower) \
  FINBACK_TWO_WORDS(__builtin_bfin_sub_i4x8(a, at_a, b, at_b), upper, lower)
#define sub_i4x8_r(a, at_a, b, at_b, upper, lower) \
  FINBACK_TWO_WORDS(__builtin_bfin_sub_i4x8_r(a, at_a, b, at_b), upper, lower)
#define byteunpack(a, at, upper, lower) \
  FINBACK_TWO_WORDS(__builtin_bfin_byteunpack(a, at), upper, lower)
#define byteunpackr(a, at, upper, lower) \
  FINBACK_TWO_WORDS(__builtin_bfin_byteunpackr(a, at), upper, lower)
#define FINBACK_TWO_WORDS(both, upper, lower) \
  do {                                        \
    const long long finback_both = (both);    \
    (upper) = (int)finback_both;              \
    (lower) = (int)(finback_both >> 32);      \
  } while (0)

#endif
