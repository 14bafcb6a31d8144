#ifndef SHARED_CHECKS_H
#define SHARED_CHECKS_H

#include <stdint.h>

#define CHECKED_BYTES 512

extern uint8_t bytes_in_l2[CHECKED_BYTES];
extern uint8_t bytes_in_l3[CHECKED_BYTES];

/* A ball: core A counts up `thrown`, core B makes `returned` equal to it. */
extern volatile uint32_t thrown;
extern volatile uint32_t returned;

#endif
