/* The census of one row of pixels: a bit for each of the eight neighbours, 1 where it is darker.
 * The two pixels at the ends have none: 0. */
#include <stdint.h>

#define WIDTH 160

void census_row(const uint8_t* restrict above, const uint8_t* restrict centre,
                const uint8_t* restrict below, uint8_t* restrict census) {
  census[0] = 0;
  for (int x = 1; x < WIDTH - 1; ++x) {
    unsigned pixel = centre[x];
    unsigned bits = above[x - 1] < pixel;
    bits = 2 * bits + (above[x] < pixel);
    bits = 2 * bits + (above[x + 1] < pixel);
    bits = 2 * bits + (centre[x - 1] < pixel);
    bits = 2 * bits + (centre[x + 1] < pixel);
    bits = 2 * bits + (below[x - 1] < pixel);
    bits = 2 * bits + (below[x] < pixel);
    bits = 2 * bits + (below[x + 1] < pixel);
    census[x] = (uint8_t)bits;
  }
  census[WIDTH - 1] = 0;
}
