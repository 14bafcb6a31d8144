/* Division of 64-bit integers: the compiler calls these. Dividing by 0 gives all ones and the
 * dividend, as with 32 bits. */
#include <stdint.h>

struct division {
  uint64_t quotient;
  uint64_t remainder;
};

static int leading_zeros(uint64_t value) {
  uint32_t high = (uint32_t)(value >> 32);
  return high != 0 ? __builtin_clz(high) : 32 + __builtin_clz((uint32_t)value);
}

static struct division divide(uint64_t dividend, uint64_t divisor) {
  if (divisor == 0) {
    return (struct division){UINT64_MAX, dividend};
  }
  if (dividend < divisor) {
    return (struct division){0, dividend};
  }
  if (dividend >> 32 == 0) {
    uint32_t quotient = (uint32_t)dividend / (uint32_t)divisor;
    return (struct division){quotient, (uint32_t)dividend - quotient * (uint32_t)divisor};
  }
  /* One bit of the quotient a step, from the first that can be 1. */
  int steps = leading_zeros(divisor) - leading_zeros(dividend) + 1;
  divisor <<= steps - 1;
  uint64_t quotient = 0;
  for (; steps != 0; --steps) {
    quotient <<= 1;
    if (dividend >= divisor) {
      dividend -= divisor;
      quotient |= 1;
    }
    divisor >>= 1;
  }
  return (struct division){quotient, dividend};
}

static uint64_t magnitude(int64_t value) {
  return value < 0 ? 0u - (uint64_t)value : (uint64_t)value;
}

static int64_t with_sign(uint64_t value, int negative) {
  return (int64_t)(negative ? 0u - value : value);
}

uint64_t __udivdi3(uint64_t dividend, uint64_t divisor) {
  return divide(dividend, divisor).quotient;
}

uint64_t __umoddi3(uint64_t dividend, uint64_t divisor) {
  return divide(dividend, divisor).remainder;
}

int64_t __divdi3(int64_t dividend, int64_t divisor) {
  return with_sign(divide(magnitude(dividend), magnitude(divisor)).quotient,
                   (dividend < 0) != (divisor < 0));
}

/* The remainder has the dividend's sign. */
int64_t __moddi3(int64_t dividend, int64_t divisor) {
  return with_sign(divide(magnitude(dividend), magnitude(divisor)).remainder, dividend < 0);
}
