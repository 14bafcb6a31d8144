/* Four bytes are compared at once: the column that enters the window and the one that leaves it,
 * each on the row that enters and on the one that leaves.
 *
 * A window's change is (entering row - leaving row) of the entering column less the same of the
 * leaving column. Where a difference counts with a minus, the left byte is inverted: 8 - h bits
 * differ then instead of h. One XOR and one ONES over the word give the change plus 16. So nothing
 * needs to be kept of columns until they leave. */
#include <string.h>

#include "../common/lab.h"
#include "kernels.h"

#define NO_CANDIDATE 0x4000 /* a score that never wins */

/* The first WINDOW rows displace none: what leaves is this, in which the views differ nowhere. */
const uint8_t zero_row[RIGHT_MARGIN + MAP_WIDTH];
_Alignas(4) uint16_t scores[COLUMN_COUNT * SLOTS];
_Alignas(4) uint16_t update[SLOTS]; /* what the row changes in the window at hand */
/* Of the columns before the first window is complete. */
_Alignas(4) uint16_t start_scores[(WINDOW - 1) * SLOTS];

/* Entering and leaving row, in the low halves; the high halves differ in 8 bits. */
uint32_t left_pairs[MAP_WIDTH];
uint32_t right_pairs[RIGHT_MARGIN + MAP_WIDTH];
/* In the high halves the column that leaves the window when this one enters. */
uint32_t left_words[MAP_WIDTH];
uint32_t right_words[RIGHT_MARGIN + MAP_WIDTH];

static void start_frame(void) {
  uint16_t* score = scores;
  for (int i = 0; i < computed_columns.count; ++i) {
    int candidates = computed_columns.first + i - FIRST_COLUMN + 1;
    for (int k = 0; k < SLOTS; ++k) {
      *score++ = k < candidates && k < DISPARITY_COUNT ? 0 : NO_CANDIDATE;
    }
  }
}

__attribute__((noinline)) void pack_left(const uint8_t* restrict entering,
                                         const uint8_t* restrict leaving) {
  int end = left_columns.first + left_columns.count;
  for (int x = left_columns.first; x < end; ++x) {
    left_pairs[x] = 0xFFFF00u ^ (unsigned)(entering[x] | leaving[x] << 8);
  }
  for (int x = left_columns.first + WINDOW; x < end; ++x) {
    left_words[x] = (left_pairs[x] & 0xFFFF) | ~left_pairs[x - WINDOW] << 16;
  }
}

/* The margin's pairs and words stay 0. */
__attribute__((noinline)) void pack_right(const uint8_t* restrict entering,
                                          const uint8_t* restrict leaving) {
  int begin = RIGHT_MARGIN + right_columns.first;
  for (int x = begin; x < begin + right_columns.count; ++x) {
    right_pairs[x] = (unsigned)(entering[x] | leaving[x] << 8);
  }
  for (int x = begin; x < begin + right_columns.count; ++x) {
    right_words[x] = right_pairs[x] | right_pairs[x - WINDOW] << 16;
  }
}

/* The first window's column sums; they are all that its score gains. */
__attribute__((noinline)) void start_row(void) {
  const uint32_t* left = left_pairs + computed_columns.first - HALF_WINDOW;
  const uint32_t* right =
      right_pairs + RIGHT_MARGIN + computed_columns.first - HALF_WINDOW - DISPARITY_MIN;
  memset(update, 0, sizeof update);
  update_row(start_scores, update, left, right, WINDOW - 1);
  for (int k = 0; k < SLOTS; ++k) {
    unsigned bits = (unsigned)__builtin_popcount(left[WINDOW - 1] ^ right[WINDOW - 1 - k]);
    update[k] = (uint16_t)(update[k] + bits - 16);
    scores[k] = (uint16_t)(scores[k] + update[k]);
  }
}

void match_row(int row, uint8_t* disparities) {
  int next = computed_columns.first + 1 + HALF_WINDOW; /* enters the second window */
  if (row == 0) {
    start_frame();
  }
  pack_left(left_census[row], row < WINDOW ? zero_row : left_census[row - WINDOW]);
  pack_right(right_census[row], row < WINDOW ? zero_row : right_census[row - WINDOW]);
  start_row();
  update_row(scores + SLOTS, update, left_words + next,
             right_words + RIGHT_MARGIN + next - DISPARITY_MIN, computed_columns.count - 1);
  if (row >= WINDOW - 1) {
    select_row(scores, disparities + computed_columns.first, computed_columns.count);
  }
}
