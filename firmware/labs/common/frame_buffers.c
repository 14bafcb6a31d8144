#include "lab.h"

_Alignas(4) uint8_t vga_left[CAMERA_WIDTH * CAMERA_HEIGHT];
_Alignas(4) uint8_t vga_right[CAMERA_WIDTH * CAMERA_HEIGHT];
_Alignas(4) uint8_t disparity_map[MAP_PIXELS];
