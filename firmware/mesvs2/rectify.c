#include "rectify.h"

#define ONE 32767 /* the largest fraction: the rounding makes up for what it lacks */

__attribute__((noinline)) void rectify_rows(const uint8_t* restrict image,
                                            const struct rectification_row* restrict table,
                                            int rows, uint8_t* restrict rectified) {
  for (; rows != 0; --rows) {
    const source_index* source = table->source[0];
    const int16_t* weight = table->weights[0];
    for (int x = 0; x < MAP_WIDTH; ++x) {
      const uint8_t* upper = image + source[0] + MAP_WIDTH * source[1];
      const uint8_t* lower = upper + MAP_WIDTH;
      int32_t sum = 1 << 14;
      sum += weight[0] * (int16_t)upper[0];
      sum += weight[1] * (int16_t)upper[1];
      sum += weight[2] * (int16_t)lower[0];
      sum += weight[3] * (int16_t)lower[1];
      *rectified++ = (uint8_t)(sum >> 15);
      source += 2;
      weight += 4;
    }
    ++table;
  }
}

__attribute__((noinline)) void identity_row(int y, struct rectification_row* row) {
  int below = y == MAP_HEIGHT - 1;
  for (int x = 0; x < MAP_WIDTH; ++x) {
    int right = x == MAP_WIDTH - 1;
    row->source[x][0] = (source_index)(x - right);
    row->source[x][1] = (source_index)(y - below);
    for (int corner = 0; corner < 4; ++corner) {
      row->weights[x][corner] = corner == 2 * below + right ? ONE : 0;
    }
  }
}
