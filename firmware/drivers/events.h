/* Interrupts of the core that calls: from a source through the system interrupt controller to a
 * handler, and waiting for them. */
#ifndef FINBACK_EVENTS_H
#define FINBACK_EVENTS_H

#include <core.h>
#include <finback/blackfin.h>

/* Lets `source` (IRQ_...) interrupt `core`, the calling one, as event `ivg` (7..15), and end IDLE.
 * No other source ends IDLE. The handler makes the source withdraw its request. */
void events_attach(enum core core, int source, int ivg, void (*handler)(void));

/* Unmasks all events attached so far. */
void events_enable(void);

/* Sleeps until `condition` holds. It is tested with interrupts held back, so that what makes it
 * true cannot come between the test and the sleep; a request that comes then ends IDLE all the
 * same, and is served when the mask is back. */
#define WAIT_UNTIL(condition)                  \
  for (;;) {                                   \
    unsigned wait_mask = __builtin_bfin_cli(); \
    int wait_over = (condition);               \
    if (!wait_over) {                          \
      __builtin_bfin_idle();                   \
    }                                          \
    __builtin_bfin_sti(wait_mask);             \
    if (wait_over) {                           \
      break;                                   \
    }                                          \
  }

#endif
