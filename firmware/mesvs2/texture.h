/* Where the left picture is plain: for equation 19 a bit for each window whose variance is at most
 * the threshold, at its lower right pixel. */
#ifndef MESVS2_TEXTURE_H
#define MESVS2_TEXTURE_H

#include <stdint.h>

#include "stereo_config.h"

#define FLAG_WORDS (MAP_WIDTH / 32)

/* Begins a picture. */
void texture_start(void);

/* Takes in row y; rows in turn from 0. `leaving` is VARIANCE_WINDOW rows above, or variance_no_row.
 * Writes FLAG_WORDS words of flags, once VARIANCE_WINDOW rows are in. */
void texture_enter_row(int y, const uint8_t* entering, const uint8_t* leaving, uint32_t* flags);

#endif
