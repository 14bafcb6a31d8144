/* What every rung of the ladder computes, and how its parts fit together.
 *
 * A pair of 160x120 becomes the left view's disparities: census 3x3, sum of Hamming distances over
 * 15x15 windows, disparities 5 to 35, the least sum wins, the smaller disparity among equals. Rungs
 * differ in how they come to this map, never in the map. */
#ifndef LABS_LAB_H
#define LABS_LAB_H

#include <core.h>
#include <stdint.h>

#define CAMERA_WIDTH 640
#define CAMERA_HEIGHT 480
#define SUBSAMPLING 4 /* every 4th pixel of every 4th row */
#define MAP_WIDTH (CAMERA_WIDTH / SUBSAMPLING)
#define MAP_HEIGHT (CAMERA_HEIGHT / SUBSAMPLING)
#define MAP_PIXELS (MAP_WIDTH * MAP_HEIGHT)

#define WINDOW 15
#define HALF_WINDOW (WINDOW / 2)
/* A left pixel x is seen in the right image at x - d. */
#define DISPARITY_MIN 5
#define DISPARITY_MAX 35
#define DISPARITY_COUNT (DISPARITY_MAX - DISPARITY_MIN + 1)

/* Left columns that have at least one candidate: both windows wholly inside the images. */
#define FIRST_COLUMN (DISPARITY_MIN + HALF_WINDOW)
#define LAST_COLUMN (MAP_WIDTH - 1 - HALF_WINDOW)
#define COLUMN_COUNT (LAST_COLUMN - FIRST_COLUMN + 1)

#define LINE_COUNT 8 /* rows of an image that are kept until they are transformed */

/* Right columns -RIGHT_MARGIN..-1 are 0 and no part of the image: recursions may take them in for
 * windows that are no candidates. */
#define RIGHT_MARGIN 32

/* Columns of an image or a map. */
struct columns {
  int first;
  int count;
};

/* What this core fetches and transforms of either view, computes, and stores of the map. */
extern const struct columns left_columns;
extern const struct columns right_columns;
extern const struct columns computed_columns;
extern const struct columns stored_columns;

/* Where the cameras deliver and the map is taken from (frame_buffers.c). */
extern uint8_t vga_left[CAMERA_WIDTH * CAMERA_HEIGHT];
extern uint8_t vga_right[CAMERA_WIDTH * CAMERA_HEIGHT];
extern uint8_t disparity_map[MAP_PIXELS];

/* The newest rows of the images (frame.c), left_columns.count and right_columns.count bytes each:
 * row y is line y mod LINE_COUNT. */
extern uint8_t left_lines[LINE_COUNT * MAP_WIDTH];
extern uint8_t right_lines[LINE_COUNT * MAP_WIDTH];
static inline uint8_t* line_of(uint8_t* lines, const struct columns* columns, int row) {
  return lines + (row & (LINE_COUNT - 1)) * columns->count;
}

/* Their census, whole. */
extern uint8_t left_census[MAP_HEIGHT][MAP_WIDTH];
extern uint8_t right_census[MAP_HEIGHT][RIGHT_MARGIN + MAP_WIDTH];

/* From the frame in the camera buffers to the map, row by row. */
void process_frame(void);

/* transfer.c. Once, before the first frame. */
void transfer_start(enum core core);
/* Every 4th pixel of a row of both views, to left_lines and right_lines. Rows in turn from 0. */
void fetch_row(int row);
/* A row of the map; MAP_WIDTH disparities, which stay untouched until the next row is fetched. */
void store_row(int y, const uint8_t* disparities);
/* All rows are stored. */
void transfer_finish(void);

/* census.c: pixels 1 to columns - 2 of a row; bit 7 for the upper left neighbour, row by row to bit
 * 0 for the lower right one; 1 where the neighbour is darker than the centre. */
void census_row(const uint8_t* above, const uint8_t* centre, const uint8_t* below, uint8_t* census,
                int columns);

/* match.c: what each rung is about. The census of `row` is there; rows in turn from 0. From row
 * WINDOW - 1 on writes the disparities of the row HALF_WINDOW above: computed_columns only. */
void match_row(int row, uint8_t* disparities);

#endif
