#include "events.h"

#include <bf561.h>

/* IMASK of the events attached so far. */
static unsigned attached_events;

void events_attach(enum core core, int source, int ivg, void (*handler)(void)) {
  volatile struct sic_registers* sic =
      (volatile struct sic_registers*)(core == CORE_A ? SICA_BASE : SICB_BASE);
  unsigned field = 4u * (source % 8);
  unsigned word = (unsigned)source / 32;
  unsigned bit = 1u << source % 32;

  /* After reset every source ends IDLE; only attached ones shall. */
  if (attached_events == 0) {
    sic->iwr[0] = 0;
    sic->iwr[1] = 0;
  }
  attached_events |= 1u << ivg;
  EVT(ivg) = (uint32_t)handler;
  sic->iar[source / 8] = (sic->iar[source / 8] & ~(0xFu << field)) | (unsigned)(ivg - EVT_IVG7)
                                                                         << field;
  sic->imask[word] |= bit;
  sic->iwr[word] |= bit;
  __builtin_bfin_ssync();
}

void events_enable(void) { __builtin_bfin_sti(attached_events); }
