/* Comparisons of both signs with registers and constants, of pointers, of narrow values. */
#include "report.h"
__attribute__((noinline)) static unsigned all(unsigned a, unsigned b) {
  return (a < b) | (a <= b) << 1 | (a > b) << 2 | (a >= b) << 3 | (a < 8) << 4 | (a > 7) << 5 | (a <= 7) << 6 | (a >= 8) << 7 |
         (a < 9) << 8 | (a == 3) << 9 | (a != 7) << 10 | (a > 65535) << 11 | (a - b < 10) << 12;
}
__attribute__((noinline)) static unsigned all_signed(int a, int b) {
  return (unsigned)((a < b) | (a <= b) << 1 | (a > b) << 2 | (a >= b) << 3 | (a < 4) << 4 | (a > 3) << 5 | (a <= 3) << 6 |
                    (a >= 4) << 7 | (a < -4) << 8 | (a <= -4) << 9 | (a > -5) << 10 | (a >= -4) << 11 | (a == -4) << 12 |
                    (a != 4) << 13 | (a < 0) << 14 | (a > -1) << 15 | (a > 0) << 16 | (a <= 0) << 17);
}
__attribute__((noinline)) static int order(const char *a, const char *b) { return a < b ? -1 : a > b; }
int main(void) {
  static const int values[] = {0, 1, 2, 3, 4, 5, 7, 8, 9, -1, -3, -4, -5, 100, 65535, 65536, 0x7fffffff, (int)0x80000000u};
  unsigned s = 0;
  for (int i = 0; i < 18; i++)
    for (int j = 0; j < 18; j++)
      s = mix(s, all((unsigned)values[i], (unsigned)values[j]) ^ all_signed(values[i], values[j]) << 13);
  char text[4];
  for (int i = 0; i < 4; i++) s = mix(s, (unsigned)order(text + i, text + 2));
  report("compare", s);
  return 0;
}
