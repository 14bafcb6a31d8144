/* double: to and from integers of 32 and 64 bits. */
#define FLOAT_BITS 64
#include "soft_float/from_integer.h"
#include "soft_float/to_integer.h"

int32_t __fixdfsi(real_t value) { return to_int32(bits_of(value)); }

uint32_t __fixunsdfsi(real_t value) { return to_uint32(bits_of(value)); }

int64_t __fixdfdi(real_t value) { return to_int64(bits_of(value)); }

uint64_t __fixunsdfdi(real_t value) { return to_uint64(bits_of(value)); }

real_t __floatsidf(int32_t value) { return float_of(from_int32(value)); }

real_t __floatunsidf(uint32_t value) { return float_of(from_uint32(0, value)); }

real_t __floatdidf(int64_t value) { return float_of(from_int64(value)); }

real_t __floatundidf(uint64_t value) { return float_of(from_uint64(0, value)); }
