/* A filter of fractions: output i is the sum of tap k times sample i + k, rounded and saturated.
 * There are outputs + taps - 1 samples; the magnitudes of the taps add up to less than 2. */
#include <stdint.h>

static int16_t fraction_of(int32_t sum) {
  int32_t rounded = (sum + 0x4000) >> 15;
  if (rounded > INT16_MAX) {
    return INT16_MAX;
  }
  return rounded < INT16_MIN ? INT16_MIN : (int16_t)rounded;
}

void fir(const int16_t* restrict samples, const int16_t* restrict taps, int16_t* restrict output,
         int output_count, int tap_count) {
  for (int i = 0; i < output_count; ++i) {
    int32_t sum = 0;
    for (int k = 0; k < tap_count; ++k) {
      sum += taps[k] * samples[i + k];
    }
    output[i] = fraction_of(sum);
  }
}
