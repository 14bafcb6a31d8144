/* Sums are kept: a window that moves down by one row gains a row of differences and loses one. */
#include <limits.h>
#include <string.h>

#include "../common/lab.h"

#define ONES_2(n) (n), (n) + 1, (n) + 1, (n) + 2
#define ONES_4(n) ONES_2(n), ONES_2((n) + 1), ONES_2((n) + 1), ONES_2((n) + 2)
#define ONES_6(n) ONES_4(n), ONES_4((n) + 1), ONES_4((n) + 1), ONES_4((n) + 2)
const uint8_t ones[256] = {ONES_6(0), ONES_6(1), ONES_6(1), ONES_6(2)};

/* The first WINDOW rows displace none: what leaves is this, in which the views differ nowhere. */
const uint8_t zero_row[RIGHT_MARGIN + MAP_WIDTH];
uint16_t scores[COLUMN_COUNT][DISPARITY_COUNT];

static unsigned row_sum(const uint8_t* left, const uint8_t* right) {
  unsigned sum = 0;
  for (int i = 0; i < WINDOW; ++i) {
    sum += ones[left[i] ^ right[i]];
  }
  return sum;
}

__attribute__((noinline)) void update_scores(int row) {
  const uint8_t* left = left_census[row];
  const uint8_t* right = right_census[row] + RIGHT_MARGIN;
  const uint8_t* left_leaving = row < WINDOW ? zero_row : left_census[row - WINDOW];
  const uint8_t* right_leaving =
      (row < WINDOW ? zero_row : right_census[row - WINDOW]) + RIGHT_MARGIN;
  for (int i = 0; i < computed_columns.count; ++i) {
    int begin = computed_columns.first + i - HALF_WINDOW;
    for (int k = 0; k < DISPARITY_COUNT && begin - DISPARITY_MIN - k >= 0; ++k) {
      int opposite = begin - DISPARITY_MIN - k;
      scores[i][k] += row_sum(left + begin, right + opposite) -
                      row_sum(left_leaving + begin, right_leaving + opposite);
    }
  }
}

__attribute__((noinline)) void select_row(uint8_t* disparities) {
  for (int i = 0; i < computed_columns.count; ++i) {
    int x = computed_columns.first + i;
    unsigned best = UINT_MAX;
    for (int k = 0; k < DISPARITY_COUNT && x - HALF_WINDOW - DISPARITY_MIN - k >= 0; ++k) {
      if (scores[i][k] < best) {
        best = scores[i][k];
        disparities[x] = (uint8_t)(DISPARITY_MIN + k);
      }
    }
  }
}

void match_row(int row, uint8_t* disparities) {
  if (row == 0) {
    memset(scores, 0, sizeof scores);
  }
  update_scores(row);
  if (row >= WINDOW - 1) {
    select_row(disparities);
  }
}
