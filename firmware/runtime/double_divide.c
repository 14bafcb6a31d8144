/* double: division. */
#define FLOAT_BITS 64
#include "soft_float/divide.h"

real_t __divdf3(real_t a, real_t b) { return float_of(divide_bits(bits_of(a), bits_of(b))); }
