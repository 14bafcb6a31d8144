/* Left-right consistency check, from the winners of both views that shd_select_row left:
 * no second pass over the scores. */
#ifndef MESVS2_LRC_H
#define MESVS2_LRC_H

#include <stdint.h>

/* Writes MAP_WIDTH disparities: a left pixel's disparity d where the right pixel x - d has chosen
 * the same one, stereo_settings.lrc_threshold more or less; else 0, as where nothing is computed.
 */
void lrc_check_row(uint8_t* disparities);

#endif
