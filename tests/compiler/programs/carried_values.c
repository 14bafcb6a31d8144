/* Loops whose rounds depend on those before: by registers and by memory, at distances of one, two
 * and three, through conditions, and through a pointer that may or may not be the other one. */
#include "report.h"

APART static void fibonacci(unsigned* p, int n) {
  for (int i = 2; i < n; i++)
    p[i] = p[i - 1] + p[i - 2];
}
APART static void distance(int* p, int n, int d) {
  for (int i = d; i < n; i++)
    p[i] = (p[i - d] & 0xffff) * 3 + i;
}
APART static void distance_three(short* p, int n) {
  for (int i = 3; i < n; i++)
    p[i] = (short)(p[i - 3] - p[i]);
}
APART static void shift_down(int* p, int n) {
  for (int i = 0; i + 1 < n; i++)
    p[i] = p[i + 1] + 1;
}
APART static void maybe_same(int* to, const int* from, int n) {
  for (int i = 1; i < n; i++)
    to[i] = from[i - 1] + to[i];
}
APART static int swapped(int a, int b, int n) {
  for (int i = 0; i < n; i++) {
    int t = a;
    a = b;
    b = t + i;
  }
  return a * 100 + b;
}
APART static int three_delays(const short* p, int n) {
  int x1 = 0, x2 = 0, x3 = 0, sum = 0;
  for (int i = 0; i < n; i++) {
    int y = p[i] + 2 * x1 - 3 * x2 + x3;
    x3 = x2;
    x2 = x1;
    x1 = p[i];
    sum ^= y;
  }
  return sum + x1 * x2 - x3;
}
APART static void filtered(short* out, const short* in, int n) {
  int y1 = 0, y2 = 0;
  for (int i = 0; i < n; i++) {
    int y = (in[i] * 8192 + y1 * 26000 - y2 * 13000) >> 15;
    y2 = y1;
    y1 = y;
    out[i] = (short)y;
  }
}
APART static int conditional(const int* p, int n) {
  int best = 0, run = 0, last = 0;
  for (int i = 0; i < n; i++) {
    if (p[i] > last)
      run++;
    else
      run = 1;
    if (run > best)
      best = run;
    last = p[i];
  }
  return best * 16 + run;
}
APART static unsigned through_memory(unsigned* cell, int n) {
  for (int i = 0; i < n; i++)
    *cell = *cell * 5 + (unsigned)i;
  return *cell;
}
APART static void table_of_previous(int* next, int* table, int n) {
  for (int i = 0; i < n; i++) {
    int slot = table[i] & 7;
    next[i] = table[n + slot];
    table[n + slot] = i;
  }
}

int main(void) {
  unsigned numbers[40] = {1, 2}, s = 0, state = 5;
  int a[60], table[48];
  short x[50], y[50];
  fibonacci(numbers, 40);
  for (int i = 0; i < 40; i++)
    s = mix(s, numbers[i]);
  report("fibonacci", s);
  for (int d = 1; d < 6; d++) {
    for (int i = 0; i < 60; i++)
      a[i] = (int)next_number(&state) >> 18;
    distance(a, 30, d);
    shift_down(a, 60);
    maybe_same(a, a, 20);
    maybe_same(a + d, a, 40);
    maybe_same(a, a + d, 40);
    for (int i = 0; i < 60; i++)
      s = mix(s, (unsigned)a[i]);
    s = mix(s, (unsigned)(swapped(d, 7, d + 5) + conditional(a, 50)));
  }
  report("distances", s);
  for (int i = 0; i < 50; i++)
    x[i] = (short)next_number(&state);
  s = (unsigned)three_delays(x, 50);
  filtered(y, x, 50);
  distance_three(x, 50);
  for (int i = 0; i < 50; i++)
    s = mix(s, (unsigned)(x[i] + y[i]));
  report("delays", s);
  unsigned cell = 3;
  report("memory", through_memory(&cell, 20) + through_memory(&cell, 0));
  for (int i = 0; i < 48; i++)
    table[i] = i * 5;
  table_of_previous(a, table, 40);
  for (int i = 0; i < 40; i++)
    s = mix(s, (unsigned)a[i]);
  report("table", s);
  return 0;
}
