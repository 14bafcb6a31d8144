/* Captures frames of both cameras by their parallel ports and publishes what came: the left view,
 * then the right one, as maps of the frame. Ends with what the ports reported. */
#include <camera.h>
#include <events.h>
#include <host_port.h>

#define WIDTH 640u
#define HEIGHT 480u

_Alignas(4) uint8_t left_luma[WIDTH * HEIGHT];
_Alignas(4) uint8_t right_luma[WIDTH * HEIGHT];

int main(void) {
  unsigned frames = host_frames_left();

  camera_start(CORE_A);
  events_enable();
  for (unsigned frame = 0; frame < frames; ++frame) {
    camera_capture(0, left_luma, WIDTH, HEIGHT);
    camera_capture(1, right_luma, WIDTH, HEIGHT);
    camera_wait();
    host_publish_map(left_luma, WIDTH, HEIGHT, frame);
    host_publish_map(right_luma, WIDTH, HEIGHT, frame);
  }
  host_exit(camera_errors(0) | camera_errors(1));
}
