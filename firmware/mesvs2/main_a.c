/* MESVS, core A: from camera frames to codes of rectified pairs of 160x120. */
#include <bf561.h>
#include <core_interrupt.h>
#include <events.h>
#include <host_port.h>
#include <memory_dma.h>

#include "frames.h"
#include "pipeline.h"
#include "rectify_stream.h"
#include "settings.h"
#include "shared_buffers.h"
#include "stereo_config.h"

_Alignas(4) uint8_t small_left[MAP_PIXELS];
_Alignas(4) uint8_t small_right[MAP_PIXELS];

/* Every 4th pixel of every 4th row, from L3 to L1, without the core's help. */
__attribute__((noinline)) void subsample_pair(const struct frame_pair* pair) {
  memory_dma_gather(small_left, pair->left, MAP_WIDTH, MAP_HEIGHT, SUBSAMPLING, CAMERA_WIDTH);
  memory_dma_gather(small_right, pair->right, MAP_WIDTH, MAP_HEIGHT, SUBSAMPLING, CAMERA_WIDTH);
  memory_dma_wait();
}

__attribute__((noinline)) void prepare_pair(int slot) {
  prepare_pictures(small_left, small_right, hand_over_left[slot], hand_over_right[slot],
                   hand_over_plain[slot]);
}

/* Until core B has begun with the pair handed over last: a frame that is grabbed earlier only grows
 * old. Two frames are then in the pipeline, and the slot after the last one is empty. */
__attribute__((noinline)) void wait_for_core_b(void) { WAIT_UNTIL(pipeline_pairs() < SLOT_COUNT); }

__attribute__((noinline)) void hand_over_pair(int slot, unsigned frame_number) {
  hand_over_frame[slot] = frame_number;
  pipeline_slot_filled();
  core_interrupt_raise(CORE_B);
}

static void read_settings(void) {
  int wrong = settings_read((const char*)SETTINGS_ADDRESS);
  char line[] = "settings in flash: line 1 is none; such as: texture_threshold 140\n";
  if (wrong != 0) {
    line[24] = (char)('0' + (wrong < 10 ? wrong : 9));
    host_print(line);
    host_exit(2);
  }
  if (!settings_range_fits()) {
    host_print(
        "settings in flash: from disparity_min to disparity_max must be 2 disparities or more, and "
        "no "
        "more than were built\n");
    host_exit(2);
  }
}

int main(void) {
  struct frame_pair pair;
  int slot = 0;

  read_settings();
  memory_dma_start(CORE_A);
  core_interrupt_start(CORE_A);
  frames_start();
  events_enable();
  rectify_start();
  SICA_SYSCR &= ~COREB_SRAM_INIT; /* core B starts */

  while (acquire_frame(&pair)) {
    subsample_pair(&pair);
    release_frame();
    prepare_pair(slot);
    hand_over_pair(slot, pair.number);
    slot = (slot + 1) % SLOT_COUNT;
    wait_for_core_b();
  }
  WAIT_UNTIL(pipeline_pairs() == 0);
  frames_end();
  return 0;
}
