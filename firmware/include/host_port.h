/* The host port: frames in; maps, console and exit out. The one device here that a BF561 does not
 * have. It stands for the cameras and for the link to a host. */
#ifndef FINBACK_HOST_PORT_H
#define FINBACK_HOST_PORT_H

#include <stdint.h>

#define HOST_PORT_BASE 0xFFC0F000u

struct host_port_registers {
  uint32_t frames_left;        /* read: pairs that can still be grabbed */
  uint32_t frame_left_address; /* where the next pair of 640x480 luma images goes */
  uint32_t frame_right_address;
  uint32_t frame_grab; /* write 1: fill both */
  uint32_t map_address;
  uint32_t map_size;     /* width | height << 16 */
  uint32_t map_publish;  /* write the frame's number: the host copies the map */
  uint32_t console;      /* write one character */
  uint32_t exit;         /* write the status: the machine stops */
  uint32_t frame_number; /* read: number of the pair grabbed last */
};

#define HOST_PORT ((volatile struct host_port_registers*)HOST_PORT_BASE)

/* How many pairs can still be grabbed. */
unsigned host_frames_left(void);

/* Fills both buffers with the next pair of 640x480 luma images and returns its number. */
unsigned host_grab_frame(uint8_t* left, uint8_t* right);

/* Hands over a map of one byte a pixel; the buffer is free again on return. */
void host_publish_map(const uint8_t* map, unsigned width, unsigned height, unsigned frame_number);

void host_print(const char* text);

/* Stops the whole machine. */
_Noreturn void host_exit(unsigned status);

#endif
