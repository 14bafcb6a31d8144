/* goto: into loops and blocks, backwards, out of nests, between loops, so that loops have two
 * entries; computed jumps into a loop. */
#include "report.h"

APART static unsigned into_a_loop(int start, int end) {
  unsigned s = 1;
  int i = start;
  if (start & 1)
    goto inside;
  for (i = 0; i < end; i++) {
    s = mix(s, (unsigned)i);
  inside:
    s += 7;
    if (s % 11 == 0)
      i += 2;
  }
  return s;
}
APART static unsigned two_entries(int n, int which) {
  unsigned s = 0;
  if (which)
    goto second;
first:
  s = s * 3 + (unsigned)n;
  if (n-- <= 0)
    goto out;
second:
  s ^= (unsigned)n << 3;
  if (n & 4)
    goto third;
  goto first;
third:
  n -= 2;
  if (n > 0)
    goto second;
out:
  return s;
}
APART static int out_of_nests(const int* p, int a, int b, int c) {
  int steps = 0;
  for (int i = 0; i < a; i++)
    for (int j = 0; j < b; j++) {
      int k = 0;
      do {
        steps++;
        int value = p[(i + j + k) % 10];
        if (value < 0)
          goto next_row;
        if (value == 99)
          goto found;
        if (value > 50)
          break;
      } while (++k < c);
      continue;
    next_row:
      steps += 1000;
      break;
    }
  return steps;
found:
  return -steps;
}
APART static unsigned backwards(unsigned n) {
  unsigned tries = 0;
again:
  tries++;
  if (n & 1)
    n = 3 * n + 1;
  else
    n >>= 1;
  if (n != 1)
    goto again;
  return tries;
}
APART static int between_loops(int n) {
  int a = 0, b = 0;
one:
  while (a < n) {
    a += 3;
    if (a % 7 == 0)
      goto two;
  }
  return a * 100 + b;
two:
  while (b < n) {
    b += 2;
    if (b % 5 == 0)
      goto one;
  }
  return a * 100 - b;
}
APART static int computed(int entry, int n) {
  static const void* const places[] = {&&start, &&middle, &&end};
  int s = 0;
  goto* places[entry];
start:
  for (; n > 0; n--) {
    s += n;
  middle:
    s ^= 5;
    if (s > 100)
      goto* places[2];
  }
end:
  return s * 10 + n;
}
APART static int over_a_block(int x) {
  if (x > 3)
    goto inside;
  {
    int y = x * 2;
    x = y + 1;
  inside:
    y = x - 1;
    x += y;
  }
  return x;
}

int main(void) {
  unsigned s = 0;
  for (int i = 0; i < 12; i++)
    s = mix(s, into_a_loop(i, 10));
  report("into", s);
  for (int i = 0; i < 30; i++)
    s = mix(s, two_entries(i, i & 1));
  report("entries", s);
  static const int numbers[10] = {1, 2, 60, 3, 4, -1, 5, 70, 99, 6};
  for (int i = 0; i < 12; i++)
    s = mix(s, (unsigned)out_of_nests(numbers, i, 12 - i, 1 + i % 4));
  report("nests", s);
  report("backwards", backwards(27));
  for (int i = 0; i < 40; i += 3)
    s = mix(s, (unsigned)between_loops(i));
  for (int i = 0; i < 3; i++)
    s = mix(s, (unsigned)computed(i, 20));
  for (int i = 0; i < 8; i++)
    s = mix(s, (unsigned)over_a_block(i));
  report("others", s);
  return 0;
}
