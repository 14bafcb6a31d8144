/* Where pairs of camera frames come from: the host port, at no time (frames_host.c), or the cameras
 * on the parallel ports (frames_cameras.c). A firmware links one of the two. */
#ifndef MESVS2_FRAMES_H
#define MESVS2_FRAMES_H

#include <stdint.h>

struct frame_pair {
  const uint8_t* left; /* CAMERA_WIDTH x CAMERA_HEIGHT greys in L3 */
  const uint8_t* right;
  unsigned number; /* as the host is told with the map */
};

/* Begins; interrupts are not enabled yet. */
void frames_start(void);

/* Waits for the next pair and lends it. Returns 0 when there is none. */
int acquire_frame(struct frame_pair* pair);

/* Gives the pair back, which nobody reads any more: its buffers are filled again. */
void release_frame(void);

/* Behind the last frame. */
void frames_end(void);

#endif
