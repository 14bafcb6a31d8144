/* Counts together with core A, then returns the ball after delays that differ, so that the
 * interrupt comes before, at and after the moment when core A goes to sleep. */
#include <core_interrupt.h>
#include <events.h>

#include "shared_checks.h"

int main(void) {
  core_interrupt_start(CORE_B);
  events_enable();
  for (int i = 0; i < COUNTED_BY_EACH; ++i) {
    count_under_lock();
  }
  for (;;) {
    WAIT_UNTIL(thrown != returned);
    for (unsigned delay = thrown * 7 % 64; delay != 0; --delay) {
      __builtin_bfin_nop();
    }
    returned = thrown;
    core_interrupt_raise(CORE_A);
  }
}
