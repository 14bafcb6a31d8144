#include "lock.h"

#include <finback/blackfin.h>

/* A handler that wanted the lock while its own core holds it would spin for ever. */
unsigned lock_take(struct lock* lock) {
  unsigned mask = __builtin_bfin_cli();
  while (!__builtin_bfin_testset(&lock->taken)) {
  }
  return mask;
}

void lock_give(struct lock* lock, unsigned mask) {
  __builtin_bfin_ssync();
  lock->taken = 0;
  __builtin_bfin_sti(mask);
}
