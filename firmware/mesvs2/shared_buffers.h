/* What both cores see: the slots in which core A hands rectified pairs to core B, and the map.
 *
 * A slot is empty or full. Only core A fills an empty one, only core B empties a full one. Core A
 * interrupts core B when it has filled a slot, core B interrupts core A when it has published a
 * map. Two slots let core A work on frame n + 1 while core B works on frame n. */
#ifndef MESVS2_SHARED_BUFFERS_H
#define MESVS2_SHARED_BUFFERS_H

#include <stdint.h>

#include "stereo_config.h"

#define SLOT_COUNT 2

extern uint8_t hand_over_left[SLOT_COUNT][MAP_PIXELS];
extern uint8_t hand_over_right[SLOT_COUNT][MAP_PIXELS];
extern volatile uint32_t hand_over_frame[SLOT_COUNT]; /* number of the frame in a slot */
extern volatile uint32_t hand_over_full[SLOT_COUNT];

extern uint8_t disparity_map[MAP_PIXELS];
extern volatile uint32_t maps_published; /* since the start */

#endif
