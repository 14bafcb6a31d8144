/* Different bits are counted by the processor's instruction for that, ONES. */
#include <limits.h>
#include <string.h>

#include "../common/lab.h"

/* The first WINDOW rows displace none: what leaves is this, in which the views differ nowhere. */
const uint8_t zero_row[RIGHT_MARGIN + MAP_WIDTH];
uint16_t scores[COLUMN_COUNT][DISPARITY_COUNT];
uint16_t update[DISPARITY_COUNT]; /* what the row changes in the window at hand */

int8_t column_changes[WINDOW][DISPARITY_COUNT]; /* those in the window at hand */

/* The row that enters the windows and the one that leaves them. */
struct rows {
  const uint8_t* left;
  const uint8_t* right;
  const uint8_t* left_leaving;
  const uint8_t* right_leaving;
};

/* What column x changes in the windows of disparity index k that it is in. */
static unsigned column_change(const struct rows* rows, int x, int k) {
  int opposite = x - DISPARITY_MIN - k;
  return (unsigned)__builtin_popcount(rows->left[x] ^ rows->right[opposite]) -
         (unsigned)__builtin_popcount(rows->left_leaving[x] ^ rows->right_leaving[opposite]);
}

static void update_columns(const struct rows* rows) {
  int begin = computed_columns.first - HALF_WINDOW;
  int oldest = WINDOW - 1; /* a column that has changed nothing */
  memset(update, 0, sizeof update);
  memset(column_changes[oldest], 0, sizeof column_changes[oldest]);
  for (int i = 0; i < WINDOW - 1; ++i) {
    for (int k = 0; k < DISPARITY_COUNT; ++k) {
      column_changes[i][k] = (int8_t)column_change(rows, begin + i, k);
      update[k] += column_changes[i][k];
    }
  }
  for (int i = 0; i < computed_columns.count; ++i) {
    for (int k = 0; k < DISPARITY_COUNT; ++k) {
      unsigned newest = column_change(rows, begin + WINDOW - 1 + i, k);
      update[k] += newest - column_changes[oldest][k];
      column_changes[oldest][k] = (int8_t)newest;
      scores[i][k] += update[k];
    }
    oldest = oldest + 1 < WINDOW ? oldest + 1 : 0;
  }
}

__attribute__((noinline)) void update_scores(int row) {
  struct rows rows = {left_census[row], right_census[row] + RIGHT_MARGIN, zero_row,
                      zero_row + RIGHT_MARGIN};
  if (row >= WINDOW) {
    rows.left_leaving = left_census[row - WINDOW];
    rows.right_leaving = right_census[row - WINDOW] + RIGHT_MARGIN;
  }
  update_columns(&rows);
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
