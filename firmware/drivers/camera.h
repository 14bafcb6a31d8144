/* The cameras on the parallel ports: camera 0, left, on PPI0, camera 1, right, on PPI1. A frame's
 * luma goes to memory by DMA; the chroma is skipped. */
#ifndef FINBACK_CAMERA_H
#define FINBACK_CAMERA_H

#include <core.h>
#include <stdint.h>

/* Takes both cameras for the calling core and attaches their interrupts. */
void camera_start(enum core core);

/* Begins to capture the next whole frame of `camera`, width * height bytes; the buffer is aligned
 * to 2 bytes, the size is the camera's. */
void camera_capture(unsigned camera, uint8_t* luma, unsigned width, unsigned height);

/* Has `ended` called, in the interrupt, when a capture of a camera is complete; it may begin the
 * next one. To be called before the first capture. */
void camera_listen(void (*ended)(unsigned camera));

/* Sleeps until all captures that were begun are complete. */
void camera_wait(void);

/* What PPI_STATUS said since the last call: 0 when all went well. */
unsigned camera_errors(unsigned camera);

#endif
