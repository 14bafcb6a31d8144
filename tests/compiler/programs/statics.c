/* Static objects, initialised and not, in functions and outside. */
#include "report.h"
static int calls;
static short history[8];
static const char *const names[] = {"zero", "one", "two"};
static unsigned char initialised[] = {9, 8, 7, 6, 5};
static int *pointer_to = &calls;
static const short *inside = &history[3];
__attribute__((noinline)) static int counter(void) {
  static int n = 5;
  static short steps[4] = {1, -2, 3, -4};
  n += steps[calls & 3];
  calls++;
  history[calls & 7] = (short)n;
  return n;
}
__attribute__((noinline)) static int other_counter(void) {
  static int n;
  return n += 3;
}
int main(void) {
  unsigned s = 0;
  for (int i = 0; i < 13; i++) s = mix(s, (unsigned)(counter() + other_counter()));
  report("counters", s);
  *pointer_to += 100;
  report("calls", (unsigned)calls);
  report("inside", (unsigned)*inside);
  for (int i = 0; i < 3; i++) s = mix(s, (unsigned char)names[i][i]);
  for (int i = 0; i < 5; i++) initialised[i] = (unsigned char)(initialised[i] * 3), s = mix(s, initialised[i]);
  report("data", s);
  return 0;
}
