/* Searches that go back: a sudoku by bit sets, knights by fewest ways on, subset sums, a
 * game of three in a row to its end. */
#include <string.h>

#include "report.h"

static unsigned short rows[9], columns[9], boxes[9];
static char grid[82];
static unsigned tries;

static int solve(void) {
  int best = -1, fewest = 10;
  unsigned choices = 0;
  for (int i = 0; i < 81; i++) {
    if (grid[i] != '.')
      continue;
    unsigned open =
        511u & ~(unsigned)(rows[i / 9] | columns[i % 9] | boxes[i / 27 * 3 + i % 9 / 3]);
    int count = __builtin_popcount(open);
    if (count < fewest) {
      fewest = count;
      best = i;
      choices = open;
    }
  }
  if (best < 0)
    return 1;
  for (; choices != 0; choices &= choices - 1) {
    unsigned bit = choices & -choices;
    unsigned short* const sets[] = {&rows[best / 9], &columns[best % 9],
                                    &boxes[best / 27 * 3 + best % 9 / 3]};
    for (int k = 0; k < 3; k++)
      *sets[k] ^= (unsigned short)bit;
    grid[best] = (char)('1' + __builtin_ctz(bit));
    tries++;
    if (solve())
      return 1;
    for (int k = 0; k < 3; k++)
      *sets[k] ^= (unsigned short)bit;
  }
  grid[best] = '.';
  return 0;
}
APART static int sudoku(const char* puzzle) {
  memcpy(grid, puzzle, 82);
  memset(rows, 0, sizeof rows);
  memset(columns, 0, sizeof columns);
  memset(boxes, 0, sizeof boxes);
  for (int i = 0; i < 81; i++)
    if (grid[i] != '.') {
      unsigned short bit = (unsigned short)(1 << (grid[i] - '1'));
      rows[i / 9] |= bit;
      columns[i % 9] |= bit;
      boxes[i / 27 * 3 + i % 9 / 3] |= bit;
    }
  return solve();
}
static signed char board[8][8];
static const signed char moves[8][2] = {{1, 2},   {2, 1},   {2, -1}, {1, -2},
                                        {-1, -2}, {-2, -1}, {-2, 1}, {-1, 2}};
static int ways(int x, int y) {
  int n = 0;
  for (int i = 0; i < 8; i++) {
    int u = x + moves[i][0], v = y + moves[i][1];
    n += u >= 0 && u < 8 && v >= 0 && v < 8 && board[v][u] == 0;
  }
  return n;
}
APART static int knight(int x, int y) {
  int step = 1;
  memset(board, 0, sizeof board);
  for (;; step++) {
    board[y][x] = (signed char)step;
    int best = 9, to_x = -1, to_y = -1;
    for (int i = 0; i < 8; i++) {
      int u = x + moves[i][0], v = y + moves[i][1];
      if (u < 0 || u > 7 || v < 0 || v > 7 || board[v][u] != 0)
        continue;
      int n = ways(u, v);
      if (n < best) {
        best = n;
        to_x = u;
        to_y = v;
      }
    }
    if (to_x < 0)
      return step;
    x = to_x;
    y = to_y;
  }
}
static int subsets(const short* p, int n, int wanted) {
  if (wanted == 0)
    return 1;
  if (n == 0 || wanted < 0)
    return 0;
  return subsets(p + 1, n - 1, wanted - *p) + subsets(p + 1, n - 1, wanted);
}
static int games;
static int wins(unsigned set) {
  static const unsigned short lines[] = {0007, 0070, 0700, 0111, 0222, 0444, 0421, 0124};
  for (int i = 0; i < 8; i++)
    if ((set & lines[i]) == lines[i])
      return 1;
  return 0;
}
static int play(unsigned own, unsigned other) {
  if (wins(other))
    return games++, -1;
  if ((own | other) == 0777)
    return games++, 0;
  int best = -2;
  for (unsigned bit = 1; bit < 0777; bit <<= 1)
    if (!((own | other) & bit)) {
      int value = -play(other, own | bit);
      if (value > best)
        best = value;
    }
  return best;
}

int main(void) {
  report("sudoku",
         (unsigned)sudoku(
             "53..7....6..195....98....6.8...6...34..8.3..17...2...6.6....28....419..5....8..79"));
  unsigned s = tries;
  for (int i = 0; i < 81; i++)
    s = mix(s, (unsigned char)grid[i]);
  report("solved", s);
  s = (unsigned)knight(0, 0);
  for (int i = 0; i < 64; i++)
    s = mix(s, (unsigned)board[i / 8][i % 8]);
  report("knight", s);
  static const short numbers[] = {3, 34, 4, 12, 5, 2, 17, 9, 21, 8, 6, 1};
  report("subsets", (unsigned)subsets(numbers, 12, 30));
  report("draw", (unsigned)(play(021, 0102) + 10) + (unsigned)games * 100);
  return 0;
}
