/* Interrupts between the cores: a core wakes the other one, which then looks at shared memory for
 * what has changed. */
#ifndef FINBACK_CORE_INTERRUPT_H
#define FINBACK_CORE_INTERRUPT_H

#include <core.h>

/* Lets the other core interrupt `core`, the calling one. */
void core_interrupt_start(enum core core);

/* Interrupts `other`, once what was written before has arrived in shared memory. */
void core_interrupt_raise(enum core other);

#endif
