/* Brings the rectification tables past a core: bands of rows from L3 to L1 and rectified bands from
 * L1 to L2 by DMA, beside the computing. */
#ifndef MESVS2_RECTIFY_STREAM_H
#define MESVS2_RECTIFY_STREAM_H

#include <stdint.h>

/* Fills the tables in L3: from flash, where there are some for pictures of this size, else with the
 * identity. */
void rectify_start(void);

/* Rectifies a pair of pictures in L1 into two in L2 or L3, all aligned to 4 bytes. Returns when
 * all is there. */
void rectify_pictures(const uint8_t* left, const uint8_t* right, uint8_t* rectified_left,
                      uint8_t* rectified_right);

#endif
