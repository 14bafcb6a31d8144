/* A frame, row by row: fetching, census of the row before, matching, storing. */
#include "lab.h"

_Alignas(4) uint8_t left_lines[LINE_COUNT * MAP_WIDTH];
_Alignas(4) uint8_t right_lines[LINE_COUNT * MAP_WIDTH];
/* The first and last rows and columns, which have no whole neighbourhood, stay 0. */
_Alignas(4) uint8_t left_census[MAP_HEIGHT][MAP_WIDTH];
_Alignas(4) uint8_t right_census[MAP_HEIGHT][RIGHT_MARGIN + MAP_WIDTH];
_Alignas(4) uint8_t disparities[MAP_WIDTH]; /* what is not computed stays 0 */

static void census_of(uint8_t* lines, uint8_t* census, const struct columns* columns, int row) {
  census_row(line_of(lines, columns, row - 1), line_of(lines, columns, row),
             line_of(lines, columns, row + 1), census + columns->first, columns->count);
}

__attribute__((noinline)) void census_pair(int row) {
  census_of(left_lines, left_census[row], &left_columns, row);
  census_of(right_lines, right_census[row] + RIGHT_MARGIN, &right_columns, row);
}

void process_frame(void) {
  for (int row = 0; row <= MAP_HEIGHT; ++row) {
    int complete = row - 1; /* its neighbours are there */
    if (row < MAP_HEIGHT) {
      fetch_row(row);
    }
    if (complete < 0) {
      continue;
    }
    if (complete > 0 && complete < MAP_HEIGHT - 1) {
      census_pair(complete);
    }
    match_row(complete, disparities);
    if (complete >= WINDOW - 1) {
      store_row(complete - HALF_WINDOW, disparities);
    }
  }
  transfer_finish();
}
