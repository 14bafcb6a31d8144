/* A firmware of one's own: core A alone grabs each pair, and publishes how much the left image
 * changes from pixel to pixel. */
#include <host_port.h>
#include <stdint.h>

#define CAMERA_WIDTH 640
#define CAMERA_HEIGHT 480
#define STEP 4
#define WIDTH (CAMERA_WIDTH / STEP)
#define HEIGHT (CAMERA_HEIGHT / STEP)

uint8_t left_image[CAMERA_WIDTH * CAMERA_HEIGHT];
uint8_t right_image[CAMERA_WIDTH * CAMERA_HEIGHT];
uint8_t row[WIDTH];
uint8_t map[WIDTH * HEIGHT];

/* One row of the image, every STEP-th pixel of it, into L1. */
__attribute__((noinline)) void fetch_row(int y) {
  const uint8_t* pixel = left_image + y * STEP * CAMERA_WIDTH;
  for (int x = 0; x < WIDTH; x++, pixel += STEP) {
    row[x] = *pixel;
  }
}

__attribute__((noinline)) void find_edges(int y) {
  uint8_t* edge = map + y * WIDTH;
  edge[0] = 0;
  for (int x = 1; x < WIDTH; x++) {
    const int difference = row[x] - row[x - 1];
    edge[x] = (uint8_t)(difference < 0 ? -difference : difference);
  }
}

int main(void) {
  while (host_frames_left() > 0) {
    const unsigned frame = host_grab_frame(left_image, right_image);
    for (int y = 0; y < HEIGHT; y++) {
      fetch_row(y);
      find_edges(y);
    }
    host_publish_map(map, WIDTH, HEIGHT, frame);
  }
  return 0;
}
