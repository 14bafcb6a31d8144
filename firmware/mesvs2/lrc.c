#include "lrc.h"

#include <string.h>

#include "settings.h"
#include "shd.h"

__attribute__((noinline)) void lrc_check_row(uint8_t* disparities) {
  const uint8_t* left = left_winners + FIRST_COLUMN;
  const uint8_t* nearest_right = right_winners + FIRST_COLUMN - DISPARITY_MIN;
  uint8_t* disparity = disparities + FIRST_COLUMN;
  int threshold = (int)stereo_settings.lrc_threshold;

  memset(disparities, 0, MAP_WIDTH);
  for (int i = 0; i < COLUMN_COUNT; ++i) {
    int index = *left++;
    int difference = nearest_right[-index] - index;
    if (difference >= -threshold && difference <= threshold) {
      *disparity = (uint8_t)(DISPARITY_MIN + index);
    }
    ++disparity;
    ++nearest_right;
  }
}
