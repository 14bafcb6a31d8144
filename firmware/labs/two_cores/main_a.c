/* The left part of the map, and the frames. The parts overlap by one column in the computing, since
 * kernels want an odd number of columns; what a window or a disparity reaches is fetched by both.
 */
#include <bf561.h>
#include <core_interrupt.h>
#include <events.h>
#include <host_port.h>

#include "../common/lab.h"
#include "signals.h"

const struct columns left_columns = {0, 93};
const struct columns right_columns = {0, 88};
const struct columns computed_columns = {FIRST_COLUMN, 73};
const struct columns stored_columns = {0, 84};

int main(void) {
  unsigned frames = 0;

  transfer_start(CORE_A);
  core_interrupt_start(CORE_A);
  events_enable();
  SICA_SYSCR &= ~COREB_SRAM_INIT; /* core B starts */
  while (host_frames_left() != 0) {
    unsigned frame = host_grab_frame(vga_left, vga_right);
    frames_ready = ++frames;
    core_interrupt_raise(CORE_B);
    process_frame();
    WAIT_UNTIL(frames_matched == frames);
    host_publish_map(disparity_map, MAP_WIDTH, MAP_HEIGHT, frame);
  }
  return 0;
}
