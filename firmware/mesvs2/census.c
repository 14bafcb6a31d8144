#include "census.h"

#include "stereo_config.h"

__attribute__((noinline)) void census_row(const uint8_t* restrict above,
                                          const uint8_t* restrict centre,
                                          const uint8_t* restrict below, uint8_t* restrict census) {
  *census++ = 0;
  for (int x = 1; x < MAP_WIDTH - 1; ++x) {
    unsigned pixel = centre[1];
    unsigned bits = above[0] < pixel;
    bits = 2 * bits + (above[1] < pixel);
    bits = 2 * bits + (above[2] < pixel);
    bits = 2 * bits + (centre[0] < pixel);
    bits = 2 * bits + (centre[2] < pixel);
    bits = 2 * bits + (below[0] < pixel);
    bits = 2 * bits + (below[1] < pixel);
    bits = 2 * bits + (below[2] < pixel);
    *census++ = (uint8_t)bits;
    ++above;
    ++centre;
    ++below;
  }
  *census = 0;
}
