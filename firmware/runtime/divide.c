/* Division of 32-bit integers, which the processor has no instruction for: the compiler calls
 * these. As everywhere on a Blackfin, dividing by 0 is not caught; it gives all ones and the
 * dividend. */
#include <stdint.h>

struct division {
  uint32_t quotient;
  uint32_t remainder;
};

/* One bit of the quotient a step, the highest first. */
static struct division divide(uint32_t dividend, uint32_t divisor) {
  struct division result = {dividend, 0};
  for (int bit = 0; bit < 32; ++bit) {
    uint32_t shifted_out = result.remainder >> 31;
    result.remainder = result.remainder << 1 | result.quotient >> 31;
    result.quotient <<= 1;
    if (shifted_out != 0 || result.remainder >= divisor) {
      result.remainder -= divisor;
      result.quotient |= 1;
    }
  }
  return result;
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
