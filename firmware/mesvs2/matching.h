/* From two images of codes to the disparity map of the left one, row by row. */
#ifndef MESVS2_MATCHING_H
#define MESVS2_MATCHING_H

#include <stdint.h>

/* Writes row `y` of the map: MAP_WIDTH disparities, 0 invalid. To be called for y = 0 to
 * MAP_HEIGHT - 1 in turn: a row's scores come from those of the row above. */
void match_row(const uint8_t* left_codes, const uint8_t* right_codes, int y, uint8_t* disparities);

#endif
