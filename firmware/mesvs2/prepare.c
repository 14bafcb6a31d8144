#include "prepare.h"

#include <string.h>

#include "transform.h"

_Static_assert(BANDS_OF_PICTURE* BAND_ROWS == MAP_HEIGHT, "bands fill the picture");
_Static_assert(LINE_COUNT >= VARIANCE_WINDOW + BAND_ROWS && LINE_COUNT % BAND_ROWS == 0,
               "the leaving row is still there; a band lies in one piece");

_Alignas(4) uint8_t rectified_lines[LINE_COUNT][MAP_WIDTH];

/* The first and the last row lack neighbours. */
static void border_row(const uint8_t* greys, uint8_t* codes) {
  if (CODE == CODE_GREY) {
    memcpy(codes, greys, MAP_WIDTH);
  } else {
    memset(codes, 0, MAP_WIDTH);
  }
}

__attribute__((noinline)) void prepare_codes(int y, uint8_t codes[BAND_ROWS + 1][MAP_WIDTH]) {
  for (int i = first_code_row(y); i < end_of_code_rows(y); ++i) {
    int row = y + i - 1;
    if (row == 0 || row == MAP_HEIGHT - 1) {
      border_row(rectified_line(row), codes[i]);
    } else {
      transform_row(rectified_line(row - 1), rectified_line(row), rectified_line(row + 1),
                    codes[i]);
    }
  }
}

__attribute__((noinline)) void prepare_texture(int y, uint32_t flags[BAND_ROWS][FLAG_WORDS]) {
  if (y == 0) {
    texture_start();
  }
  for (int i = 0; i < BAND_ROWS; ++i) {
    int row = y + i;
    texture_enter_row(
        row, rectified_line(row),
        row < VARIANCE_WINDOW ? variance_no_row : rectified_line(row - VARIANCE_WINDOW), flags[i]);
  }
}
