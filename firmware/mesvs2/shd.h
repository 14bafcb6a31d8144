/* Matching by the sum of Hamming distances (SHD) with vertical, horizontal and modular recursion;
 * or of differences or their squares, as MEASURE says.
 *
 * h(x, y, d) is the number of different bits of left code x and right code x - d on row y.
 * S(x, y, d), the sum of h over the window centred on (x, y), comes from the row above by U, what
 * the window's new lowest row adds minus what its old highest row takes away; U moves to the right
 * by the column that enters the window minus the one that leaves it, and what leaves is what
 * entered WINDOW columns ago, kept in M. A score costs the same for every window.
 *
 * For each image row: shd_pair_rows, shd_enter_row; once WINDOW rows are in, also
 * shd_select_row and lrc_check_row. The first WINDOW rows displace none: their leaving row is
 * shd_zero_row, of which the two views differ nowhere. */
#ifndef MESVS2_SHD_H
#define MESVS2_SHD_H

#include <stdint.h>

#include "stereo_config.h"

/* The largest h. */
#if MEASURE_BY_BITS
#define MOST_DISTANCE 8
#elif CODE == CODE_RANK
#define MOST_DISTANCE 64
#elif MEASURE == MEASURE_SAD
#define MOST_DISTANCE 255
#else
#define MOST_DISTANCE 65025
#endif
/* Two kernels compute the same: by hand and two disparities at a time (shd_packed.c, with
 * shd_passes.bir), where that is possible; in C for all others and for other computers (shd.c). */
#if defined(__FINBACK__) && MEASURE_BY_BITS && WINDOW >= 3 && WINDOW <= 15 && \
    DISPARITY_COUNT >= 2 && DISPARITY_COUNT <= 32
#define SHD_PACKED 1
#else
#define SHD_PACKED 0
#endif

/* A key is score << KEY_BITS | the index of the disparity: the least key has the least score and,
 * among equal ones, the least disparity. */
#define KEY_BITS (SHD_PACKED || MOST_DISTANCE > 255 ? 5 : 8)
#define KEY_MASK ((1 << KEY_BITS) - 1)

extern uint8_t left_winners[MAP_WIDTH];  /* index of the winning disparity of each left pixel */
extern uint8_t right_winners[MAP_WIDTH]; /* and of each right one */
extern const uint8_t shd_zero_row[MAP_WIDTH];

/* Forgets the frame before: all scores 0. */
void shd_start_frame(void);

/* Joins the rows of codes that enter and leave the windows, for both views. */
void shd_pair_rows(const uint8_t* left_entering, const uint8_t* left_leaving,
                   const uint8_t* right_entering, const uint8_t* right_leaving);

/* Updates the scores of all columns and disparities. */
void shd_enter_row(void);

/* Finds the winners of both views on the row whose windows are complete. */
void shd_select_row(void);

#endif
