/* Sample variance over square windows by recursion: columns of the window's height go down with
 * the rows (vertical), the window's sum goes along them (horizontal), and what leaves it on the
 * left is still there, VARIANCE_WINDOW columns back (modular). A pixel costs the same for every
 * window. One image at a time: texture and post-processing take turns. */
#ifndef MESVS2_VARIANCE_H
#define MESVS2_VARIANCE_H

#include <stdint.h>

#include "stereo_config.h"

#define HALF_VARIANCE_WINDOW (VARIANCE_WINDOW / 2)
#define VARIANCE_PIXELS (VARIANCE_WINDOW * VARIANCE_WINDOW)

/* A variance v as whole number: n^2 (n^2 - 1) v = n^2 sum(g^2) - sum(g)^2, n^2 pixels. */
#define SCALED_VARIANCE(v) ((uint32_t)VARIANCE_PIXELS * (VARIANCE_PIXELS - 1) * (v))

extern const uint8_t variance_no_row[MAP_WIDTH]; /* leaves while the window is not complete */

/* Scaled variances of the row entered last, by the right column of their windows; valid from
 * column VARIANCE_WINDOW - 1 on, once VARIANCE_WINDOW rows have entered. */
extern uint32_t variance_row[MAP_WIDTH];

/* Begins an image. */
void variance_start(void);

/* Moves all windows down by one row: `entering` comes below, `leaving` goes above. */
void variance_enter_row(const uint8_t* entering, const uint8_t* leaving);

#endif
