/* 81 times the variance of every nine neighbours in a row of 160 samples of 0 to 1023. */
#include <stdint.h>

#define WIDTH 160
#define WINDOW 9

void variance_row(const int16_t* restrict row, int32_t* restrict variance) {
  int16_t sum = 0;
  int32_t squares = 0;
  for (int x = 0; x < WINDOW; ++x) {
    sum = (int16_t)(sum + row[x]);
    squares += row[x] * row[x];
  }
  *variance++ = WINDOW * squares - sum * sum;
  for (int x = WINDOW; x < WIDTH; ++x) {
    int16_t entering = row[x];
    int16_t leaving = row[x - WINDOW];
    sum = (int16_t)(sum + entering - leaving);
    squares += entering * entering - leaving * leaving;
    *variance++ = WINDOW * squares - sum * sum;
  }
}
