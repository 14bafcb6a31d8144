/* Arrays of variable length: in loops, of two dimensions, as parameters, their sizes, in recursion;
 * alloca; pointers to them. */
#include <setjmp.h>

#include "report.h"

APART static unsigned triangle(int n) {
  unsigned s = 0;
  for (int i = 1; i <= n; i++) {
    int row[i];
    row[0] = 1;
    for (int k = 1; k < i; k++)
      row[k] = row[k - 1] * (i - k) / k;
    for (int k = 0; k < i; k++)
      s = mix(s, (unsigned)row[k]);
    s += sizeof row;
  }
  return s;
}
APART static int sum(int rows, int columns, const short table[rows][columns]) {
  int s = 0;
  for (int y = 0; y < rows; y++)
    for (int x = 0; x < columns; x++)
      s = (s & 0xffff) * 3 + table[y][x];
  return s & 0xffffff;
}
APART static int two_dimensions(int rows, int columns) {
  short table[rows][columns], other[columns][rows];
  for (int y = 0; y < rows; y++)
    for (int x = 0; x < columns; x++)
      other[x][y] = table[y][x] = (short)(y * 10 - x);
  short(*second)[columns] = &table[1];
  return (sum(rows, columns, (const short(*)[columns])table) ^
          sum(columns, rows, (const short(*)[rows])other)) +
         (*second)[columns - 1] + (int)(sizeof table / sizeof *table);
}
APART static unsigned permute(int n, int depth, int* chosen) {
  if (depth == n) {
    unsigned s = 0;
    for (int i = 0; i < n; i++)
      s = s * 10 + (unsigned)chosen[i];
    return s;
  }
  unsigned total = 0;
  char used[n + 1];
  for (int i = 0; i <= n; i++)
    used[i] = 0;
  for (int i = 0; i < depth; i++)
    used[chosen[i]] = 1;
  for (int i = 1; i <= n; i++)
    if (!used[i]) {
      chosen[depth] = i;
      total = mix(total, permute(n, depth + 1, chosen));
    }
  return total;
}
APART static void reverse(char* text, int n) {
  char copy[n];
  for (int i = 0; i < n; i++)
    copy[i] = text[i];
  for (int i = 0; i < n; i++)
    text[i] = copy[n - 1 - i];
}
APART static unsigned from_the_stack(int n) {
  unsigned *blocks[6], s = 0;
  for (int i = 0; i < 6; i++) {
    blocks[i] = __builtin_alloca((unsigned)(n + i) * sizeof(unsigned));
    for (int k = 0; k < n + i; k++)
      blocks[i][k] = (unsigned)(i * 100 + k);
  }
  for (int i = 5; i >= 0; i--)
    for (int k = 0; k < n + i; k++)
      s = mix(s, blocks[i][k]);
  return s;
}
APART static unsigned left_early(int n) {
  unsigned s = 0;
  for (int i = 0; i < n; i++) {
    int room[i * 3 + 1];
    room[i] = i;
    if (i == 5)
      continue;
    int more[room[i] + 2];
    more[i] = room[i] * 2;
    s = mix(s, (unsigned)more[i]);
    if (s % 17 == 0)
      break;
  }
  return s;
}
/* Ends with a call that never comes back, below a frame whose size is not known. */
static jmp_buf back;
__attribute__((noinline, noreturn)) static void leave(int n) { longjmp(back, n); }
APART static void left_by_a_jump(int n) {
  unsigned char room[n];
  unsigned s = 0;
  for (int i = 0; i < n; i++)
    room[i] = (unsigned char)(i * 7);
  for (int i = n - 1; i >= 0; i--)
    s = mix(s, room[i]);
  if (s % 2 == 0)
    return;
  leave((int)(s % 100) + 1);
}

int main(void) {
  for (volatile int n = 5; n < 12; n++) {
    int code = setjmp(back);
    if (code == 0)
      left_by_a_jump(n);
    report("left", (unsigned)code);
  }
  report("triangle", triangle(12));
  report("table", (unsigned)(two_dimensions(3, 7) + two_dimensions(5, 1) + two_dimensions(2, 9)));
  int chosen[5];
  report("permute", permute(5, 0, chosen));
  char text[] = "variable length";
  reverse(text, 8);
  reverse(text + 3, 12);
  unsigned s = 0;
  for (int i = 0; i < 16; i++)
    s = mix(s, (unsigned char)text[i]);
  report("reverse", s);
  report("stack", from_the_stack(0) + from_the_stack(9));
  report("early", left_early(30));
  return 0;
}
