/* What core A makes of rectified rows while they are at hand: the codes by which they are compared,
 * and of the left picture flags where it is plain. A picture comes in bands of rows; codes are a
 * row behind, since they want the row below. */
#ifndef MESVS2_PREPARE_H
#define MESVS2_PREPARE_H

#include <stdint.h>

#include "stereo_config.h"
#include "texture.h"
#include "variance.h"

#define BAND_ROWS 4
#define BAND_PIXELS (BAND_ROWS * MAP_WIDTH)
#define BANDS_OF_PICTURE (MAP_HEIGHT / BAND_ROWS)

/* The newest rows of a picture: row y is line y mod LINE_COUNT. */
#define LINE_COUNT 32
extern uint8_t rectified_lines[LINE_COUNT][MAP_WIDTH];
static inline uint8_t* rectified_line(int y) { return rectified_lines[y % LINE_COUNT]; }

/* Of the band that begins with row y, the rows of which are in their lines: codes from row y - 1 on
 * (where y is 0: a row of nothing) to y + BAND_ROWS - 2, of the last band also of the last row. */
void prepare_codes(int y, uint8_t codes[BAND_ROWS + 1][MAP_WIDTH]);

/* Which of these rows are codes. */
static inline int first_code_row(int y) { return y == 0 ? 1 : 0; }
static inline int end_of_code_rows(int y) {
  return y == MAP_HEIGHT - BAND_ROWS ? BAND_ROWS + 1 : BAND_ROWS;
}

/* Of the same band of the left picture: flags of its rows. */
void prepare_texture(int y, uint32_t flags[BAND_ROWS][FLAG_WORDS]);

#endif
