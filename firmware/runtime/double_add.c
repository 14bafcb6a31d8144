/* double: + and -. */
#define FLOAT_BITS 64
#include "soft_float/add.h"

real_t __adddf3(real_t a, real_t b) { return float_of(add_bits(bits_of(a), bits_of(b))); }

real_t __subdf3(real_t a, real_t b) { return __adddf3(a, float_of(bits_of(b) ^ SIGN_BIT)); }
