/* By what the cores tell each other how far they are. */
#ifndef LABS_SIGNALS_H
#define LABS_SIGNALS_H

#include <stdint.h>

extern volatile uint32_t frames_ready; /* written by core A: frames in the camera buffers so far */
extern volatile uint32_t frames_matched; /* written by core B: of these, with its part of the map */

#endif
