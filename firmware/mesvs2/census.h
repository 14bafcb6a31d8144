/* Census transform 3x3: bit 7 for the upper left neighbour, row by row to bit 0 for the lower right
 * one; 1 where the neighbour is darker than the centre. Border pixels become 0. */
#ifndef MESVS2_CENSUS_H
#define MESVS2_CENSUS_H

#include <stdint.h>

/* One row from copies of the row above and itself, and the row below as it lies in the image. */
void census_row(const uint8_t* above, const uint8_t* centre, const uint8_t* below, uint8_t* census);

#endif
