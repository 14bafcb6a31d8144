/* Every window is summed anew, pixel by pixel; a table counts the different bits. */
#include <limits.h>

#include "../common/lab.h"

#define ONES_2(n) (n), (n) + 1, (n) + 1, (n) + 2
#define ONES_4(n) ONES_2(n), ONES_2((n) + 1), ONES_2((n) + 1), ONES_2((n) + 2)
#define ONES_6(n) ONES_4(n), ONES_4((n) + 1), ONES_4((n) + 1), ONES_4((n) + 2)
const uint8_t ones[256] = {ONES_6(0), ONES_6(1), ONES_6(1), ONES_6(2)};

static unsigned window_sum(int x, int y, int d) {
  unsigned sum = 0;
  for (int row = y - HALF_WINDOW; row <= y + HALF_WINDOW; ++row) {
    const uint8_t* left = left_census[row] + x - HALF_WINDOW;
    const uint8_t* right = right_census[row] + RIGHT_MARGIN + x - d - HALF_WINDOW;
    for (int i = 0; i < WINDOW; ++i) {
      sum += ones[left[i] ^ right[i]];
    }
  }
  return sum;
}

__attribute__((noinline)) void match_row(int row, uint8_t* disparities) {
  int end = computed_columns.first + computed_columns.count;
  if (row < WINDOW - 1) {
    return;
  }
  for (int x = computed_columns.first; x < end; ++x) {
    unsigned best = UINT_MAX;
    for (int d = DISPARITY_MIN; d <= DISPARITY_MAX && d <= x - HALF_WINDOW; ++d) {
      unsigned sum = window_sum(x, row - HALF_WINDOW, d);
      if (sum < best) {
        best = sum;
        disparities[x] = (uint8_t)d;
      }
    }
  }
}
