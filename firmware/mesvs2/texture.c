#include "texture.h"

#include "settings.h"
#include "variance.h"

_Static_assert(MAP_WIDTH % 32 == 0, "whole words of flags");

/* One bit for each variance of the row that is at most the threshold. */
__attribute__((noinline)) void flag_plain_windows(uint32_t* flags) {
  const uint32_t* variance = variance_row;
  uint32_t threshold = SCALED_VARIANCE(stereo_settings.texture_threshold);
  uint32_t inside = ~0u << (VARIANCE_WINDOW - 1); /* windows that begin inside the picture */
  for (int word = 0; word < FLAG_WORDS; ++word) {
    uint32_t bits = 0;
    for (int x = 0; x < 32; ++x) {
      bits = bits >> 1 | (uint32_t)(*variance++ <= threshold) << 31;
    }
    *flags++ = bits & inside;
    inside = ~0u;
  }
}

void texture_start(void) { variance_start(); }

void texture_enter_row(int y, const uint8_t* entering, const uint8_t* leaving, uint32_t* flags) {
  variance_enter_row(entering, leaving);
  if (y >= VARIANCE_WINDOW - 1) {
    flag_plain_windows(flags);
  }
}
