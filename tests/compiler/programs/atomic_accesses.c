/* Atomic loads and stores of every width and order, by _Atomic, by stdatomic.h and by builtins:
 * values, signs, pointers, floats, flags that hand data over, fences. */
#include <stdatomic.h>

#include "report.h"

static _Atomic signed char small = -5;
static _Atomic unsigned short half = 65000;
static _Atomic int word = -100000;
static _Atomic _Bool flag;
static _Atomic float real = 1.5f;
static int plain, data[4];
static int* _Atomic pointer = data;
static _Atomic(unsigned) array[4];
enum kind { low = -1, high = 7 };
static _Atomic enum kind kind = high;

APART static int loads(void) {
  return small * 2 + half * 3 + word + flag + (int)(real * 4) + *pointer + kind;
}
APART static void stores(int x) {
  small = (signed char)x;
  half = (unsigned short)(x * 3);
  word = x * 1000;
  flag = x;
  real = (float)x / 4;
  pointer = &data[x & 3];
  kind = x & 1 ? low : high;
}
APART static void hand_over(int x) {
  data[0] = x;
  data[1] = x * 2;
  atomic_store_explicit(&flag, 1, memory_order_release);
}
APART static int taken(void) {
  if (!atomic_load_explicit(&flag, memory_order_acquire))
    return -1;
  int sum = data[0] * 10 + data[1];
  atomic_store_explicit(&flag, 0, memory_order_relaxed);
  return sum;
}
APART static unsigned orders(int n) {
  unsigned s = 0;
  for (int i = 0; i < n; i++) {
    atomic_store_explicit(&array[i & 3], (unsigned)i * 7, memory_order_relaxed);
    atomic_thread_fence(memory_order_seq_cst);
    s = mix(s, atomic_load_explicit(&array[(i + 1) & 3], memory_order_relaxed));
    atomic_signal_fence(memory_order_acq_rel);
    atomic_store(&array[(i + 2) & 3], s);
    s += atomic_load(&array[(i + 2) & 3]) == s;
  }
  return s;
}
APART static int builtins(int* p, short* q) {
  __atomic_store_n(p, 5, __ATOMIC_SEQ_CST);
  *p += 1;
  int seen = __atomic_load_n(p, __ATOMIC_RELAXED);
  __atomic_store_n(q, (short)-seen, __ATOMIC_RELEASE);
  short out;
  __atomic_load(q, &out, __ATOMIC_ACQUIRE);
  __sync_synchronize();
  return seen * 100 + out;
}

int main(void) {
  unsigned s = 0;
  report("loads", (unsigned)loads());
  for (int i = -3; i < 300; i += 50) {
    data[i & 3] = i;
    stores(i);
    s = mix(s, (unsigned)loads());
  }
  report("stores", s);
  flag = 0;
  int before = taken();
  hand_over(7);
  report("handed", (unsigned)(before * 1000 + taken() + taken()));
  report("orders", orders(20));
  short narrow;
  report("builtins", (unsigned)(builtins(&plain, &narrow) + narrow + plain));
  atomic_init(&word, 3);
  report("free", atomic_is_lock_free(&word) + (unsigned)word);
  return 0;
}
