/* What MESVS-II computes: sizes, window, disparity range. A left pixel x is seen in the right image
 * at x - d. The guards let tests build the kernels for other windows and ranges. */
#ifndef MESVS2_STEREO_CONFIG_H
#define MESVS2_STEREO_CONFIG_H

#include <stdint.h>

#ifndef WINDOW
#define WINDOW 15 /* side of the matching window, odd */
#endif
#ifndef DISPARITY_MIN
#define DISPARITY_MIN 5 /* at least 1: 0 marks invalid pixels */
#endif
#ifndef DISPARITY_MAX
#define DISPARITY_MAX 35
#endif

#ifndef LRC_THRESHOLD
#define LRC_THRESHOLD 1 /* largest difference of the two views' disparities */
#endif

/* Equation 19: a disparity is given up where the picture's variance is at most TEXTURE_THRESHOLD
 * (squared grey levels) and that of the disparities at least DISPARITY_THRESHOLD (squared pixels),
 * both over the same window. */
#ifndef VARIANCE_WINDOW
#define VARIANCE_WINDOW 9 /* side, odd, 3 to 15 */
#endif
#ifndef TEXTURE_THRESHOLD
#define TEXTURE_THRESHOLD 135
#endif
#ifndef DISPARITY_THRESHOLD
#define DISPARITY_THRESHOLD 17
#endif

#define CAMERA_WIDTH 640
#define CAMERA_HEIGHT 480
#define SUBSAMPLING 4 /* every 4th pixel of every 4th row */
#define MAP_WIDTH (CAMERA_WIDTH / SUBSAMPLING)
#define MAP_HEIGHT (CAMERA_HEIGHT / SUBSAMPLING)
#define MAP_PIXELS (MAP_WIDTH * MAP_HEIGHT)

#define HALF_WINDOW (WINDOW / 2)
#define DISPARITY_COUNT (DISPARITY_MAX - DISPARITY_MIN + 1)

/* Left columns that have at least one candidate: both windows wholly inside the images. */
#define FIRST_COLUMN (DISPARITY_MIN + HALF_WINDOW)
#define LAST_COLUMN (MAP_WIDTH - 1 - HALF_WINDOW)
#define COLUMN_COUNT (LAST_COLUMN - FIRST_COLUMN + 1)

#endif
