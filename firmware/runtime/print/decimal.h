/* A double as an exact decimal number, for printing: every digit there is, in limbs of four. */
#ifndef FINBACK_DECIMAL_H
#define FINBACK_DECIMAL_H

#include <stdint.h>

/* 2^1024 has 309 digits before the point and may gain one by rounding; 2^-1074 has 1074 behind it.
 */
#define WHOLE_LIMBS 78
#define FRACTION_LIMBS 269

struct decimal {
  int first; /* the highest limb that is not 0; of zero, the one of the units */
  int end;   /* behind the lowest that is not 0 */
  uint16_t limbs[WHOLE_LIMBS + FRACTION_LIMBS]; /* limbs[WHOLE_LIMBS - 1] has the units */
};

/* `magnitude` are the bits of a finite double without its sign. */
void decimal_of(struct decimal* number, uint64_t magnitude);

/* Rounds to a multiple of 10^position, ties to even. */
void decimal_round(struct decimal* number, int position);

/* The position of the first digit that is not 0; of zero, 0. */
int decimal_top(const struct decimal* number);

/* The digit that counts 10^position. */
unsigned decimal_digit(const struct decimal* number, int position);

#endif
