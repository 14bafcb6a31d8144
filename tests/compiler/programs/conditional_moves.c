/* Minima and where they are: selections instead of branches. */
#include "report.h"
__attribute__((noinline)) static int smallest(const int *p, int n, int *where) {
  int best = 0x7fffffff;
  for (int i = 0; i < n; i++)
    if (p[i] < best) best = p[i], *where = i;
  return best;
}
__attribute__((noinline)) static void winners(const unsigned short *scores, unsigned char *best, int columns, int n) {
  for (int x = 0; x < columns; x++) {
    unsigned least = 65535;
    int at = 0;
    for (int d = 0; d < n; d++) {
      unsigned s = scores[x * n + d];
      at = s < least ? d : at;
      least = s < least ? s : least;
    }
    best[x] = (unsigned char)at;
  }
}
__attribute__((noinline)) static unsigned choose(unsigned a, unsigned b, int c, int d) {
  unsigned r = a > b ? a : b;
  r += c > d ? (unsigned)c : (unsigned)-d;
  r ^= a == 0 ? 99u : b;
  return (a & 8) ? r : ~r;
}
int main(void) {
  static int numbers[30];
  static unsigned short scores[15 * 11];
  unsigned char best[15];
  unsigned state = 2, s = 0;
  int where = -1;
  for (int i = 0; i < 30; i++) numbers[i] = (int)(next_number(&state) << 8);
  for (int i = 0; i < 165; i++) scores[i] = (unsigned short)next_number(&state);
  s = mix(s, (unsigned)smallest(numbers, 30, &where));
  s = mix(s, (unsigned)where);
  winners(scores, best, 15, 11);
  for (int i = 0; i < 15; i++) s = mix(s, best[i]);
  for (unsigned i = 0; i < 40; i++) s = mix(s, choose(i * 7 % 16, i, (int)i - 20, numbers[i % 30]));
  report("moves", s);
  return 0;
}
