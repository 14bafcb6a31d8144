/* Labels as values: a threaded interpreter, and a table of them that is searched. */
#include "report.h"

static int run(const unsigned char *code) {
  static const void *const to[] = {&&push, &&add, &&multiply, &&negate, &&duplicate, &&end};
  int stack[8];
  int depth = 0;
#define NEXT goto *to[*code++]
  NEXT;
push:
  stack[depth++] = *code++;
  NEXT;
add:
  depth--;
  stack[depth - 1] += stack[depth];
  NEXT;
multiply:
  depth--;
  stack[depth - 1] *= stack[depth];
  NEXT;
negate:
  stack[depth - 1] = -stack[depth - 1];
  NEXT;
duplicate:
  stack[depth] = stack[depth - 1];
  depth++;
  NEXT;
end:
  return stack[0];
}

static int states(const char *text) {
  void *state = &&even;
  int seen = 0;
next:
  if (*text == 0) return state == &&even ? seen : -seen;
  goto *state;
even:
  state = *text++ == '1' ? &&odd : &&even;
  seen++;
  goto next;
odd:
  state = *text++ == '1' ? &&even : &&odd;
  seen += 100;
  goto next;
}

/* Offsets between labels; the part that makes them is inlined where it is called. */
static short distance[3];

static int wander(const short *way) {
  static const void *const to[] = {&&first, &&second, &&last};
  const char *const base = &&first;
  int sum = 0;
  if (way == 0) {
    for (int i = 0; i < 3; i++) distance[i] = (short)((const char *)to[i] - base);
    return 0;
  }
first:
  sum = sum * 10 + 1;
  goto *(void *)(base + *way++);
second:
  sum = sum * 10 + 2;
  goto *(void *)(base + *way++);
last:
  return sum * 10 + 3;
}

int main(void) {
  short way[4];
  wander(0);
  way[0] = distance[1];
  way[1] = distance[0];
  way[2] = distance[1];
  way[3] = distance[2];
  report("wander", (unsigned)wander(way));
  static const unsigned char program[] = {0, 3, 0, 4, 1, 4, 2, 0, 5, 3, 2, 5};
  report("run", (unsigned)run(program));
  report("states", (unsigned)states("1001101"));
  report("odd", (unsigned)states("10"));
  return 0;
}
