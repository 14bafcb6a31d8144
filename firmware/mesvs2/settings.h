/* Numbers that need no compiling: lines such as "texture_threshold 140" in flash, read at the
 * start (finback run --flash settings.txt@0x20100000). What is not named keeps what
 * stereo_config.h says. */
#ifndef MESVS2_SETTINGS_H
#define MESVS2_SETTINGS_H

#include <stdint.h>

#define SETTINGS_ADDRESS 0x20100000u

struct settings {
  uint32_t window;              /* odd, 3 to WINDOW: side of the matching window */
  uint32_t disparity_min;       /* 1 to HIGHEST_DISPARITY_MIN */
  uint32_t disparity_max;       /* disparity_min + 1 to disparity_min + DISPARITY_COUNT - 1 */
  uint32_t lrc_threshold;       /* 0 to 255: largest difference of the two views' disparities */
  uint32_t texture_threshold;   /* 0 to 65025, squared grey levels: equation 19's T_L */
  uint32_t disparity_threshold; /* 0 to 65025, squared pixels: T_H; 65025: no post-processing */
};
extern struct settings stereo_settings; /* of both cores; core A reads it before core B starts */

/* Reads lines of a name, a space and a number, up to the first byte that is no text: flash without
 * settings has none. Returns 0, or the number of the first line that is wrong. */
int settings_read(const char* text);

/* Whether there are at least 2 disparities, and no more than there is memory for. */
int settings_range_fits(void);

#endif
