/* Pointers that go through memory in even strides: columns of words and halves, of strides that are
 * known and that are not, forwards, backwards and on the spot, several loads a round; one round;
 * pointers that are wanted behind the loop; neighbours of what a step passes, with and without
 * stores beside. */
#include "report.h"

enum { ROWS = 24, COLUMNS = 12 };

static int words[ROWS][COLUMNS];
static short halves[ROWS][COLUMNS];
static unsigned short naturals[ROWS][COLUMNS];
static unsigned seed = 11;

__attribute__((noinline)) static int column(const int* p, int rows) {
  int sum = 0;
  for (int i = 0; i < rows; i++)
    sum = sum * 3 + p[i * COLUMNS];
  return sum;
}

__attribute__((noinline)) static int half_column(const short* p, int rows) {
  int sum = 0;
  for (int i = 0; i < rows; i++)
    sum = sum * 3 + p[i * COLUMNS];
  return sum;
}

__attribute__((noinline)) static unsigned natural_column(const unsigned short* p, int rows) {
  unsigned sum = 0;
  for (int i = 0; i < rows; i++)
    sum = sum * 3 + p[i * COLUMNS];
  return sum;
}

__attribute__((noinline)) static int any_stride(const int* p, int rounds, int stride) {
  int sum = 0;
  while (rounds-- > 0) {
    sum = sum * 5 ^ *p;
    p += stride;
  }
  return sum;
}

__attribute__((noinline)) static const short* where_it_ends(const short* p, int* sum) {
  int total = 0;
  for (int i = 0; i < 7; i++) {
    total += p[0] * p[6];
    p += 12;
  }
  *sum = total;
  return p;
}

__attribute__((noinline)) static int three_a_round(const int* p, int rounds) {
  int sum = 0;
  for (int i = 0; i < rounds; i++) {
    sum += p[0] ^ p[4] << 1 ^ p[8] << 2;
    p += 12;
  }
  return sum;
}

__attribute__((noinline)) static int neighbours(const short* p, int count) {
  int sum = 0;
  for (int i = 0; i < count; i++)
    sum += (p[i + 9] - p[i]) * (p[i + 3] + 1);
  return sum;
}

/* Each store is the next rounds' load. */
__attribute__((noinline)) static void along(short* p, int count) {
  for (int i = 0; i < count; i++)
    p[i + 4] = (short)(p[i] + p[i + 2] * 3);
}

__attribute__((noinline)) static void behind(int* p, const int* q, int count) {
  for (int i = 0; i < count; i++) {
    p[i] = q[i] + q[i + 1];
    p[i + 2] = q[i + 3];
  }
}

static unsigned checksum(void) {
  unsigned hash = 1;
  for (int i = 0; i < ROWS; i++)
    for (int j = 0; j < COLUMNS; j++)
      hash = hash * 31 + (unsigned)words[i][j] + (unsigned)halves[i][j];
  return hash;
}

int main(void) {
  int sum = 0;
  for (int i = 0; i < ROWS; i++)
    for (int j = 0; j < COLUMNS; j++) {
      words[i][j] = (int)next_number(&seed);
      halves[i][j] = (short)next_number(&seed);
      naturals[i][j] = (unsigned short)next_number(&seed);
    }
  for (int rows = 0; rows <= ROWS; rows += rows < 3 ? 1 : 7) {
    report("words", (unsigned)column(&words[0][5], rows));
    report("halves", (unsigned)half_column(&halves[0][3], rows));
    report("naturals", natural_column(&naturals[0][11], rows));
    report("three", (unsigned)three_a_round(&words[0][1], rows));
  }
  report("forwards", (unsigned)any_stride(&words[0][0], 20, 13));
  report("backwards", (unsigned)any_stride(&words[ROWS - 1][0], 20, -13));
  report("on the spot", (unsigned)any_stride(&words[4][4], 9, 0));
  report("end", (unsigned)(where_it_ends(&halves[2][1], &sum) - &halves[0][0]));
  report("sum", (unsigned)sum);
  report("neighbours", (unsigned)neighbours(&halves[0][0], 200));
  along(&halves[1][0], 50);
  behind(&words[0][0], &words[0][1], 60);
  behind(&words[10][3], &words[10][0], 60);
  report("memory", checksum());
  return 0;
}
