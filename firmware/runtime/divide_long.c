/* Division of 64-bit integers: the compiler calls these. Dividing by 0 gives all ones and the
 * dividend, as with 32 bits. */
#include <stdint.h>

#include "machine.h"

struct division {
  uint64_t quotient;
  uint64_t remainder;
};

/* By less than 2^31: word by word. */
static struct division divide_by_word(uint64_t dividend, uint32_t divisor) {
  uint32_t remainder = (uint32_t)(dividend >> 32);
  uint32_t high = 0;
  if (remainder >= divisor) {
    high = remainder / divisor;
    remainder -= high * divisor;
  }
  uint32_t low = divide_steps(&remainder, (uint32_t)dividend, divisor, 32);
  return (struct division){(uint64_t)high << 32 | low, remainder};
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
  if (divisor >> 31 == 0) {
    return divide_by_word(dividend, (uint32_t)divisor);
  }
  /* One bit of the quotient a step, from the first that can be 1. */
  int steps = leading_zeros_64(divisor) - leading_zeros_64(dividend) + 1;
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
