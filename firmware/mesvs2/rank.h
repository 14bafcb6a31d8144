/* Rank transform 3x3: how many of the neighbours are darker than the centre. Border pixels become
 * 0. */
#ifndef MESVS2_RANK_H
#define MESVS2_RANK_H

#include <stdint.h>

/* One row from copies of the row above and itself, and the row below as it lies in the image. */
void rank_row(const uint8_t* above, const uint8_t* centre, const uint8_t* below, uint8_t* ranks);

#endif
