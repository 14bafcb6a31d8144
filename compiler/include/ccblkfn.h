/* The processor's own instructions by the vendor's names, circular counting, hints for branches and
 * the choices of a Viterbi decoder. */
#ifndef CCBLKFN_H
#define CCBLKFN_H

#include <builtins.h>
#include <stddef.h>

#define csync() __builtin_bfin_csync()
#define ssync() __builtin_bfin_ssync()
#define idle() __builtin_bfin_idle()
#define cli() __builtin_bfin_cli()
#define sti(mask) __builtin_bfin_sti(mask)
#define raise_intr(event) __builtin_bfin_raise(event) /* raise is the C library's */
#define testset(lock) __builtin_bfin_testset((volatile unsigned char*)(lock))
#define untestset(lock) ((void)(*(volatile unsigned char*)(lock) = 0))
#define prefetch(address) __builtin_bfin_prefetch(address)
#define flush(address) __builtin_bfin_flush(address)
#define flushinv(address) __builtin_bfin_flushinv(address)
#define iflush(address) __builtin_bfin_iflush(address)

#define expected_true(condition) __builtin_expect((condition) != 0, 1)
#define expected_false(condition) __builtin_expect((condition) != 0, 0)

/* index + step, kept within 0 and count - 1, and pointer + step, kept within the `bytes` from `base`.
 * What comes in lies within; |step| is at most the count. Circular addressing where it steps through
 * a loop, additions and selections elsewhere. */
#define circindex(index, step, count) __builtin_bfin_circindex((index), (step), (count))
#define circptr(pointer, step, base, bytes) \
  __builtin_bfin_circptr((pointer), (step), (base), (bytes))

/* Steps in bit-reversed order: the carry of pointer + step runs to the right. */
#define brevadd(pointer, step) __builtin_bfin_brevadd((pointer), (step))

/* The larger half of a pair, or of two pairs, with a bit of history for each choice: from the right
 * (l) or from the left (r). Results go to variables, as with the vendor. */
#define lvitmax1x16(pair, old_history, selected, new_history) \
  FINBACK_VITERBI(__builtin_bfin_lvitmax1x16(pair, old_history), selected, new_history)
#define rvitmax1x16(pair, old_history, selected, new_history) \
  FINBACK_VITERBI(__builtin_bfin_rvitmax1x16(pair, old_history), selected, new_history)
#define lvitmax2x16(a, b, old_history, selected, new_history) \
  FINBACK_VITERBI(__builtin_bfin_lvitmax2x16(a, b, old_history), selected, new_history)
#define rvitmax2x16(a, b, old_history, selected, new_history) \
  FINBACK_VITERBI(__builtin_bfin_rvitmax2x16(a, b, old_history), selected, new_history)
#define FINBACK_VITERBI(both, selected, new_history) \
  do {                                               \
    const long long finback_both = (both);           \
    (selected) = (__typeof__(selected))finback_both; \
    (new_history) = (int)(finback_both >> 32);       \
  } while (0)

#endif
