#ifndef SHARED_CHECKS_H
#define SHARED_CHECKS_H

#include <lock.h>
#include <stdint.h>

#define CHECKED_BYTES 512

extern uint8_t bytes_in_l2[CHECKED_BYTES];
extern uint8_t bytes_in_l3[CHECKED_BYTES];

/* A ball: core A counts up `thrown`, core B makes `returned` equal to it. */
extern volatile uint32_t thrown;
extern volatile uint32_t returned;

/* Both cores count, and no count is lost. */
#define COUNTED_BY_EACH 300
extern struct lock counted_lock;
extern uint32_t counted;
static inline void count_under_lock(void) {
  unsigned mask = lock_take(&counted_lock);
  ++counted;
  lock_give(&counted_lock, mask);
}

#endif
