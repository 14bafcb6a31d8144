/* ccblkfn.h and math_bf.h: circular and bit-reversed counting, Viterbi's choices, halves put
 * together. */
#include "fract_reference.h"

#ifdef __FINBACK__
#include <ccblkfn.h>
#else
static int circindex(int index, int step, unsigned count) {
  const int n = (int)count;
  return ((index + step) % n + n) % n;
}
static void* circptr(const void* pointer, int step, const void* base, unsigned bytes) {
  return (char*)base + circindex((int)((const char*)pointer - (const char*)base), step, bytes);
}
static unsigned mirrored(unsigned a) {
  unsigned result = 0;
  for (int i = 0; i < 32; ++i)
    result |= (a >> i & 1) << (31 - i);
  return result;
}
#define brevadd(a, b)                                                      \
  ((void*)(unsigned long)mirrored(mirrored((unsigned)(unsigned long)(a)) + \
                                  mirrored((unsigned)(unsigned long)(b))))
static int takes_high(int pair) { return (((pair >> 16) - (short)pair) & 0x8000) == 0; }
static int larger(int pair) { return takes_high(pair) ? pair >> 16 : (short)pair; }
#define lvitmax1x16(pair, old, selected, next) \
  ((selected) = (short)larger(pair), (next) = (int)((unsigned)(old) << 1 | takes_high(pair)))
#define rvitmax1x16(pair, old, selected, next) \
  ((selected) = (short)larger(pair),           \
   (next) = (int)((unsigned)(old) >> 1 | (unsigned)takes_high(pair) << 31))
#define lvitmax2x16(a, b, old, selected, next)                           \
  ((selected) = (int)((unsigned)larger(a) << 16 | (larger(b) & 0xffff)), \
   (next) = (int)((unsigned)(old) << 2 | takes_high(b) << 1 | takes_high(a)))
#define rvitmax2x16(a, b, old, selected, next)                           \
  ((selected) = (int)((unsigned)larger(a) << 16 | (larger(b) & 0xffff)), \
   (next) = (int)((unsigned)(old) >> 2 | (unsigned)takes_high(a) << 31 | \
                  (unsigned)takes_high(b) << 30))
static int countones(int a) { return __builtin_popcount((unsigned)a); }
#endif

/* A ring, and a walk through it in steps of both signs. */
static __attribute__((noinline)) unsigned around(const int* ring, int count, int step) {
  const int* at = ring;
  unsigned sum = 0;
  int index = 0;
  for (int i = 0; i < 50; ++i) {
    sum = mix(sum, (unsigned)(ring[index] - *at));
    sum = mix(sum, (unsigned)index);
    index = (int)circindex(index, step, (unsigned)count);
    at = (const int*)circptr(at, step * (int)sizeof *at, ring, (unsigned)count * sizeof *ring);
  }
  return sum;
}

static __attribute__((noinline)) unsigned in_mirrored_order(unsigned from, unsigned step) {
  unsigned sum = 0;
  void* at = (void*)(unsigned long)from;
  for (int i = 0; i < 40; ++i) {
    sum = mix(sum, (unsigned)(unsigned long)at);
    at = brevadd(at, (void*)(unsigned long)step);
  }
  return sum;
}

/* History goes from choice to choice; a sum of products lives in the accumulator meanwhile. */
static __attribute__((noinline)) unsigned choices(int a, int b, int history) {
  short one;
  int two, next;
  lvitmax1x16(a, history, one, next);
  unsigned sum = mix((unsigned)one, (unsigned)next);
  rvitmax1x16(b, next, one, next);
  sum = mix(sum, mix((unsigned)one, (unsigned)next));
  lvitmax2x16(a, b, history, two, next);
  sum = mix(sum, mix((unsigned)two, (unsigned)next));
  rvitmax2x16(b, a, next, two, next);
  return mix(sum, mix((unsigned)two, (unsigned)next));
}

/* The same by C's own words. */
static __attribute__((noinline)) unsigned together(int a, int b) {
  unsigned sum = (unsigned)a << 16 | (unsigned short)b;
  sum = mix(sum, ((unsigned)a & 0xffff0000u) | (unsigned short)b);
  sum = mix(sum, ((unsigned)a & 0xffff0000u) | (unsigned)b >> 16);
  sum = mix(sum, (unsigned)a << 16 | (unsigned)b >> 16);
  sum = mix(sum, (unsigned)a << 16 | (unsigned)a >> 16);
  return mix(sum, (unsigned)countones(a ^ b));
}

int main(void) {
  int ring[13];
  for (int i = 0; i < 13; ++i)
    ring[i] = i * i;
  for (int step = -13; step <= 13; ++step)
    report("around", around(ring, 13, step));
  report("mirrored", in_mirrored_order(0, 256));
  report("mirrored from", in_mirrored_order(0x12345678, 0x00400000));
  unsigned state = 10, sum = 0;
  for (unsigned i = 0; i < 400; ++i) {
    const int a = edge_or_any(&state, i / 20), b = edge_or_any(&state, i % 20);
    sum = mix(sum, choices(a, b, (int)(sum * 7)));
    sum = mix(sum, together(a, b));
  }
  report("choices", sum);
  return 0;
}
