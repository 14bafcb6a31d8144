/* Rectification by tables: for each pixel of the rectified picture the upper left one of four
 * neighbours in the camera's picture, and their weights as fractions of 1.15, all 0 where the
 * camera did not see. 10 bytes a pixel, 375 KB for both cameras: more than L1 and L2 hold, so the
 * tables lie in L3 and come by in bands. */
#ifndef MESVS2_RECTIFY_H
#define MESVS2_RECTIFY_H

#include <stdint.h>

#include "stereo_config.h"

#if MAP_WIDTH > 256 || MAP_HEIGHT > 256
typedef uint16_t source_index;
#else
typedef uint8_t source_index;
#endif

/* One row of a table, as it lies in memory. */
struct rectification_row {
  source_index source[MAP_WIDTH][2]; /* column, row; at most the last but one */
  int16_t weights[MAP_WIDTH][4];     /* upper left, upper right, lower left, lower right */
};

/* What flash begins with where tables were put there (finback stereo tables); the rows of both
 * cameras follow, the left one's first. */
struct rectification_header {
  uint32_t magic;
  uint16_t width;
  uint16_t height;
};
#define RECTIFICATION_MAGIC 0x54434552u /* "RECT" */

/* Writes `rows` rows of MAP_WIDTH pixels, rounded to the nearest grey. */
void rectify_rows(const uint8_t* image, const struct rectification_row* table, int rows,
                  uint8_t* rectified);

/* The table row of a camera that needs no rectification. */
void identity_row(int y, struct rectification_row* row);

#endif
