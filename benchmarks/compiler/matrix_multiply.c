/* The product of two matrices of 16-bit fractions. Sums fit 32 bits and results 16. */
#include <stdint.h>

#define SIZE 16

void matrix_multiply(const int16_t a[restrict SIZE][SIZE], const int16_t b[restrict SIZE][SIZE],
                     int16_t product[restrict SIZE][SIZE]) {
  for (int row = 0; row < SIZE; ++row) {
    for (int column = 0; column < SIZE; ++column) {
      int32_t sum = 0;
      for (int k = 0; k < SIZE; ++k) {
        sum += a[row][k] * b[k][column];
      }
      product[row][column] = (int16_t)(sum >> 15);
    }
  }
}
