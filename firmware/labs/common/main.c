/* One core does everything. */
#include <events.h>
#include <host_port.h>

#include "lab.h"

const struct columns left_columns = {0, MAP_WIDTH};
const struct columns right_columns = {0, MAP_WIDTH};
const struct columns computed_columns = {FIRST_COLUMN, COLUMN_COUNT};
const struct columns stored_columns = {0, MAP_WIDTH};

int main(void) {
  transfer_start(CORE_A);
  events_enable();
  while (host_frames_left() != 0) {
    unsigned frame = host_grab_frame(vga_left, vga_right);
    process_frame();
    host_publish_map(disparity_map, MAP_WIDTH, MAP_HEIGHT, frame);
  }
  return 0;
}
