/* Comparisons: what the compiler's calls return. The two zeros are equal; what is no number is
 * unequal to everything and in no order with anything. */
#ifndef FINBACK_SOFT_FLOAT_COMPARE_H
#define FINBACK_SOFT_FLOAT_COMPARE_H

#include "format.h"

static inline int is_unordered(bits_t a, bits_t b) {
  return magnitude_of(a) > INFINITE_BITS || magnitude_of(b) > INFINITE_BITS;
}

static inline int is_unequal(bits_t a, bits_t b) {
  return is_unordered(a, b) || (a != b && magnitude_of(a | b) != 0);
}

/* -1, 0 or 1 as a is less than, equal to or greater than b; `otherwise` where there is no order. */
static inline int order_of(bits_t a, bits_t b, int otherwise) {
  if (is_unordered(a, b)) {
    return otherwise;
  }
  if (a == b || magnitude_of(a | b) == 0) {
    return 0;
  }
  if (sign_of(a ^ b) != 0) {
    return sign_of(a) != 0 ? -1 : 1;
  }
  return (a < b) == (sign_of(a) == 0) ? -1 : 1;
}

#endif
