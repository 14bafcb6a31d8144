/* What MESVS-II computes, and MESVS-I where -D says so: sizes, window, disparity range, thresholds,
 * what is compared and how. A left pixel x is seen in the right image at x - d. Each guarded number
 * can be given to the compiler; all files of a firmware must agree. */
#ifndef MESVS2_STEREO_CONFIG_H
#define MESVS2_STEREO_CONFIG_H

#include <stdint.h>

/* By what pixels are compared: by which neighbours are darker, by how many are, by themselves. */
#define CODE_CENSUS 1 /* MESVS-II */
#define CODE_RANK 2   /* MESVS-I */
#define CODE_GREY 3
#ifndef CODE
#define CODE CODE_CENSUS
#endif
/* Of what a window's sum is made: different bits, differences, their squares. */
#define MEASURE_SHD 1 /* MESVS-II */
#define MEASURE_SAD 2 /* MESVS-I */
#define MEASURE_SSD 3
#ifndef MEASURE
#define MEASURE MEASURE_SHD
#endif

/* The rank r as a byte whose r lowest bits are set: two such bytes differ in as many bits as the
 * ranks in value, so that absolute differences are Hamming distances, too. */
#define MEASURE_BY_BITS (MEASURE == MEASURE_SHD || (CODE == CODE_RANK && MEASURE == MEASURE_SAD))
#if CODE == CODE_RANK && MEASURE == MEASURE_SHD
#error "ranks are numbers: compare them by MEASURE_SAD or MEASURE_SSD"
#endif

#ifndef WINDOW
#define WINDOW 15 /* largest side of the matching window, odd */
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
#ifndef SUBSAMPLING
#define SUBSAMPLING 4 /* every 4th pixel of every 4th row */
#endif
#define MAP_WIDTH (CAMERA_WIDTH / SUBSAMPLING)
#define MAP_HEIGHT (CAMERA_HEIGHT / SUBSAMPLING)
#define MAP_PIXELS (MAP_WIDTH * MAP_HEIGHT)

/* There is memory for the window and so many disparities as said above. Settings may ask for
 * smaller windows, fewer disparities and others (geometry.h): as far as this, so that columns are
 * left. */
#define DISPARITY_COUNT (DISPARITY_MAX - DISPARITY_MIN + 1)
#define HIGHEST_DISPARITY_MIN (DISPARITY_MIN > MAP_WIDTH / 4 ? DISPARITY_MIN : MAP_WIDTH / 4)
/* Columns that have a candidate, at most: with a window of 1 and disparity 1. */
#define MOST_COLUMNS (MAP_WIDTH - 1)

#endif
