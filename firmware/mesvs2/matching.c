#include "matching.h"

#include <string.h>

#include "geometry.h"
#include "lrc.h"
#include "shd.h"

/* Moves all windows down by one row: `row` enters, the one as many rows as the window has above it
 * leaves. */
static void enter_row(const uint8_t* left_codes, const uint8_t* right_codes, int row) {
  const uint8_t* left = left_codes + row * MAP_WIDTH;
  const uint8_t* right = right_codes + row * MAP_WIDTH;
  if (row < geometry.window) {
    shd_pair_rows(left, shd_zero_row, right, shd_zero_row);
  } else {
    shd_pair_rows(left, left - geometry.window * MAP_WIDTH, right,
                  right - geometry.window * MAP_WIDTH);
  }
  shd_enter_row();
}

void match_row(const uint8_t* left_codes, const uint8_t* right_codes, int y, uint8_t* disparities) {
  if (y < geometry.half_window || y >= MAP_HEIGHT - geometry.half_window) {
    memset(disparities, 0, MAP_WIDTH);
    return;
  }
  if (y == geometry.half_window) {
    shd_start_frame();
    for (int row = 0; row < geometry.window - 1; ++row) {
      enter_row(left_codes, right_codes, row);
    }
  }
  enter_row(left_codes, right_codes, y + geometry.half_window);
  shd_select_row();
  lrc_check_row(disparities);
}
