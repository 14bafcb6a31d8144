#include "variance.h"

#include <string.h>

_Static_assert(VARIANCE_WINDOW >= 3 && VARIANCE_WINDOW <= 15 && VARIANCE_WINDOW % 2 == 1,
               "sums of a window fit 32 bits");

/* Sums of each column over the window's rows; in front, columns outside the image: 0. */
int32_t variance_values[VARIANCE_WINDOW + MAP_WIDTH];
int32_t variance_squares[VARIANCE_WINDOW + MAP_WIDTH];
uint32_t variance_row[MAP_WIDTH];
const uint8_t variance_no_row[MAP_WIDTH];

__attribute__((noinline)) void variance_start(void) {
  memset(variance_values, 0, sizeof variance_values);
  memset(variance_squares, 0, sizeof variance_squares);
}

__attribute__((noinline)) void variance_enter_row(const uint8_t* restrict entering,
                                                  const uint8_t* restrict leaving) {
  int32_t* values = variance_values;
  int32_t* squares = variance_squares;
  uint32_t* restrict variance = variance_row;
  int32_t sum = 0;
  int32_t sum_of_squares = 0;

  for (int x = 0; x < MAP_WIDTH; ++x) {
    int in = *entering++;
    int out = *leaving++;
    int32_t value = values[VARIANCE_WINDOW] + in - out;
    int32_t square = squares[VARIANCE_WINDOW] + (in - out) * (in + out);
    sum += value - *values;
    sum_of_squares += square - *squares;
    values[VARIANCE_WINDOW] = value;
    squares[VARIANCE_WINDOW] = square;
    ++values;
    ++squares;
    *variance++ = VARIANCE_PIXELS * (uint32_t)sum_of_squares - (uint32_t)sum * (uint32_t)sum;
  }
}
