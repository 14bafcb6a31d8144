#include "postprocess.h"

#include <string.h>

#include "settings.h"
#include "variance.h"

/* One more row than the window has, so that the leaving one is still there; a power of two. */
#define HISTORY_ROWS 16
_Static_assert(HISTORY_ROWS > VARIANCE_WINDOW, "the leaving row is still there");

uint32_t plain_flags[MAP_HEIGHT][FLAG_WORDS];
uint8_t checked_rows[HISTORY_ROWS][MAP_WIDTH];

uint8_t* checked_row(int y) { return checked_rows[y % HISTORY_ROWS]; }

/* Moves the windows down to a row of the checked map. */
static void enter_checked_row(int y) {
  variance_enter_row(checked_row(y),
                     y < VARIANCE_WINDOW ? variance_no_row : checked_row(y - VARIANCE_WINDOW));
}

/* `disparities` belongs to the pixels at the centre of the windows. */
static void drop_torn_pixels(const uint32_t* plain, uint8_t* disparities) {
  const uint32_t* variances = variance_row;
  uint32_t threshold = SCALED_VARIANCE(stereo_settings.disparity_threshold);
  uint8_t* corner = disparities - HALF_VARIANCE_WINDOW;
  for (int word = 0; word < FLAG_WORDS; ++word) {
    const uint32_t* variance = variances;
    uint8_t* disparity = corner;
    for (uint32_t flags = *plain++; flags != 0; flags >>= 1) {
      if ((flags & 1) != 0 && *variance >= threshold) {
        *disparity = 0;
      }
      ++variance;
      ++disparity;
    }
    variances += 32;
    corner += 32;
  }
}

__attribute__((noinline)) void post_process_row(int y, uint8_t* disparities) {
  int lowest = y + HALF_VARIANCE_WINDOW;
  if (y == 0) {
    variance_start();
    for (int row = 0; row < HALF_VARIANCE_WINDOW; ++row) {
      enter_checked_row(row);
    }
  }
  memcpy(disparities, checked_row(y), MAP_WIDTH);
  if (lowest < MAP_HEIGHT) {
    enter_checked_row(lowest);
    if (y >= HALF_VARIANCE_WINDOW) {
      drop_torn_pixels(plain_flags[lowest], disparities);
    }
  }
}
