/* float: to and from integers of 32 and 64 bits. */
#define FLOAT_BITS 32
#include "soft_float/from_integer.h"
#include "soft_float/to_integer.h"

int32_t __fixsfsi(real_t value) { return to_int32(bits_of(value)); }

uint32_t __fixunssfsi(real_t value) { return to_uint32(bits_of(value)); }

int64_t __fixsfdi(real_t value) { return to_int64(bits_of(value)); }

uint64_t __fixunssfdi(real_t value) { return to_uint64(bits_of(value)); }

real_t __floatsisf(int32_t value) { return float_of(from_int32(value)); }

real_t __floatunsisf(uint32_t value) { return float_of(from_uint32(0, value)); }

real_t __floatdisf(int64_t value) { return float_of(from_int64(value)); }

real_t __floatundisf(uint64_t value) { return float_of(from_uint64(0, value)); }
