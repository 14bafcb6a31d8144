/* Fractions to floating point and back. Towards fractions the value is truncated towards zero and
 * saturated; what is no number becomes 0. */
#ifndef FRACT2FLOAT_CONV_H
#define FRACT2FLOAT_CONV_H

#include <fract_math.h>

FINBACK_INLINE float fr16_to_float(fract16 a) { return (float)a / 32768.0f; }
FINBACK_INLINE float fr32_to_float(fract32 a) { return (float)a / 2147483648.0f; }
FINBACK_INLINE fract32 float_to_fr32(float a) {
  const float scaled = a * 2147483648.0f;
  return scaled >= 2147483648.0f    ? 0x7fffffff
         : scaled <= -2147483648.0f ? -0x7fffffff - 1
         : scaled == scaled         ? (fract32)scaled
                                    : 0;
}
FINBACK_INLINE fract16 float_to_fr16(float a) {
  const float scaled = a * 32768.0f;
  return scaled >= 32767.0f    ? 0x7fff
         : scaled <= -32768.0f ? (fract16)-0x8000
         : scaled == scaled    ? (fract16)scaled
                               : 0;
}
FINBACK_INLINE fract32 fr16_to_fr32(fract16 a) { return a * 65536; }
FINBACK_INLINE fract16 fr32_to_fr16(fract32 a) { return trunc_fr1x32(a); }

#endif
