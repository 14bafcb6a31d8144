/* double: comparisons. The compiler holds what they return against 0 with the operator that they
 * are named after; where an operand is no number, that is false, but for "not equal". */
#define FLOAT_BITS 64
#include "soft_float/compare.h"

int __eqdf2(real_t a, real_t b) { return is_unequal(bits_of(a), bits_of(b)); }

int __nedf2(real_t a, real_t b) { return is_unequal(bits_of(a), bits_of(b)); }

int __ltdf2(real_t a, real_t b) { return order_of(bits_of(a), bits_of(b), 1); }

int __ledf2(real_t a, real_t b) { return order_of(bits_of(a), bits_of(b), 1); }

int __gtdf2(real_t a, real_t b) { return order_of(bits_of(a), bits_of(b), -1); }

int __gedf2(real_t a, real_t b) { return order_of(bits_of(a), bits_of(b), -1); }

int __unorddf2(real_t a, real_t b) { return is_unordered(bits_of(a), bits_of(b)); }
