#include "lrc.h"

#include <string.h>

#include "geometry.h"
#include "settings.h"
#include "shd.h"

__attribute__((noinline)) void lrc_check_row(uint8_t* disparities) {
  const uint8_t* left = left_winners + geometry.first_column;
  const uint8_t* nearest_right = right_winners + geometry.half_window;
  uint8_t* disparity = disparities + geometry.first_column;
  unsigned threshold = stereo_settings.lrc_threshold;
  int least = geometry.disparity_min;
  int columns = geometry.columns;

  memset(disparities, 0, MAP_WIDTH);
  for (int i = 0; i < columns; ++i) {
    int index = *left++;
    unsigned apart = (unsigned)(nearest_right[-index] - index) + threshold;
    *disparity++ = (uint8_t)(apart <= 2 * threshold ? least + index : 0);
    ++nearest_right;
  }
}
