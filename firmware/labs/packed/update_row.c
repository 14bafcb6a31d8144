#include "kernels.h"

__attribute__((noinline)) void update_row(uint16_t* restrict scores, uint16_t* restrict update,
                                          const uint32_t* restrict left,
                                          const uint32_t* restrict right, int columns) {
  for (int i = 0; i < columns; ++i) {
    const uint32_t* opposite = right++;
    uint16_t* restrict change = update;
    uint32_t word = *left++;
    for (int k = 0; k < SLOTS; ++k) {
      unsigned sum = *change + (unsigned)__builtin_popcount(word ^ *opposite--) - 16;
      *change++ = (uint16_t)sum;
      *scores = (uint16_t)(*scores + sum);
      ++scores;
    }
  }
}
