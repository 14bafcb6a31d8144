/* The inner loops of the matching: in C on one rung, by hand on the next. */
#ifndef LABS_KERNELS_H
#define LABS_KERNELS_H

#include <stdint.h>

/* Disparities of a column, DISPARITY_COUNT and one that is never a candidate: two fill a word. */
#define SLOTS 32

/* For `columns` columns in turn, an even number, and k of 0 to SLOTS - 1:
 *     update[k] += (different bits of left[column] and right[column - k]) - 16
 *     scores[column * SLOTS + k] += update[k]
 * scores and update lie at multiples of 4. */
void update_row(uint16_t* scores, uint16_t* update, const uint32_t* left, const uint32_t* right,
                int columns);

/* disparities[column] = DISPARITY_MIN + the first k of the least scores[column * SLOTS + k], all
 * below 32768. */
void select_row(const uint16_t* scores, uint8_t* disparities, int columns);

#endif
