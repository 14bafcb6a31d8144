/* The right part of the map. */
#include <core_interrupt.h>
#include <events.h>

#include "../common/lab.h"
#include "signals.h"

const struct columns left_columns = {76, 84};
const struct columns right_columns = {40, 116};
const struct columns computed_columns = {84, 69};
const struct columns stored_columns = {84, 76};

int main(void) {
  transfer_start(CORE_B);
  core_interrupt_start(CORE_B);
  events_enable();
  for (unsigned frames = 1;; ++frames) {
    WAIT_UNTIL(frames_ready == frames);
    process_frame();
    frames_matched = frames;
    core_interrupt_raise(CORE_A);
  }
}
