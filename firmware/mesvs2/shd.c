#include "shd.h"

#include <string.h>

#include "geometry.h"

#if !SHD_PACKED

_Static_assert((uint64_t)WINDOW* WINDOW* MOST_DISTANCE < 1ull << (31 - KEY_BITS) &&
                   DISPARITY_COUNT <= 1 << KEY_BITS,
               "a score and a disparity make one key: take a smaller window or fewer disparities");

#if MEASURE_BY_BITS
/* The leaving code is kept inverted on the left: the XOR of two pairs then holds h of the entering
 * row and 8 - h of the leaving one, and a single count of ones gives their difference plus BIAS.
 * What leaves the window carries the same BIAS, so U does not see it. */
#define BIAS 8u
#define INVERTED 0xFF

static unsigned newest_of(unsigned left_pair, unsigned right_pair) {
  return (unsigned)__builtin_popcount(left_pair ^ right_pair);
}
#else
#define BIAS 0u
#define INVERTED 0

static unsigned distance(unsigned left, unsigned right) {
  unsigned difference = left < right ? right - left : left - right;
  return MEASURE == MEASURE_SSD ? difference * difference : difference;
}

/* What enters less what leaves, modulo 2^32: sums of scores are exact all the same. */
static unsigned newest_of(unsigned left_pair, unsigned right_pair) {
  return distance(left_pair & 0xFF, right_pair & 0xFF) - distance(left_pair >> 8, right_pair >> 8);
}
#endif

/* Right columns -PAIR_MARGIN..-1 do not exist, but columns of a window that is no candidate ask for
 * them. Whatever is there is taken in and dropped again by the recursion. */
#define PAIR_MARGIN (DISPARITY_MAX - DISPARITY_MIN)

#if WINDOW * WINDOW * MOST_DISTANCE > 65535
typedef uint32_t shd_score;
#else
typedef uint16_t shd_score;
#endif

shd_score shd_scores[MOST_COLUMNS * DISPARITY_COUNT]; /* S: [column][d] */
shd_score shd_update[DISPARITY_COUNT];                /* U: [d] */
shd_score shd_modular[WINDOW * DISPARITY_COUNT];      /* M: [x mod WINDOW][d] */
uint16_t left_pairs[MAP_WIDTH];                       /* [x] */
uint16_t right_pairs[PAIR_MARGIN + MAP_WIDTH];        /* [PAIR_MARGIN + x] */
int32_t right_keys[MAP_WIDTH];                        /* winner of each right pixel */
uint8_t left_winners[MAP_WIDTH];
uint8_t right_winners[MAP_WIDTH];
const uint8_t shd_zero_row[MAP_WIDTH];

__attribute__((noinline)) void shd_start_frame(void) { memset(shd_scores, 0, sizeof shd_scores); }

static void pair_row(const uint8_t* restrict entering, const uint8_t* restrict leaving,
                     unsigned inversion, uint16_t* restrict pairs) {
  for (int x = 0; x < MAP_WIDTH; ++x) {
    *pairs++ = (uint16_t)(*entering++ | (*leaving++ ^ inversion) << 8);
  }
}

__attribute__((noinline)) void shd_pair_rows(const uint8_t* left_entering,
                                             const uint8_t* left_leaving,
                                             const uint8_t* right_entering,
                                             const uint8_t* right_leaving) {
  pair_row(left_entering, left_leaving, INVERTED, left_pairs);
  pair_row(right_entering, right_leaving, 0, right_pairs + PAIR_MARGIN);
}

/* Begins U and M anew and takes in the row's columns before the first window is complete. */
__attribute__((noinline)) static void shd_start_row(void) {
  int window = geometry.window;
  int count = geometry.disparity_count;
  shd_score* restrict modular = shd_modular;
  const uint16_t* left = left_pairs + geometry.disparity_min;
  const uint16_t* right_of_column = right_pairs + PAIR_MARGIN;

  memset(shd_update, 0, sizeof shd_update);
  for (int i = 0; i < window - 1; ++i) {
    const uint16_t* right = right_of_column++;
    shd_score* restrict update = shd_update;
    unsigned left_pair = *left++;
    for (int k = 0; k < count; ++k) {
      unsigned newest = newest_of(left_pair, *right--);
      *modular++ = (shd_score)newest;
      *update = (shd_score)(*update + newest - BIAS);
      ++update;
    }
  }
  /* The first window lacks nothing on its left: what it drops is nothing. */
  for (int k = 0; k < count; ++k) {
    *modular++ = BIAS;
  }
}

/* Takes in the other columns: updates the scores of all columns and disparities. */
__attribute__((noinline)) static void shd_update_row(void) {
  int window = geometry.window;
  int count = geometry.disparity_count;
  int columns = geometry.columns;
  shd_score* restrict score = shd_scores;
  shd_score* restrict oldest = shd_modular + (window - 1) * count;
  const uint16_t* left = left_pairs + geometry.first_column + geometry.half_window;
  const uint16_t* right_of_column = right_pairs + PAIR_MARGIN + window - 1;

  for (int i = 0; i < columns; ++i) {
    const uint16_t* right = right_of_column++;
    shd_score* restrict update = shd_update;
    unsigned left_pair = *left++;
    for (int k = 0; k < count; ++k) {
      unsigned newest = newest_of(left_pair, *right--);
      unsigned sum = *update + newest - *oldest;
      *oldest++ = (shd_score)newest;
      *update++ = (shd_score)sum;
      *score = (shd_score)(*score + sum);
      ++score;
    }
    if (oldest == shd_modular + window * count) {
      oldest = shd_modular;
    }
  }
}

void shd_enter_row(void) {
  shd_start_row();
  shd_update_row();
}

__attribute__((noinline)) void shd_select_row(void) {
  int count = geometry.disparity_count;
  int columns = geometry.columns;
  const shd_score* column_scores = shd_scores;
  uint8_t* left_winner = left_winners + geometry.first_column;
  int32_t* right_key_of_column = right_keys + geometry.half_window;
  int candidates = 1;

  for (int x = 0; x < MAP_WIDTH; ++x) {
    right_keys[x] = INT32_MAX;
  }
  for (int i = 0; i < columns; ++i) {
    const shd_score* restrict score = column_scores;
    int32_t* restrict right_key = right_key_of_column++;
    int32_t best = INT32_MAX;
    for (int k = 0; k < candidates; ++k) {
      int32_t key = (int32_t)((uint32_t)*score++ << KEY_BITS) + k;
      int32_t right_best = *right_key;
      best = key < best ? key : best;
      *right_key-- = key < right_best ? key : right_best;
    }
    *left_winner++ = (uint8_t)(best & KEY_MASK);
    column_scores += count;
    /* A column further to the right has one more right window inside the image. */
    if (candidates < count) {
      ++candidates;
    }
  }
  for (int x = 0; x < MAP_WIDTH; ++x) {
    right_winners[x] = (uint8_t)(right_keys[x] & KEY_MASK);
  }
}

#endif
