/* The functions that finback-cc turns into instructions and that only compute: there is nothing
 * behind the names, and calls with the same arguments are made once. fract_math.h, fr2x16.h,
 * complex_bf.h and others give them the names of the Blackfin's C; those that act on the system are
 * in finback/blackfin.h. Results and instructions: docs/fract.md. */
#ifndef BUILTINS_H
#define BUILTINS_H

#include <finback/blackfin.h>
#include <fract_typedef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define FINBACK_COMPUTES __attribute__((const))

/* Halves. */
fract16 __builtin_bfin_add_fr1x16(fract16 a, fract16 b) FINBACK_COMPUTES;
fract16 __builtin_bfin_sub_fr1x16(fract16 a, fract16 b) FINBACK_COMPUTES;
fract16 __builtin_bfin_mult_fr1x16(fract16 a, fract16 b) FINBACK_COMPUTES;
fract16 __builtin_bfin_multr_fr1x16(fract16 a, fract16 b) FINBACK_COMPUTES;
fract32 __builtin_bfin_mult_fr1x32(fract16 a, fract16 b) FINBACK_COMPUTES;
fract16 __builtin_bfin_abs_fr1x16(fract16 a) FINBACK_COMPUTES;
fract16 __builtin_bfin_negate_fr1x16(fract16 a) FINBACK_COMPUTES;
fract16 __builtin_bfin_min_fr1x16(fract16 a, fract16 b) FINBACK_COMPUTES;
fract16 __builtin_bfin_max_fr1x16(fract16 a, fract16 b) FINBACK_COMPUTES;
short __builtin_bfin_norm_fr1x16(fract16 a) FINBACK_COMPUTES;
short __builtin_bfin_expadj1x16(short a, short exponent) FINBACK_COMPUTES;
fract16 __builtin_bfin_shl_fr1x16(fract16 a, short left) FINBACK_COMPUTES;
fract16 __builtin_bfin_lshl_fr1x16(fract16 a, short left) FINBACK_COMPUTES;

/* Pairs of halves. */
fract2x16 __builtin_bfin_compose_2x16(short high, short low) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_add_fr2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_sub_fr2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_dspaddsubsat(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_dspsubaddsat(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
int __builtin_bfin_add_i2x16(int a, int b) FINBACK_COMPUTES;
int __builtin_bfin_sub_i2x16(int a, int b) FINBACK_COMPUTES;
int __builtin_bfin_add_sub_i2x16(int a, int b) FINBACK_COMPUTES;
int __builtin_bfin_sub_add_i2x16(int a, int b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_mult_fr2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_multr_fr2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
int __builtin_bfin_mult_i2x16(int a, int b) FINBACK_COMPUTES;
int __builtin_bfin_multu_fr2x16(int a, int b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_abs_fr2x16(fract2x16 a) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_negate_fr2x16(fract2x16 a) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_min_fr2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_max_fr2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_shl_fr2x16(fract2x16 a, short left) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_lshl_fr2x16(fract2x16 a, short left) FINBACK_COMPUTES;
fract16 __builtin_bfin_sum_fr2x16(fract2x16 a) FINBACK_COMPUTES;
fract16 __builtin_bfin_diff_hl_fr2x16(fract2x16 a) FINBACK_COMPUTES;
fract16 __builtin_bfin_diff_lh_fr2x16(fract2x16 a) FINBACK_COMPUTES;
short __builtin_bfin_expadj2x16(int a, short exponent) FINBACK_COMPUTES;

/* Two results at once, the first in the low word. both: {a + b, a - b} of the pairs a and b.
 * cross: the pairs {ah + bh, al - bl} and {ah - bh, al + bl}. fr: saturated; half: each sum halved;
 * co: the second result's halves exchanged. */
long long __builtin_bfin_both_i2x16(int a, int b) FINBACK_COMPUTES;
long long __builtin_bfin_both_fr2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
long long __builtin_bfin_both_half_2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
long long __builtin_bfin_both_half_co_2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
long long __builtin_bfin_cross_i2x16(int a, int b) FINBACK_COMPUTES;
long long __builtin_bfin_cross_fr2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
long long __builtin_bfin_cross_half_2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
long long __builtin_bfin_cross_half_co_2x16(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
long long __builtin_bfin_both_fr1x32(fract32 a, fract32 b) FINBACK_COMPUTES;

/* Words. */
fract32 __builtin_bfin_add_fr1x32(fract32 a, fract32 b) FINBACK_COMPUTES;
fract32 __builtin_bfin_sub_fr1x32(fract32 a, fract32 b) FINBACK_COMPUTES;
fract32 __builtin_bfin_min_fr1x32(fract32 a, fract32 b) FINBACK_COMPUTES;
fract32 __builtin_bfin_max_fr1x32(fract32 a, fract32 b) FINBACK_COMPUTES;
fract32 __builtin_bfin_abs_fr1x32(fract32 a) FINBACK_COMPUTES;
fract32 __builtin_bfin_negate_fr1x32(fract32 a) FINBACK_COMPUTES;
short __builtin_bfin_norm_fr1x32(fract32 a) FINBACK_COMPUTES;
short __builtin_bfin_expadj1x32(int a, short exponent) FINBACK_COMPUTES;
fract16 __builtin_bfin_round_fr1x32(fract32 a) FINBACK_COMPUTES;
fract32 __builtin_bfin_shl_fr1x32(fract32 a, short left) FINBACK_COMPUTES;
fract32 __builtin_bfin_lshl_fr1x32(fract32 a, short left) FINBACK_COMPUTES;
fract32 __builtin_bfin_mult_fr1x32x32(fract32 a, fract32 b) FINBACK_COMPUTES;
fract32 __builtin_bfin_multr_fr1x32x32(fract32 a, fract32 b) FINBACK_COMPUTES;
/* Address and step added with the carry running to the right, from bit 31 to bit 0. */
int __builtin_bfin_circindex(int index, int step, unsigned count) FINBACK_COMPUTES;
void* __builtin_bfin_circptr(const void* pointer, int step, const void* base,
                             unsigned bytes) FINBACK_COMPUTES;
void* __builtin_bfin_brevadd(const void* address, const void* step) FINBACK_COMPUTES;

/* Complex fractions: imaginary part in the high half, real part in the low one. */
fract2x16 __builtin_bfin_cmplx_add(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_cmplx_sub(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_cmplx_mul(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_cmplx_mac(fract2x16 sum, fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_cmplx_msu(fract2x16 sum, fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_cmplx_mul_s40(fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_cmplx_mac_s40(fract2x16 sum, fract2x16 a, fract2x16 b) FINBACK_COMPUTES;
fract2x16 __builtin_bfin_cmplx_msu_s40(fract2x16 sum, fract2x16 a, fract2x16 b) FINBACK_COMPUTES;

/* Bytes. */
int __builtin_bfin_align8(int high, int low) FINBACK_COMPUTES;
int __builtin_bfin_align16(int high, int low) FINBACK_COMPUTES;
int __builtin_bfin_align24(int high, int low) FINBACK_COMPUTES;
int __builtin_bfin_bytepack(int low, int high) FINBACK_COMPUTES;

/* Four bytes of a pair of words: video.h. */
long long __builtin_bfin_add_i4x8(long long a, const void* at_a, long long b,
                                  const void* at_b) FINBACK_COMPUTES;
long long __builtin_bfin_add_i4x8_r(long long a, const void* at_a, long long b,
                                    const void* at_b) FINBACK_COMPUTES;
long long __builtin_bfin_sub_i4x8(long long a, const void* at_a, long long b,
                                  const void* at_b) FINBACK_COMPUTES;
long long __builtin_bfin_sub_i4x8_r(long long a, const void* at_a, long long b,
                                    const void* at_b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i4x8(long long a, const void* at_a, long long b,
                            const void* at_b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i4x8_t(long long a, const void* at_a, long long b,
                              const void* at_b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i4x8_r(long long a, const void* at_a, long long b,
                              const void* at_b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i4x8_tr(long long a, const void* at_a, long long b,
                               const void* at_b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i2x8_lo(long long a, const void* at, long long b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i2x8_lot(long long a, const void* at, long long b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i2x8_lor(long long a, const void* at, long long b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i2x8_lotr(long long a, const void* at, long long b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i2x8_hi(long long a, const void* at, long long b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i2x8_hit(long long a, const void* at, long long b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i2x8_hir(long long a, const void* at, long long b) FINBACK_COMPUTES;
int __builtin_bfin_avg_i2x8_hitr(long long a, const void* at, long long b) FINBACK_COMPUTES;
int __builtin_bfin_addclip_lo(long long a, const void* at_a, long long b,
                              const void* at_b) FINBACK_COMPUTES;
int __builtin_bfin_addclip_hi(long long a, const void* at_a, long long b,
                              const void* at_b) FINBACK_COMPUTES;
int __builtin_bfin_addclip_lor(long long a, const void* at_a, long long b,
                               const void* at_b) FINBACK_COMPUTES;
int __builtin_bfin_addclip_hir(long long a, const void* at_a, long long b,
                               const void* at_b) FINBACK_COMPUTES;
long long __builtin_bfin_byteunpack(long long a, const void* at) FINBACK_COMPUTES;
long long __builtin_bfin_byteunpackr(long long a, const void* at) FINBACK_COMPUTES;

/* The choice in the low word, the history of choices in the high one. */
long long __builtin_bfin_lvitmax1x16(int pair, int history) FINBACK_COMPUTES;
long long __builtin_bfin_rvitmax1x16(int pair, int history) FINBACK_COMPUTES;
long long __builtin_bfin_lvitmax2x16(int a, int b, int history) FINBACK_COMPUTES;
long long __builtin_bfin_rvitmax2x16(int a, int b, int history) FINBACK_COMPUTES;

#ifdef __cplusplus
}
#endif

#define FINBACK_INLINE static inline __attribute__((always_inline, unused))

#endif
