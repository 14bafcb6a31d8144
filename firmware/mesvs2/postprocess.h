/* Post-processing by equation 19: disparities are given up where the picture has no texture and
 * they contradict each other. A pixel whose window does not lie inside the image is kept. */
#ifndef MESVS2_POSTPROCESS_H
#define MESVS2_POSTPROCESS_H

#include <stdint.h>

#include "stereo_config.h"
#include "texture.h"

/* Where the picture has no texture, as texture.h says; to be filled before the first row. */
extern uint32_t plain_flags[MAP_HEIGHT][FLAG_WORDS];

/* Where row y of the checked map is to be written before post_process_row asks for it: rows 0 to
 * MAP_HEIGHT - 1 in turn, half a window and one ahead of the rows that come out. */
uint8_t* checked_row(int y);

/* Writes row `y` of the final map, for y = 0 to MAP_HEIGHT - 1 in turn. Half a window of rows below
 * it must be in checked_row. */
void post_process_row(int y, uint8_t* disparities);

#endif
