/* double: multiplication. */
#define FLOAT_BITS 64
#include "soft_float/multiply.h"

real_t __muldf3(real_t a, real_t b) { return float_of(multiply_bits(bits_of(a), bits_of(b))); }
