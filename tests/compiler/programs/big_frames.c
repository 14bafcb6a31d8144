/* Frames larger than the scratchpad, and larger than the reach of one offset. */
#include "report.h"
__attribute__((noinline)) static unsigned wide(int n) {
  unsigned char bytes[40000];
  short halves[9000];
  int words[3000];
  for (int i = 0; i < n; i++) {
    bytes[i * 7 % 40000] = (unsigned char)i;
    halves[i * 5 % 9000] = (short)(i * 3);
    words[i * 3 % 3000] = i * i;
  }
  bytes[0] = 3;
  bytes[39999] = 5;
  halves[8999] = -7;
  words[2999] = 9;
  unsigned s = bytes[0] + bytes[39999] + (unsigned)halves[8999] + (unsigned)words[2999];
  for (int i = 0; i < n; i++) s = mix(s, bytes[i * 7 % 40000] + (unsigned)halves[i * 5 % 9000] + (unsigned)words[i * 3 % 3000]);
  return s;
}
__attribute__((noinline)) static unsigned through(volatile unsigned char *first, int n) {
  volatile unsigned char pad[33000];
  volatile int far[4] = {n, n + 1, n + 2, n + 3};
  pad[0] = 1;
  pad[32999] = *first;
  return pad[0] + pad[32999] * 256u + (unsigned)(far[0] * far[3] - far[1] * far[2]);
}
int main(void) {
  volatile unsigned char x = 42;
  report("wide", wide(300));
  report("through", through(&x, 5));
  return 0;
}
