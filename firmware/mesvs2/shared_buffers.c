#include "shared_buffers.h"

#include "pipeline.h"
#include "settings.h"

/* Aligned so that DMA can move them in 32-bit elements. */
_Alignas(4) uint8_t hand_over_left[SLOT_COUNT][MAP_PIXELS];
_Alignas(4) uint8_t hand_over_right[SLOT_COUNT][MAP_PIXELS];
uint32_t hand_over_plain[SLOT_COUNT][MAP_HEIGHT][FLAG_WORDS];
uint32_t hand_over_frame[SLOT_COUNT];
struct pipeline pipeline;
struct settings stereo_settings = {WINDOW,        DISPARITY_MIN,     DISPARITY_MAX,
                                   LRC_THRESHOLD, TEXTURE_THRESHOLD, DISPARITY_THRESHOLD};

_Alignas(4) uint8_t disparity_map[MAP_PIXELS];
