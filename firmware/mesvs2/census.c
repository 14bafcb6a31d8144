#include "census.h"

#include <string.h>

#include "stereo_config.h"

/* The untouched copies of the row above and of the row being overwritten. */
uint8_t census_lines[2][MAP_WIDTH];

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

__attribute__((noinline)) void census_image(uint8_t* image) {
  uint8_t* above = census_lines[0];
  uint8_t* centre = census_lines[1];
  uint8_t* row = image + MAP_WIDTH;

  memcpy(above, image, MAP_WIDTH);
  memset(image, 0, MAP_WIDTH);
  for (int y = 1; y < MAP_HEIGHT - 1; ++y) {
    uint8_t* done = above;
    memcpy(centre, row, MAP_WIDTH);
    census_row(above, centre, row + MAP_WIDTH, row);
    above = centre;
    centre = done;
    row += MAP_WIDTH;
  }
  memset(row, 0, MAP_WIDTH);
}
