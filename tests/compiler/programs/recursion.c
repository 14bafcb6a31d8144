/* Ackermann's function, Hanoi's towers, mutual recursion, queens. */
#include "report.h"
static int depth, deepest;
__attribute__((noinline)) static unsigned ackermann(unsigned m, unsigned n) {
  if (++depth > deepest) deepest = depth;
  unsigned r = m == 0 ? n + 1 : n == 0 ? ackermann(m - 1, 1) : ackermann(m - 1, ackermann(m, n - 1));
  depth--;
  return r;
}
static int fibonacci(int n) { return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2); }
static unsigned moves;
__attribute__((noinline)) static void hanoi(int n, int from, int to, int spare, int a5, int a6) {
  if (n == 0) return;
  hanoi(n - 1, from, spare, to, a6, a5);
  moves = mix(moves, (unsigned)(from * 100 + to * 10 + a5 - a6));
  hanoi(n - 1, spare, to, from, a5 + 1, a6);
}
static int is_odd(int n);
static int is_even(int n) { return n == 0 ? 1 : is_odd(n - 1); }
static int is_odd(int n) { return n == 0 ? 0 : is_even(n - 1); }
static unsigned board[8], found;
static void queens(int row, unsigned columns, unsigned left, unsigned right) {
  if (row == 6) {
    found = mix(found, board[0] + board[5] * 8);
    return;
  }
  for (unsigned free = ~(columns | left | right) & 63; free != 0; free &= free - 1) {
    unsigned bit = free & -free;
    board[row] = bit;
    queens(row + 1, columns | bit, (left | bit) << 1, (right | bit) >> 1);
  }
}
int main(void) {
  report("ackermann", ackermann(2, 9));
  report("deepest", (unsigned)deepest);
  report("fibonacci", (unsigned)fibonacci(15));
  hanoi(7, 1, 2, 3, 4, 5);
  report("hanoi", moves);
  report("even", (unsigned)(is_even(11) * 2 + is_odd(11)));
  queens(0, 0, 0, 0);
  report("queens", found);
  return 0;
}
