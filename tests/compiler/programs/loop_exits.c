/* Loops with more than one way out, and what lives on behind them: counters, pointers, sums, flags,
 * the last value seen, results returned from the middle. */
#include "report.h"

struct found {
  int index, value;
  const short* place;
};

APART static struct found search(const short* p, int n, int low, int high) {
  struct found f = {-1, 0, 0};
  int i;
  for (i = 0; i < n; i++) {
    if (p[i] < low)
      break;
    if (p[i] > high) {
      f.value = p[i];
      f.place = &p[i];
      break;
    }
  }
  f.index = i;
  return f;
}
APART static int counters_after(const unsigned char* p, int n, int* out) {
  int i = 0, j = n, sum = 0;
  while (i < j) {
    sum += p[i] - p[j - 1];
    if (sum > 300)
      break;
    i += 2;
    if (p[i] == 7)
      continue;
    j--;
  }
  out[0] = i;
  out[1] = j;
  return sum;
}
APART static const char* end_of(const char* p) {
  while (*p != 0 && *p != ';')
    p++;
  return p;
}
APART static int last_of(const int* p, int n) {
  int last = -1;
  for (int i = 0; i < n; i++) {
    if (p[i] % 3 != 0)
      continue;
    last = p[i];
    if (last > 1000)
      return -last;
  }
  return last;
}
APART static int three_exits(int n, int a, int b, int c) {
  for (int i = 0;; i++) {
    if (i == n)
      return i;
    a = (a * 5 + 1) & 0xffff;
    if (a % b == 0)
      return a;
    if (i > c)
      return -i;
  }
}
APART static unsigned outer_continue(const unsigned char* p, int rows, int columns) {
  unsigned s = 0;
  int row = 0, column = 0;
next:
  for (; row < rows; row++) {
    for (column = 0; column < columns; column++) {
      unsigned value = p[row * columns + column];
      if (value < 20) {
        row += 2;
        goto next;
      }
      if (value > 240)
        return s + (unsigned)column * 1000000;
      s += value;
    }
  }
  return s * 4 + (unsigned)(row + column);
}
APART static int minimum_at(const int* p, int n) {
  int at = 0;
  for (int i = 1; i < n; i++)
    if (p[i] < p[at])
      at = i;
  return at;
}
APART static int balance(const char* p) {
  int depth = 0, deepest = 0;
  for (; *p; ++p) {
    depth += *p == '(' ? 1 : *p == ')' ? -1 : 0;
    if (depth < 0)
      return -1;
    if (depth > deepest)
      deepest = depth;
  }
  return depth == 0 ? deepest : -2;
}

int main(void) {
  short numbers[60];
  unsigned char bytes[120];
  int words[40], out[2];
  unsigned state = 8, s = 0;
  for (int i = 0; i < 60; i++)
    numbers[i] = (short)(next_number(&state) % 2000);
  for (int i = 0; i < 120; i++)
    bytes[i] = (unsigned char)(next_number(&state) % 250);
  for (int i = 0; i < 40; i++)
    words[i] = (int)(next_number(&state) % 1200);
  for (int low = 0; low < 100; low += 20)
    for (int high = 1900; high < 2010; high += 15) {
      struct found f = search(numbers, 60 - low / 2, low, high);
      s = mix(s, (unsigned)(f.index + f.value) + (f.place ? (unsigned)(f.place - numbers) : 77));
    }
  report("search", s);
  for (int n = 0; n < 100; n += 7) {
    s = mix(s, (unsigned)counters_after(bytes, n, out));
    s = mix(s, (unsigned)(out[0] * 1000 + out[1]));
    s = mix(s, (unsigned)last_of(words, n / 3));
    s = mix(s, (unsigned)three_exits(n / 4, n, 7 + n % 5, n / 5));
    s = mix(s, outer_continue(bytes + n % 20, n / 14, 10 + n % 4));
    s = mix(s, (unsigned)minimum_at(words, n / 3));
  }
  report("exits", s);
  static const char text[] = "first;second";
  report("end", (unsigned)((end_of(text) - text) * 100 + (end_of(text + 6) - text)));
  report("balance", (unsigned)(balance("(()(()))") * 100 + balance("())(") * 10 + balance("((")));
  return 0;
}
