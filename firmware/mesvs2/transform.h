/* The codes by which pixels are compared, in the place of their greys. */
#ifndef MESVS2_TRANSFORM_H
#define MESVS2_TRANSFORM_H

#include <stdint.h>
#include <string.h>

#include "census.h"
#include "rank.h"
#include "stereo_config.h"

/* The codes of a row, from it and the rows above and below. */
static inline void transform_row(const uint8_t* above, const uint8_t* centre, const uint8_t* below,
                                 uint8_t* codes) {
#if CODE == CODE_CENSUS
  census_row(above, centre, below, codes);
#elif CODE == CODE_RANK
  rank_row(above, centre, below, codes);
#else
  (void)above;
  (void)below;
  memcpy(codes, centre, MAP_WIDTH);
#endif
}

#endif
