/* The sum of absolute differences of two blocks of 16 x 16 pixels in images of one width. */
#include <stdint.h>

#define SIZE 16

unsigned sad16x16(const uint8_t* restrict a, const uint8_t* restrict b, int width) {
  unsigned sum = 0;
  for (int y = 0; y < SIZE; ++y) {
    for (int x = 0; x < SIZE; ++x) {
      int difference = a[x] - b[x];
      sum += (unsigned)(difference < 0 ? -difference : difference);
    }
    a += width;
    b += width;
  }
  return sum;
}
