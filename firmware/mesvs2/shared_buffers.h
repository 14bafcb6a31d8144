/* What both cores see: the slots in which core A hands the codes of pairs to core B, and the map.
 *
 * Core A fills the slots in turn, core B empties them in turn; how many are full counts pipeline.h.
 * Core A interrupts core B when it has filled a slot, core B interrupts core A when it has
 * published a map. Two slots let core A work on frame n + 1 while core B works on frame n. */
#ifndef MESVS2_SHARED_BUFFERS_H
#define MESVS2_SHARED_BUFFERS_H

#include <stdint.h>

#include "stereo_config.h"
#include "texture.h"

#define SLOT_COUNT 2

extern uint8_t hand_over_left[SLOT_COUNT][MAP_PIXELS]; /* codes */
extern uint8_t hand_over_right[SLOT_COUNT][MAP_PIXELS];
extern uint32_t hand_over_plain[SLOT_COUNT][MAP_HEIGHT][FLAG_WORDS]; /* flags of the left picture */
extern uint32_t hand_over_frame[SLOT_COUNT]; /* number of the frame in a slot */

extern uint8_t disparity_map[MAP_PIXELS];

#endif
