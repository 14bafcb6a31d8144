#include "matching.h"

#include <string.h>

#include "lrc.h"
#include "shd.h"

/* Moves all windows down by one row: `row` enters, the one WINDOW rows above it leaves. */
static void enter_row(const uint8_t* left_codes, const uint8_t* right_codes, int row) {
  const uint8_t* left = left_codes + row * MAP_WIDTH;
  const uint8_t* right = right_codes + row * MAP_WIDTH;
  if (row < WINDOW) {
    shd_pair_rows(left, shd_zero_row, right, shd_zero_row);
  } else {
    shd_pair_rows(left, left - WINDOW * MAP_WIDTH, right, right - WINDOW * MAP_WIDTH);
  }
  shd_enter_row();
}

void match_row(const uint8_t* left_codes, const uint8_t* right_codes, int y, uint8_t* disparities) {
  if (y < HALF_WINDOW || y >= MAP_HEIGHT - HALF_WINDOW) {
    memset(disparities, 0, MAP_WIDTH);
    return;
  }
  if (y == HALF_WINDOW) {
    shd_start_frame();
    for (int row = 0; row < WINDOW - 1; ++row) {
      enter_row(left_codes, right_codes, row);
    }
  }
  enter_row(left_codes, right_codes, y + HALF_WINDOW);
  shd_select_row();
  lrc_check_row(disparities);
}
