/* rand: a linear congruential generator of 32 bits, of which the upper ones are good enough. */
#include <stdint.h>
#include <stdlib.h>

static uint32_t state = 1;

void srand(unsigned seed) { state = seed; }

int rand(void) {
  state = state * 1664525u + 1013904223u;
  return (int)(state >> 16 & RAND_MAX);
}
