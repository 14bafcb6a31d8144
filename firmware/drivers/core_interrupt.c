#include "core_interrupt.h"

#include <bf561.h>

#include "events.h"

static enum core own_core;

FINBACK_INTERRUPT static void other_core_called(void) {
  SICB_SYSCR = SUPPLEMENTAL_0_ACKNOWLEDGE(own_core);
  __builtin_bfin_ssync();
}

void core_interrupt_start(enum core core) {
  own_core = core;
  events_attach(core, IRQ_SUPPLEMENTAL_0, EVT_IVG7, other_core_called);
}

void core_interrupt_raise(enum core other) {
  __builtin_bfin_ssync();
  SICB_SYSCR = SUPPLEMENTAL_0_RAISE(other);
  __builtin_bfin_ssync();
}
