/* Cells that live by their neighbours: on a torus by bytes and by bits of words at once, in one
 * dimension by rules, an ant, sand that falls, and a flood measured by levels; pictures as text. */
#include <stdio.h>
#include <string.h>

#include "report.h"

#define W 32
#define H 16
static unsigned char cells[H][W], next[H][W];
static unsigned rows[H], after[H];

APART static void live(void) {
  for (int y = 0; y < H; y++)
    for (int x = 0; x < W; x++) {
      int n = 0;
      for (int v = -1; v <= 1; v++)
        for (int u = -1; u <= 1; u++)
          n += cells[(y + v + H) % H][(x + u + W) % W];
      n -= cells[y][x];
      next[y][x] = n == 3 || (n == 2 && cells[y][x]);
    }
  memcpy(cells, next, sizeof cells);
}
static unsigned left(unsigned x) { return x << 1 | x >> 31; }
static unsigned right(unsigned x) { return x >> 1 | x << 31; }
APART static void live_by_words(void) {
  for (int y = 0; y < H; y++) {
    unsigned ones = 0, twos = 0, fours = 0;
    for (int v = -1; v <= 1; v++) {
      unsigned row = rows[(y + v) & (H - 1)];
      const unsigned neighbours[3] = {left(row), v == 0 ? 0 : row, right(row)};
      for (int i = 0; i < 3; i++) {
        unsigned carry = ones & neighbours[i];
        ones ^= neighbours[i];
        fours |= twos & carry;
        twos ^= carry;
      }
    }
    after[y] = twos & ~fours & (ones | rows[y]);
  }
  memcpy(rows, after, sizeof rows);
}
APART static unsigned rule(unsigned row, unsigned char number) {
  unsigned result = 0;
  for (int i = 0; i < 32; i++)
    result |= (unsigned)(number >> ((left(row) >> i & 1) | (row >> i & 1) << 1 |
                                    (right(row) >> i & 1) << 2) &
                         1)
              << i;
  return result;
}
APART static int ant(int steps) {
  int x = W / 2, y = H / 2, direction = 0;
  static const signed char dx[] = {0, 1, 0, -1}, dy[] = {-1, 0, 1, 0};
  memset(cells, 0, sizeof cells);
  while (steps-- > 0) {
    direction = (direction + (cells[y][x] ? 3 : 1)) & 3;
    cells[y][x] ^= 1;
    x = (x + dx[direction]) & (W - 1);
    y = (y + dy[direction]) & (H - 1);
  }
  return y * W + x;
}
APART static int sand(int grains) {
  int topples = 0, moving = 1;
  memset(cells, 0, sizeof cells);
  cells[H / 2][W / 2] = (unsigned char)grains;
  while (moving) {
    moving = 0;
    for (int y = 1; y < H - 1; y++)
      for (int x = 1; x < W - 1; x++)
        while (cells[y][x] > 3) {
          cells[y][x] -= 4;
          cells[y][x - 1]++, cells[y][x + 1]++, cells[y - 1][x]++, cells[y + 1][x]++;
          topples++;
          moving = 1;
        }
  }
  return topples;
}
APART static int flood(int x, int y) {
  static short queue[W * H];
  int head = 0, tail = 0, farthest = 0;
  memset(next, 0, sizeof next);
  next[y][x] = 1;
  queue[tail++] = (short)(y * W + x);
  while (head < tail) {
    int at = queue[head++], cx = at % W, cy = at / W;
    farthest = next[cy][cx];
    for (int i = 0; i < 4; i++) {
      int u = cx + (i == 0) - (i == 1), v = cy + (i == 2) - (i == 3);
      if (u < 0 || v < 0 || u >= W || v >= H || cells[v][u] == 1 || next[v][u] != 0)
        continue;
      next[v][u] = (unsigned char)(farthest + 1);
      queue[tail++] = (short)(v * W + u);
    }
  }
  return tail * 100 + farthest;
}
static unsigned sum_of(void) {
  unsigned s = 0;
  for (int y = 0; y < H; y++)
    for (int x = 0; x < W; x++)
      s = mix(s, cells[y][x]);
  return s;
}

int main(void) {
  static const char* const glider[] = {".O.", "..O", "OOO"};
  unsigned state = 9, same = 0;
  for (int y = 0; y < H; y++)
    for (int x = 0; x < W; x++) {
      cells[y][x] = y < 3 && x < 3 ? glider[y][x] == 'O' : x > 12 && next_number(&state) % 3 == 0;
      rows[y] |= (unsigned)cells[y][x] << x;
    }
  for (int i = 0; i < 12; i++) {
    live();
    live_by_words();
    for (int y = 0; y < H; y++)
      for (int x = 0; x < W; x++)
        same += cells[y][x] == (rows[y] >> x & 1);
  }
  report("same", same);
  for (int y = 0; y < H; y += 3) {
    for (int x = 0; x < W; x++)
      putchar(cells[y][x] ? 'O' : '.');
    putchar('\n');
  }
  unsigned row = 1u << 16, s = 0;
  for (int i = 0; i < 20; i++)
    s = mix(s, row = rule(row, i < 10 ? 30 : 110));
  report("rules", s);
  report("ant", (unsigned)ant(2000));
  report("flood", (unsigned)flood(0, 0));
  report("sand", (unsigned)sand(200));
  report("cells", sum_of());
  return 0;
}
