#include "lab.h"

__attribute__((noinline)) void census_row(const uint8_t* restrict above,
                                          const uint8_t* restrict centre,
                                          const uint8_t* restrict below, uint8_t* restrict census,
                                          int columns) {
  for (int x = 1; x < columns - 1; ++x) {
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
}
