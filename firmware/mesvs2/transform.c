#include "transform.h"

#include <string.h>

#include "census.h"
#include "rank.h"

/* The untouched copies of the row above and of the row being overwritten. */
uint8_t transform_lines[2][MAP_WIDTH];

#if CODE == CODE_CENSUS
#define transform_row census_row
#else
#define transform_row rank_row
#endif

__attribute__((noinline)) void transform_image(uint8_t* image) {
  if (CODE == CODE_GREY) {
    return;
  }
  uint8_t* above = transform_lines[0];
  uint8_t* centre = transform_lines[1];
  uint8_t* row = image + MAP_WIDTH;

  memcpy(above, image, MAP_WIDTH);
  memset(image, 0, MAP_WIDTH);
  for (int y = 1; y < MAP_HEIGHT - 1; ++y) {
    uint8_t* done = above;
    memcpy(centre, row, MAP_WIDTH);
    transform_row(above, centre, row + MAP_WIDTH, row);
    above = centre;
    centre = done;
    row += MAP_WIDTH;
  }
  memset(row, 0, MAP_WIDTH);
}
