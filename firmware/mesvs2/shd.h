/* Matching by the sum of Hamming distances (SHD) with vertical, horizontal and modular recursion;
 * or of differences or their squares, as MEASURE says.
 *
 * h(x, y, d) is the number of different bits of left code x and right code x - d on row y.
 * S(x, y, d), the sum of h over the window centred on (x, y), comes from the row above by U, what
 * the window's new lowest row adds minus what its old highest row takes away; U moves to the right
 * by the column that enters the window minus the one that leaves it, and what leaves is what
 * entered WINDOW columns ago, kept in M. A score costs the same for every window.
 *
 * For each image row: shd_pair_rows, shd_start_row, shd_update_row; once WINDOW rows are in, also
 * shd_select_row and lrc_check_row. The first WINDOW rows displace none: their leaving row is
 * shd_zero_row, of which the two views differ nowhere. */
#ifndef MESVS2_SHD_H
#define MESVS2_SHD_H

#include <stdint.h>

#include "stereo_config.h"

/* Right columns -PAIR_MARGIN..-1 do not exist, but columns of a window that is no candidate ask for
 * them. Whatever is there is taken in and dropped again by the recursion. */
#define PAIR_MARGIN (DISPARITY_MAX - DISPARITY_MIN)

/* A winner is score << KEY_SHIFT | (d - DISPARITY_MIN): the least key has the least score and,
 * among equal ones, the least disparity. */
#define KEY_SHIFT (MOST_DISTANCE > 255 ? 5 : 8)
#define KEY_MASK ((1 << KEY_SHIFT) - 1)

/* The largest h, and what holds sums of it over a window. */
#if MEASURE_BY_BITS
#define MOST_DISTANCE 8
#elif CODE == CODE_RANK
#define MOST_DISTANCE 64
#elif MEASURE == MEASURE_SAD
#define MOST_DISTANCE 255
#else
#define MOST_DISTANCE 65025
#endif
#if WINDOW * WINDOW * MOST_DISTANCE > 65535
typedef uint32_t shd_score;
#else
typedef uint16_t shd_score;
#endif

extern shd_score shd_scores[COLUMN_COUNT * DISPARITY_COUNT]; /* S: [x - FIRST_COLUMN][d] */
extern shd_score shd_update[DISPARITY_COUNT];                /* U: [d] */
extern shd_score shd_modular[WINDOW * DISPARITY_COUNT];      /* M: [x mod WINDOW][d] */
extern uint16_t left_pairs[MAP_WIDTH];                       /* [x] */
extern uint16_t right_pairs[PAIR_MARGIN + MAP_WIDTH];        /* [PAIR_MARGIN + x] */
extern int32_t left_keys[MAP_WIDTH];                         /* winner of each left pixel */
extern int32_t right_keys[MAP_WIDTH];                        /* winner of each right pixel */
extern const uint8_t shd_zero_row[MAP_WIDTH];

/* Forgets the frame before: all scores 0. */
void shd_start_frame(void);

/* Joins the rows of codes that enter and leave the windows, for both views. */
void shd_pair_rows(const uint8_t* left_entering, const uint8_t* left_leaving,
                   const uint8_t* right_entering, const uint8_t* right_leaving);

/* Begins U and M anew and takes in the row's first WINDOW - 1 columns. */
void shd_start_row(void);

/* Takes in the other columns: updates the scores of all columns and disparities. */
void shd_update_row(void);

/* Finds the winners of both views on the row whose windows are complete. */
void shd_select_row(void);

#endif
