/* The inner part of matching by sums of Hamming distances, as firmware/mesvs2/shd.c has it: 141
 * columns of 31 disparities. Its arrays are arguments here; `ring` holds the distances of the last
 * 15 columns, the latest in its last row but one, and `right_of_column` points to what the first
 * column meets at the least disparity. */
#include <stdint.h>

#define COLUMNS 141
#define DISPARITIES 31
#define WINDOW 15

void shd_update_row(const uint16_t* left, const uint16_t* right_of_column,
                    uint16_t* restrict updates, uint16_t* restrict ring, uint16_t* restrict score) {
  uint16_t* restrict oldest = ring + (WINDOW - 1) * DISPARITIES;
  for (int i = 0; i < COLUMNS; ++i) {
    const uint16_t* right = right_of_column++;
    uint16_t* restrict update = updates;
    unsigned left_pair = *left++;
    for (int k = 0; k < DISPARITIES; ++k) {
      unsigned newest = (unsigned)__builtin_popcount(left_pair ^ *right--);
      unsigned sum = *update + newest - *oldest;
      *oldest++ = (uint16_t)newest;
      *update++ = (uint16_t)sum;
      *score = (uint16_t)(*score + sum);
      ++score;
    }
    if (oldest == ring + WINDOW * DISPARITIES) {
      oldest = ring;
    }
  }
}
