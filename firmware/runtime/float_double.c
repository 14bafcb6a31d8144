/* Between float and double. Doubles have room for every float, so that only the way back rounds. */
#define FLOAT_BITS 32
#include "soft_float/format.h"

#define DOUBLE_FRACTION_BITS 52
#define DOUBLE_BIAS 1023
#define MORE_FRACTION_BITS (DOUBLE_FRACTION_BITS - FRACTION_BITS)
#define DOUBLE_INFINITE ((uint64_t)0x7FF << DOUBLE_FRACTION_BITS)

union double_bits {
  double value;
  uint64_t bits;
};

double __extendsfdf2(float value) {
  bits_t bits = bits_of(value);
  bits_t magnitude = magnitude_of(bits);
  union double_bits result;
  if (magnitude == 0) {
    result.bits = 0;
  } else if (magnitude >= INFINITE_BITS) {
    bits_t quiet = magnitude > INFINITE_BITS ? magnitude | QUIET_BIT : magnitude;
    result.bits = DOUBLE_INFINITE | (uint64_t)quiet << MORE_FRACTION_BITS;
  } else {
    int exponent;
    bits_t significand = normalised_significand(magnitude, &exponent);
    /* The hidden bit adds one to the exponent. */
    result.bits = ((uint64_t)(exponent + DOUBLE_BIAS - EXPONENT_BIAS - 1) << DOUBLE_FRACTION_BITS) +
                  ((uint64_t)significand << MORE_FRACTION_BITS);
  }
  result.bits |= (uint64_t)sign_of(bits) << 32;
  return result.value;
}

float __truncdfsf2(double value) {
  union double_bits wide = {value};
  bits_t sign = sign_of((bits_t)(wide.bits >> 32));
  uint64_t magnitude = wide.bits & ~((uint64_t)1 << 63);
  if (magnitude >= DOUBLE_INFINITE) {
    if (magnitude == DOUBLE_INFINITE) {
      return float_of(sign | INFINITE_BITS);
    }
    bits_t payload = (bits_t)(magnitude >> MORE_FRACTION_BITS) & (HIDDEN_BIT - 1);
    return float_of(sign | NO_NUMBER | payload);
  }
  int exponent = (int)(magnitude >> DOUBLE_FRACTION_BITS) - DOUBLE_BIAS + EXPONENT_BIAS;
  if (exponent < -FRACTION_BITS) {
    return float_of(sign); /* below half of the smallest subnormal float */
  }
  uint64_t significand = magnitude & (((uint64_t)1 << DOUBLE_FRACTION_BITS) - 1);
  significand |= (uint64_t)1 << DOUBLE_FRACTION_BITS;
  const int spare = MORE_FRACTION_BITS - EXTRA_BITS;
  bits_t lost = (bits_t)significand & (((bits_t)1 << spare) - 1);
  bits_t kept = (bits_t)(significand >> spare) | (lost != 0);
  return float_of(round_and_pack(sign, exponent, kept));
}
