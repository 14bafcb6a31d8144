/* The codes by which pixels are compared, in the place of their greys. */
#ifndef MESVS2_TRANSFORM_H
#define MESVS2_TRANSFORM_H

#include <stdint.h>

#include "stereo_config.h"

/* Transforms an image of MAP_WIDTH x MAP_HEIGHT in place. Border pixels become 0. */
void transform_image(uint8_t* image);

#endif
