/* A lock for what both cores write: held for a few dozen cycles, so that the other core spins
 * rather than sleeps. Nobody waits for anything, and no interrupt comes, while it is held. */
#ifndef FINBACK_LOCK_H
#define FINBACK_LOCK_H

#include <stdint.h>

/* Lies in L2 or L3, in no data cache: TESTSET locks the bus, not a core's own memory. 0: free. */
struct lock {
  volatile uint8_t taken;
};

/* Takes the lock, with interrupts held back; returns the mask that lock_give puts back. */
unsigned lock_take(struct lock* lock);

/* Frees it; what was written under it has arrived by then. */
void lock_give(struct lock* lock, unsigned mask);

#endif
