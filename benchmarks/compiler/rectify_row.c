/* One row of a rectified image: each pixel is mixed from four neighbours of the source, 256 pixels
 * wide: the one that the table points to, the next, and the two below. Fractions: down, across. */
#include <stdint.h>

#define WIDTH 160
#define SOURCE_WIDTH 256

static int mixed(int one, int other, int fraction) {
  return one + (((other - one) * fraction + 128) >> 8);
}

void rectify_row(const uint8_t* const* restrict sources, const uint8_t (*restrict fractions)[2],
                 uint8_t* restrict row) {
  for (int x = 0; x < WIDTH; ++x) {
    const uint8_t* upper = sources[x];
    const uint8_t* lower = upper + SOURCE_WIDTH;
    int left = mixed(upper[0], lower[0], fractions[x][0]);
    int right = mixed(upper[1], lower[1], fractions[x][0]);
    row[x] = (uint8_t)mixed(left, right, fractions[x][1]);
  }
}
