#include "rank.h"

#include "stereo_config.h"

/* See MEASURE_BY_BITS. */
static unsigned code_of(unsigned rank) { return MEASURE_BY_BITS ? (1u << rank) - 1 : rank; }

__attribute__((noinline)) void rank_row(const uint8_t* restrict above,
                                        const uint8_t* restrict centre,
                                        const uint8_t* restrict below, uint8_t* restrict ranks) {
  *ranks++ = 0;
  for (int x = 1; x < MAP_WIDTH - 1; ++x) {
    unsigned pixel = centre[1];
    unsigned rank = above[0] < pixel;
    rank += above[1] < pixel;
    rank += above[2] < pixel;
    rank += centre[0] < pixel;
    rank += centre[2] < pixel;
    rank += below[0] < pixel;
    rank += below[1] < pixel;
    rank += below[2] < pixel;
    *ranks++ = (uint8_t)code_of(rank);
    ++above;
    ++centre;
    ++below;
  }
  *ranks = 0;
}
