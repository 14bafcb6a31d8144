#include "lrc.h"

#include <string.h>

#include "settings.h"
#include "shd.h"

__attribute__((noinline)) void lrc_check_row(uint8_t* disparities) {
  const int32_t* left_key = left_keys + FIRST_COLUMN;
  const int32_t* right_key_of_nearest = right_keys + FIRST_COLUMN - DISPARITY_MIN;
  uint8_t* disparity = disparities + FIRST_COLUMN;
  int threshold = (int)settings.lrc_threshold;

  memset(disparities, 0, MAP_WIDTH);
  for (int i = 0; i < COLUMN_COUNT; ++i) {
    int index = *left_key++ & KEY_MASK;
    int opposite = right_key_of_nearest[-index] & KEY_MASK;
    int difference = opposite - index;
    if (difference >= -threshold && difference <= threshold) {
      *disparity = (uint8_t)(DISPARITY_MIN + index);
    }
    ++disparity;
    ++right_key_of_nearest;
  }
}
