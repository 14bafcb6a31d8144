/* MESVS, core B: from codes to disparity maps. */
#include <core_interrupt.h>
#include <events.h>
#include <host_port.h>
#include <memory_dma.h>

#include "geometry.h"
#include "matching.h"
#include "pipeline.h"
#include "postprocess.h"
#include "shared_buffers.h"
#include "stereo_config.h"
#include "variance.h"

/* The map leaves L1 in bands: one is on its way while the next is computed. */
#define BAND_ROWS 10
#define BAND_PIXELS (BAND_ROWS * MAP_WIDTH)
#define BAND_COUNT (MAP_HEIGHT / BAND_ROWS)
_Static_assert(BAND_COUNT* BAND_ROWS == MAP_HEIGHT, "bands fill the map");

_Alignas(4) uint8_t left_codes[MAP_PIXELS];
_Alignas(4) uint8_t right_codes[MAP_PIXELS];
_Alignas(4) uint8_t disparity_bands[2][BAND_PIXELS];

/* Brings the pair of a slot into L1, gives the slot back and returns the frame's number. */
__attribute__((noinline)) unsigned receive_pair(int slot) {
  unsigned frame_number = hand_over_frame[slot];
  memory_dma_copy(left_codes, hand_over_left[slot], MAP_PIXELS);
  memory_dma_copy(right_codes, hand_over_right[slot], MAP_PIXELS);
  memory_dma_copy(plain_flags, hand_over_plain[slot], sizeof plain_flags);
  memory_dma_wait();
  pipeline_slot_emptied();
  return frame_number;
}

__attribute__((noinline)) void wait_for_full_slot(void) { WAIT_UNTIL(pipeline_full_slots() != 0); }

/* Matches rows first to end - 1 and checks their views against each other. */
__attribute__((noinline)) void match_rows(int first, int end) {
  for (int y = first; y < end; ++y) {
    match_row(left_codes, right_codes, y, checked_row(y));
  }
}

/* Post-processing sees half a window below a row: matching is so far ahead. */
__attribute__((noinline)) void map_band(int band) {
  uint8_t* row = disparity_bands[band % 2];
  int y = band * BAND_ROWS;
  if (band == 0) {
    match_rows(0, HALF_VARIANCE_WINDOW);
  }
  for (int end = y + BAND_ROWS; y < end; ++y) {
    int lowest = y + HALF_VARIANCE_WINDOW;
    if (lowest < MAP_HEIGHT) {
      match_rows(lowest, lowest + 1);
    }
    post_process_row(y, row);
    row += MAP_WIDTH;
  }
}

/* Begins to send a band to its place in the map; waits until the band before it has gone, so that
 * its buffer is free again. */
__attribute__((noinline)) void output_map_band(int band) {
  memory_dma_copy(disparity_map + band * BAND_PIXELS, disparity_bands[band % 2], BAND_PIXELS);
}

__attribute__((noinline)) void publish_map(unsigned frame_number) {
  memory_dma_wait();
  host_publish_map(disparity_map, MAP_WIDTH, MAP_HEIGHT, frame_number);
  pipeline_map_published();
  core_interrupt_raise(CORE_A);
}

int main(void) {
  int slot = 0;

  geometry_start();
  memory_dma_start(CORE_B);
  core_interrupt_start(CORE_B);
  events_enable();
  for (;;) {
    unsigned frame_number;
    wait_for_full_slot();
    frame_number = receive_pair(slot);
    for (int band = 0; band < BAND_COUNT; ++band) {
      map_band(band);
      output_map_band(band);
    }
    publish_map(frame_number);
    slot = (slot + 1) % SLOT_COUNT;
  }
}
