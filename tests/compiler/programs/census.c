/* The census transform of 3 by 3 and scores by ones, as stereo firmware has them. */
#include "report.h"
static unsigned char image[24][32];
static unsigned char census[24][32];
static unsigned short scores[8][32];
__attribute__((noinline)) static void transform(void) {
  for (int y = 1; y < 23; y++)
    for (int x = 1; x < 31; x++) {
      unsigned bits = 0, centre = image[y][x];
      for (int dy = -1; dy <= 1; dy++)
        for (int dx = -1; dx <= 1; dx++)
          if (dy || dx) bits = bits << 1 | (image[y + dy][x + dx] < centre);
      census[y][x] = (unsigned char)bits;
    }
}
__attribute__((noinline)) static void match(void) {
  for (int d = 0; d < 8; d++)
    for (int x = 4; x < 20; x++) {
      unsigned sum = 0;
      for (int y = 4; y < 20; y++) sum += (unsigned)__builtin_popcount(census[y][x] ^ census[y][x + d]);
      scores[d][x] = (unsigned short)sum;
    }
}
int main(void) {
  unsigned state = 77, s = 0;
  for (int i = 0; i < 24 * 32; i++) image[0][i] = (unsigned char)(next_number(&state) >> 3);
  transform();
  match();
  for (int i = 0; i < 24 * 32; i++) s = mix(s, census[0][i]);
  report("census", s);
  for (int i = 0; i < 8 * 32; i++) s = mix(s, scores[0][i]);
  report("scores", s);
  return 0;
}
