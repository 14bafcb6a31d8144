/* Brings the rectification tables past core A: bands of rows from L3 to L1 and, of the rectified
 * rows, codes from L1 to L2 by DMA, beside the computing. */
#ifndef MESVS2_RECTIFY_STREAM_H
#define MESVS2_RECTIFY_STREAM_H

#include <stdint.h>

#include "texture.h"

/* Fills the tables in L3: from flash, where there are some for pictures of this size, else with the
 * identity. */
void rectify_start(void);

/* Rectifies a pair of pictures in L1 and makes of them what core B works on, in L2 or L3: codes,
 * all aligned to 4 bytes, and flags of the left picture. Returns when all is there. */
void prepare_pictures(const uint8_t* left, const uint8_t* right, uint8_t* left_codes,
                      uint8_t* right_codes, uint32_t (*plain)[FLAG_WORDS]);

#endif
