#include <finback/blackfin.h>
#include <host_port.h>

unsigned host_frames_left(void) { return HOST_PORT->frames_left; }

unsigned host_grab_frame(uint8_t* left, uint8_t* right) {
  HOST_PORT->frame_left_address = (uint32_t)left;
  HOST_PORT->frame_right_address = (uint32_t)right;
  HOST_PORT->frame_grab = 1;
  return HOST_PORT->frame_number;
}

void host_publish_map(const uint8_t* map, unsigned width, unsigned height, unsigned frame_number) {
  __builtin_bfin_ssync(); /* the core's writes to the map have arrived */
  HOST_PORT->map_address = (uint32_t)map;
  HOST_PORT->map_size = width | height << 16;
  HOST_PORT->map_publish = frame_number;
}

void host_print(const char* text) {
  while (*text != 0) {
    HOST_PORT->console = (uint8_t)*text++;
  }
}

_Noreturn void host_exit(unsigned status) {
  HOST_PORT->exit = status;
  for (;;) {
    __builtin_bfin_idle();
  }
}
