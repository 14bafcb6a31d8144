#include "shared_buffers.h"

#include "pipeline.h"

/* Aligned so that DMA can move them in 32-bit elements. */
_Alignas(4) uint8_t hand_over_left[SLOT_COUNT][MAP_PIXELS];
_Alignas(4) uint8_t hand_over_right[SLOT_COUNT][MAP_PIXELS];
uint32_t hand_over_frame[SLOT_COUNT];
struct pipeline pipeline;

_Alignas(4) uint8_t disparity_map[MAP_PIXELS];
