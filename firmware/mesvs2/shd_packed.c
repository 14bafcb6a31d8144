/* The matching of shd.h with two disparities in a word: the firmware's, where codes are compared by
 * bits and a score and a disparity fit 16 of them.
 *
 * A key, score * 32 + the disparity's index - 32768, is a signed half; its score moves by 32 * U,
 * and the least of two keys is the winner without a branch. A pass along the row takes a pair of
 * disparities, so that U stays in an accumulator: each column that enters the window and the one
 * that leaves it, each on the row that enters and on the one that leaves, are four bytes, and one
 * XOR and one ONES count what they change, plus 16: what counts with a minus is inverted on the
 * left.
 *
 * The 16 are taken off by every other column's left word being inverted and its count subtracted:
 * 32 - ones are counted then. In between U is 16 too high, and so is the score of every other
 * column; on every other row it is the other columns that are inverted, which brings these scores
 * right again. So the even columns' keys are too high on every second row, all by the same. The
 * winners of even and odd columns for the right view are kept apart, for that reason and because
 * pairs of disparities meet the right columns in pairs that begin at even or at odd ones. */
#include <string.h>

#include "geometry.h"
#include "shd.h"

#if SHD_PACKED

#define MOST_PASSES ((DISPARITY_COUNT + 1) / 2)
#define NO_KEY 0x7FFF
#define KEY_OF_NOTHING 0x8000u /* the score 0 of the first disparity */
#define WEIGHT 32
#define TOO_HIGH (16 * WEIGHT)

_Static_assert(KEY_BITS == 5 && DISPARITY_COUNT <= WEIGHT, "a disparity's index fits a key");
_Static_assert(WINDOW* WINDOW * 8 * WEIGHT + TOO_HIGH + WEIGHT < 65535, "a key fits 16 bits");
_Static_assert(MAP_WIDTH - WINDOW - HIGHEST_DISPARITY_MIN > 2 * DISPARITY_COUNT,
               "every pass has columns");

/* A pass begins at the column from which its first disparity is a candidate. */
#define SCORE_WORDS (MOST_PASSES * (MOST_COLUMNS - MOST_PASSES + 1))

/* As shd_passes.bir reads them. */
struct shd_pass {
  const uint16_t* start; /* left halves, from the column that leaves the first window */
  uint32_t* left_best;
  const uint32_t* left_words;
  int column_pairs;
  int column_alone;
};
struct shd_row {
  uint32_t* scores;
  const uint32_t* right_words;
  uint32_t* even_best;
  uint32_t* odd_best; /* a word before the first */
  const uint16_t* right_start;
  const uint16_t* next_right_start;
  uint32_t weights; /* of even columns in the low half, of odd ones in the high half */
  int start_words;
  int start_excess; /* by what the counts of the start are too high */
};
void shd_update_row(const struct shd_pass* passes, int count, struct shd_row* row);
void shd_update_last(const struct shd_pass* pass, const struct shd_row* row);

uint8_t left_winners[MAP_WIDTH];
uint8_t right_winners[MAP_WIDTH];
const uint8_t shd_zero_row[MAP_WIDTH];

/* Keys of two disparities, a pass behind the other, a column behind the other. */
uint32_t shd_scores[SCORE_WORDS];
uint32_t shd_left_best[MOST_COLUMNS];
uint32_t shd_even_best[MOST_COLUMNS / 2 + 1];
uint32_t shd_odd_best[1 + MOST_COLUMNS / 2 + 1];

/* Entering and leaving code of each column, the leaving one inverted on the left. The left columns
 * begin so that the least disparity lies at a word; the right ones with two that do not exist: 0.
 */
#define RIGHT_SHIFT 2
_Alignas(4) uint16_t shd_left_halves[1 + MAP_WIDTH + 3];
_Alignas(4) uint16_t shd_right_halves[RIGHT_SHIFT + MAP_WIDTH];
_Alignas(4) uint16_t shd_right_start[WINDOW + 1]; /* from column -1 on */
/* With the column that leaves in the high half; on the right from the column on that the second
 * disparity of the first column meets. The kernel reads ahead, from both at once: aligned so that
 * the two never want the same half of a sub-bank. */
_Alignas(8) uint32_t shd_left_words[MOST_COLUMNS + 2];
_Alignas(8) uint32_t shd_right_words[1 + MOST_COLUMNS + 2];

static struct shd_pass passes[MOST_PASSES];
static unsigned even_row;

static int left_shift(void) { return geometry.disparity_min % 2; }
static int pass_count(void) { return (geometry.disparity_count + 1) / 2; }

static void describe_passes(void) {
  for (int i = 0; i < pass_count(); ++i) {
    int columns = geometry.columns - 2 * i;
    passes[i].start = shd_left_halves + left_shift() + geometry.disparity_min + 2 * i - 1;
    passes[i].left_best = shd_left_best + 2 * i;
    passes[i].left_words = shd_left_words + 2 * i;
    passes[i].column_pairs = columns / 2;
    passes[i].column_alone = columns % 2;
  }
}

__attribute__((noinline)) void shd_start_frame(void) {
  uint32_t* score = shd_scores;
  describe_passes();
  unsigned count = (unsigned)geometry.disparity_count;
  for (unsigned k = 0; k < count; k += 2) {
    uint32_t second = k + 1 < count ? KEY_OF_NOTHING + k + 1 : NO_KEY;
    for (unsigned i = k; i < (unsigned)geometry.columns; ++i) {
      *score++ = (KEY_OF_NOTHING + k) | second << 16;
    }
  }
  even_row = 0;
}

static void join_halves(const uint8_t* restrict entering, const uint8_t* restrict leaving,
                        unsigned inversion, uint16_t* restrict halves) {
  for (int x = 0; x < MAP_WIDTH; ++x) {
    *halves++ = (uint16_t)(*entering++ | (*leaving++ ^ inversion) << 8);
  }
}

/* Column i and the one that leaves when it enters, a window before; `turn` inverts every other one.
 */
static void join_words(const uint16_t* halves, unsigned inversion, unsigned turn, int count,
                       uint32_t* restrict words) {
  const uint16_t* leaving = halves - geometry.window;
  for (int i = 0; i < count; ++i) {
    *words++ = (uint32_t)(*halves++ | *leaving++ << 16) ^ inversion;
    inversion ^= turn;
  }
}

__attribute__((noinline)) void shd_pair_rows(const uint8_t* left_entering,
                                             const uint8_t* left_leaving,
                                             const uint8_t* right_entering,
                                             const uint8_t* right_leaving) {
  even_row ^= 1;
  join_halves(left_entering, left_leaving, 0xFF, shd_left_halves + left_shift());
  join_halves(right_entering, right_leaving, 0, shd_right_halves + RIGHT_SHIFT);
  join_words(shd_left_halves + left_shift() + geometry.first_column + geometry.half_window,
             0xFFFF0000u ^ (even_row ? 0 : ~0u), ~0u, geometry.columns, shd_left_words);
  join_words(shd_right_halves + RIGHT_SHIFT + geometry.window - 2, 0, 0, geometry.columns + 1,
             shd_right_words);
  memcpy(shd_right_start, shd_right_halves + RIGHT_SHIFT - 1,
         (unsigned)(geometry.window - 1) * sizeof(uint16_t));
}

static void forget_winners(uint32_t* best, int count) {
  for (int i = 0; i < count; ++i) {
    *best++ = NO_KEY << 16 | NO_KEY;
  }
}

__attribute__((noinline)) void shd_enter_row(void) {
  struct shd_row row = {
      shd_scores,
      shd_right_words,
      shd_even_best,
      shd_odd_best,
      shd_right_halves + RIGHT_SHIFT,
      shd_right_start,
      even_row ? 0x10000u * (0x10000u - WEIGHT) + WEIGHT : 0x10000u * WEIGHT + (0x10000u - WEIGHT),
      (geometry.window - 1) / 2,
      8 * geometry.window};
  forget_winners(shd_left_best, geometry.columns);
  forget_winners(shd_even_best, geometry.columns / 2 + 1);
  forget_winners(shd_odd_best, 1 + geometry.columns / 2 + 1);
  shd_update_row(passes, geometry.disparity_count / 2, &row);
  if (geometry.disparity_count % 2 == 1) {
    shd_update_last(&passes[pass_count() - 1], &row);
  }
}

static int first_key(uint32_t pair) { return (int16_t)pair; }
static int second_key(uint32_t pair) { return (int32_t)pair >> 16; }
static uint8_t winner(int a, int b) { return (uint8_t)((a < b ? a : b) & KEY_MASK); }

/* Right column 2 j is the first of even column 2 j's pairs and the second of odd column 2 j + 1's;
 * right column 2 j + 1 the first of odd column 2 j + 1's and the second of even column 2 j + 2's.
 */
__attribute__((noinline)) void shd_select_row(void) {
  const uint32_t* restrict pair = shd_left_best;
  uint8_t* restrict left = left_winners + geometry.first_column;
  const uint32_t* restrict even = shd_even_best;
  const uint32_t* restrict odd = shd_odd_best + 1;
  uint8_t* restrict right = right_winners + geometry.half_window;
  int columns = geometry.columns;
  int too_high = even_row ? TOO_HIGH : 0;

  for (int i = 0; i < columns; ++i) {
    uint32_t keys = *pair++;
    *left++ = winner(first_key(keys), second_key(keys));
  }
  for (int i = 0; i < columns / 2; ++i) {
    uint32_t odd_keys = *odd++;
    *right++ = winner(first_key(*even++) - too_high, second_key(odd_keys));
    *right++ = winner(first_key(odd_keys), second_key(*even) - too_high);
  }
  if (columns % 2 == 1) {
    *right = (uint8_t)(first_key(*even) & KEY_MASK);
  }
}

#endif
