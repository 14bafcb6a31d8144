/* memcpy, memmove, memset and memcmp with sizes that the compiler knows and with those it does not,
 * at all alignments, overlapping both ways; copies by hand that overlap; structs copied over
 * themselves. */
#include <string.h>

#include "report.h"

static unsigned char memory[160], other[160];

static unsigned sum_of(const unsigned char* p) {
  unsigned s = 0;
  for (int i = 0; i < 160; i++)
    s = mix(s, p[i]);
  return s;
}
static void fill(unsigned by) {
  for (unsigned i = 0; i < 160; i++) {
    memory[i] = (unsigned char)(i * by);
    other[i] = (unsigned char)(i ^ by);
  }
}
#define OF(n)                                                                        \
  APART static unsigned of_##n(unsigned char* to, const unsigned char* from) {       \
    memcpy(to, from, n);                                                             \
    memmove(to + 3, to, n);                                                          \
    memmove(to + 40, to + 42, n);                                                    \
    memset(to + 80 - n, n, n);                                                       \
    return (unsigned)(memcmp(to, from, n) > 0) + 2 * (memcmp(to + 3, from, n) == 0); \
  }
OF(1)
OF(2)
OF(3)
OF(4)
OF(7)
OF(8)
OF(13)
OF(16)
OF(31)
OF(33)
static unsigned (*const functions[])(unsigned char*, const unsigned char*) = {
    of_1, of_2, of_3, of_4, of_7, of_8, of_13, of_16, of_31, of_33};

APART static void by_bytes(unsigned char* to, const unsigned char* from, int n) {
  for (int i = 0; i < n; i++)
    to[i] = from[i];
}
APART static void by_bytes_down(unsigned char* to, const unsigned char* from, int n) {
  while (n-- > 0)
    to[n] = from[n];
}
APART static void by_halves(unsigned short* to, const unsigned short* from, int n) {
  for (int i = 0; i < n; i++)
    to[i] = from[i];
}
APART static void by_words(unsigned* to, const unsigned* from, int n) {
  do
    *to++ = *from++;
  while (--n > 0);
}
APART static void cleared(unsigned char* p, int n) {
  for (int i = 0; i < n; i++)
    p[i] = 0;
}
APART static void reversed(unsigned char* p, int n) {
  for (int i = 0; i < n / 2; i++) {
    unsigned char t = p[i];
    p[i] = p[n - 1 - i];
    p[n - 1 - i] = t;
  }
}
struct block {
  unsigned char b[24];
};
APART static void move_struct(struct block* to, const struct block* from) { *to = *from; }

int main(void) {
  unsigned s = 0;
  for (int k = 0; k < 10; k++)
    for (int to = 0; to < 4; to++)
      for (int from = 0; from < 4; from++) {
        fill((unsigned)(k + to));
        s = mix(s, functions[k](memory + to, other + from));
        s = mix(s, sum_of(memory));
      }
  report("known", s);
  for (int n = 0; n < 40; n++)
    for (int d = -9; d < 10; d += 3) {
      fill(37);
      memmove(memory + 60 + d, memory + 60, (size_t)n);
      memcpy(other + n % 7, memory + 20, (size_t)n);
      memset(other + 100 + d, n, (size_t)(n + d > 0 ? n + d : 0));
      s = mix(s, sum_of(memory) + sum_of(other));
    }
  report("unknown", s);
  for (int d = 1; d < 6; d++) {
    fill(11);
    by_bytes(memory + d, memory, 50);
    by_bytes(memory + 60, memory + 60 + d, 50);
    by_bytes_down(other + d, other, 50);
    by_bytes_down(other + 60, other + 60 + d, 50);
    s = mix(s, sum_of(memory) + sum_of(other));
    static unsigned short halves[60];
    static unsigned words[40];
    for (int i = 0; i < 60; i++)
      halves[i] = (unsigned short)(i * 777);
    for (int i = 0; i < 40; i++)
      words[i] = (unsigned)i * 0x1010101u;
    by_halves(halves + d, halves, 40);
    by_words(words, words + d, 30);
    by_words(words + d, words, 20);
    for (int i = 0; i < 40; i++)
      s = mix(s, halves[i] + words[i]);
    cleared(memory + d, d * 5);
    reversed(memory, 100 + d);
    s = mix(s, sum_of(memory));
  }
  report("by hand", s);
  struct block blocks[3] = {{"first block of bytes"}, {"second"}, {"third"}};
  move_struct(&blocks[1], &blocks[0]);
  move_struct(&blocks[2], &blocks[2]);
  report("structs",
         (unsigned)(memcmp(&blocks[0], &blocks[1], sizeof *blocks) == 0) + blocks[2].b[3] * 2u);
  return 0;
}
