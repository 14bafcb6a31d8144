/* float: comparisons. The compiler holds what they return against 0 with the operator that they are
 * named after; where an operand is no number, that is false, but for "not equal". */
#define FLOAT_BITS 32
#include "soft_float/compare.h"

int __eqsf2(real_t a, real_t b) { return is_unequal(bits_of(a), bits_of(b)); }

int __nesf2(real_t a, real_t b) { return is_unequal(bits_of(a), bits_of(b)); }

int __ltsf2(real_t a, real_t b) { return order_of(bits_of(a), bits_of(b), 1); }

int __lesf2(real_t a, real_t b) { return order_of(bits_of(a), bits_of(b), 1); }

int __gtsf2(real_t a, real_t b) { return order_of(bits_of(a), bits_of(b), -1); }

int __gesf2(real_t a, real_t b) { return order_of(bits_of(a), bits_of(b), -1); }

int __unordsf2(real_t a, real_t b) { return is_unordered(bits_of(a), bits_of(b)); }
