/* Volatile halves, bytes and words: each access happens. */
#include "report.h"
static volatile unsigned short cell;
static volatile unsigned char bytes[4];
static volatile int words[3];
__attribute__((noinline)) static unsigned touch(int n) {
  unsigned s = 0;
  cell = (unsigned short)n;
  for (int i = 0; i < n; i++) {
    cell++;
    bytes[i & 3] = (unsigned char)(bytes[(i + 1) & 3] + cell);
    words[i % 3] -= cell * i;
    s = mix(s, cell + bytes[i & 3] + (unsigned)words[i % 3]);
  }
  return s;
}
int main(void) {
  report("volatile", touch(65));
  return 0;
}
