/* Division of 32-bit integers, which the processor has no instruction for: the compiler calls
 * these. As everywhere on a Blackfin, dividing by 0 is not caught; it gives all ones and the
 * dividend. */
#include <stdint.h>

#include "machine.h"

struct division {
  uint32_t quotient;
  uint32_t remainder;
};

static inline struct division divide(uint32_t dividend, uint32_t divisor) {
  if (dividend < divisor) {
    return (struct division){0, dividend};
  }
  if ((int32_t)divisor < 2) {
    return divisor == 0   ? (struct division){UINT32_MAX, dividend}
           : divisor == 1 ? (struct division){dividend, 0}
                          : (struct division){1, dividend - divisor};
  }
  /* The steps begin where the quotient's first bit can be. */
  int steps = leading_zeros_32(divisor) - leading_zeros_32(dividend) + 1;
  uint32_t remainder = dividend >> steps;
  uint32_t quotient = divide_steps(&remainder, dividend << (32 - steps), divisor, steps);
  return (struct division){quotient, remainder};
}

static uint32_t magnitude(int32_t value) {
  return value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
}

static int32_t with_sign(uint32_t value, int negative) {
  return (int32_t)(negative ? 0u - value : value);
}

uint32_t __udivsi3(uint32_t dividend, uint32_t divisor) {
  return divide(dividend, divisor).quotient;
}

uint32_t __umodsi3(uint32_t dividend, uint32_t divisor) {
  return divide(dividend, divisor).remainder;
}

int32_t __divsi3(int32_t dividend, int32_t divisor) {
  return with_sign(divide(magnitude(dividend), magnitude(divisor)).quotient,
                   (dividend < 0) != (divisor < 0));
}

/* The remainder has the dividend's sign. */
int32_t __modsi3(int32_t dividend, int32_t divisor) {
  return with_sign(divide(magnitude(dividend), magnitude(divisor)).remainder, dividend < 0);
}
