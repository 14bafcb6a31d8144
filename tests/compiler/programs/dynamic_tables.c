/* Problems solved by tables: distance of words, longest common parts, the knapsack, coins,
 * partitions, chains of matrices, a triangle's best way. */
#include <string.h>

#include "report.h"

static int least(int a, int b) { return a < b ? a : b; }
static int most(int a, int b) { return a > b ? a : b; }

APART static int distance(const char* a, const char* b) {
  unsigned char row[40];
  int n = (int)strlen(b);
  for (int j = 0; j <= n; j++)
    row[j] = (unsigned char)j;
  for (int i = 1; a[i - 1] != 0; i++) {
    int corner = row[0];
    row[0] = (unsigned char)i;
    for (int j = 1; j <= n; j++) {
      int above = row[j];
      row[j] = (unsigned char)least(least(row[j - 1], above) + 1, corner + (a[i - 1] != b[j - 1]));
      corner = above;
    }
  }
  return row[n];
}
APART static int common(const char* a, const char* b, char* out) {
  static short table[32][32];
  int n = (int)strlen(a), m = (int)strlen(b), length;
  for (int i = 1; i <= n; i++)
    for (int j = 1; j <= m; j++)
      table[i][j] = a[i - 1] == b[j - 1] ? (short)(table[i - 1][j - 1] + 1)
                                         : (short)most(table[i - 1][j], table[i][j - 1]);
  length = table[n][m];
  for (int i = n, j = m, k = length; k > 0;) {
    if (a[i - 1] == b[j - 1]) {
      out[--k] = a[--i];
      j--;
    } else if (table[i - 1][j] >= table[i][j - 1]) {
      i--;
    } else {
      j--;
    }
  }
  out[length] = 0;
  return length;
}
APART static int knapsack(const int* weights, const int* values, int n, int room) {
  int best[60] = {0};
  for (int i = 0; i < n; i++)
    for (int w = room; w >= weights[i]; w--)
      best[w] = most(best[w], best[w - weights[i]] + values[i]);
  return best[room];
}
APART static unsigned coins(unsigned amount, unsigned* fewest) {
  static const unsigned char kinds[] = {1, 2, 5, 10, 20, 50};
  unsigned ways[101] = {1}, count[101] = {0};
  for (unsigned k = 0; k < sizeof kinds; k++)
    for (unsigned a = kinds[k]; a <= amount; a++) {
      ways[a] += ways[a - kinds[k]];
      if (count[a] == 0 || count[a - kinds[k]] + 1 < count[a])
        count[a] = count[a - kinds[k]] + 1;
    }
  *fewest = count[amount];
  return ways[amount];
}
APART static unsigned long long partitions(int n) {
  unsigned long long p[91] = {1};
  for (int part = 1; part <= n; part++)
    for (int i = part; i <= n; i++)
      p[i] += p[i - part];
  return p[n];
}
APART static int chain(const short* sizes, int n) {
  int cost[10][10] = {{0}};
  for (int length = 1; length < n; length++)
    for (int i = 0; i + length < n; i++) {
      int best = 0x7fffffff;
      for (int k = i; k < i + length; k++)
        best = least(best, cost[i][k] + cost[k + 1][i + length] +
                               sizes[i] * sizes[k + 1] * sizes[i + length + 1]);
      cost[i][i + length] = best;
    }
  return cost[0][n - 1];
}
APART static int triangle(int rows, unsigned state) {
  int best[20], next[20];
  for (int i = 0; i < 20; i++)
    best[i] = 0;
  for (int row = 1; row <= rows; row++) {
    for (int i = 0; i < row; i++)
      next[i] = (int)(next_number(&state) % 100) + (row == 1       ? 0
                                                    : i == 0       ? best[0]
                                                    : i == row - 1 ? best[i - 1]
                                                                   : most(best[i - 1], best[i]));
    memcpy(best, next, (unsigned)row * sizeof *best);
  }
  int largest = 0;
  for (int i = 0; i < rows; i++)
    largest = most(largest, best[i]);
  return largest;
}
APART static int longest_increase(const int* p, int n) {
  int ends[50], length = 0;
  for (int i = 0; i < n; i++) {
    int low = 0, high = length;
    while (low < high) {
      int middle = (low + high) / 2;
      if (ends[middle] < p[i])
        low = middle + 1;
      else
        high = middle;
    }
    ends[low] = p[i];
    length += low == length;
  }
  return length;
}

int main(void) {
  report("distance", (unsigned)(distance("kitten", "sitting") + distance("", "abc") * 10 +
                                distance("intention", "execution") * 100));
  char text[32];
  unsigned s = (unsigned)common("the common part of these", "another common start there", text);
  for (char* p = text; *p; p++)
    s = mix(s, (unsigned char)*p);
  report("common", s);
  static const int weights[] = {12, 2, 1, 4, 1, 9, 7, 13}, values[] = {4, 2, 1, 10, 2, 8, 11, 15};
  for (int room = 0; room < 60; room += 7)
    s = mix(s, (unsigned)knapsack(weights, values, 8, room));
  report("knapsack", s);
  unsigned fewest;
  report("coins", coins(100, &fewest) * 100 + fewest);
  report("partitions", mix_long(0, partitions(90)));
  static const short sizes[] = {30, 35, 15, 5, 10, 20, 25};
  report("chain", (unsigned)chain(sizes, 6));
  report("triangle", (unsigned)triangle(20, 5));
  int numbers[50];
  unsigned state = 9;
  for (int i = 0; i < 50; i++)
    numbers[i] = (int)(next_number(&state) % 1000);
  report("increase", (unsigned)longest_increase(numbers, 50));
  return 0;
}
