/* What a row changes is kept, too: moving right, it gains a column's change and loses another's. */
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
uint16_t update[DISPARITY_COUNT]; /* what the row changes in the window at hand */

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
  return (unsigned)ones[rows->left[x] ^ rows->right[opposite]] -
         ones[rows->left_leaving[x] ^ rows->right_leaving[opposite]];
}

static void update_columns(const struct rows* rows) {
  int first = computed_columns.first;
  memset(update, 0, sizeof update);
  for (int x = first - HALF_WINDOW; x < first + HALF_WINDOW; ++x) {
    for (int k = 0; k < DISPARITY_COUNT; ++k) {
      update[k] += column_change(rows, x, k);
    }
  }
  for (int i = 0; i < computed_columns.count; ++i) {
    int x = first + i;
    for (int k = 0; k < DISPARITY_COUNT; ++k) {
      unsigned change = update[k] + column_change(rows, x + HALF_WINDOW, k);
      scores[i][k] += change;
      update[k] = change - column_change(rows, x - HALF_WINDOW, k);
    }
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
