/* The sum of products of two vectors of 16-bit integers. The sum fits 32 bits. */
#include <stdint.h>

int32_t dot_product(const int16_t* restrict a, const int16_t* restrict b, int count) {
  int32_t sum = 0;
  for (int i = 0; i < count; ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}
