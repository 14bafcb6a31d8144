/* What the settings make of the matching: which window and disparities, and which columns have
 * candidates for them. What is computed does not depend on how: firmware/README.md, "Changing it".
 */
#ifndef MESVS2_GEOMETRY_H
#define MESVS2_GEOMETRY_H

#include "stereo_config.h"

struct geometry {
  int window; /* side, odd, at most WINDOW */
  int half_window;
  int disparity_min;
  int disparity_count; /* at most DISPARITY_COUNT */
  int first_column;    /* left columns that have at least one candidate: both windows inside */
  int columns;         /* so many, at most MOST_COLUMNS */
};
extern struct geometry geometry;

/* Takes over the settings, before the first frame. */
void geometry_start(void);

#endif
