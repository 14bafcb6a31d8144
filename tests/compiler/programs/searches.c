/* Loops that go on until they find something, which are left from each of their rounds: with one
 * question and with several, forwards and backwards, that store, that are found at once or never. */
#include <stdint.h>

#include "report.h"

static int32_t words[40];
static char text[40];

APART static int first_not_below(const int32_t* at, int32_t limit) {
  const int32_t* from = at;
  while (*at < limit)
    ++at;
  return (int)(at - from);
}

APART static int last_not_above(const int32_t* end, int32_t limit) {
  const int32_t* at = end;
  while (*--at > limit) {
  }
  return (int)(end - at);
}

APART static int length(const char* s) {
  int n = 0;
  while (s[n] != 0)
    ++n;
  return n;
}

APART static int place_of(const char* s, char wanted) {
  for (const char* at = s; *at != 0; ++at)
    if (*at == wanted)
      return (int)(at - s);
  return -1;
}

APART static int differ_at(const char* a, const char* b) {
  int n = 0;
  while (*a != 0 && *a == *b) {
    ++a;
    ++b;
    ++n;
  }
  return 1000 * n + *a - *b;
}

APART static void insert(int32_t* begin, int32_t* to) {
  const int32_t value = *to;
  while (to > begin && to[-1] > value) {
    *to = to[-1];
    --to;
  }
  *to = value;
}

/* What is looked for moves as it is looked for. */
APART static unsigned collatz(const uint8_t* odd, unsigned n) {
  unsigned steps = 0;
  while (n != 1) {
    n = odd[n & 1] != 0 ? 3 * n + 1 : n / 2;
    ++steps;
  }
  return steps;
}

APART static unsigned chain(const uint8_t* next, uint8_t at, uint8_t until) {
  unsigned sum = 0;
  do {
    sum = sum * 3 + at;
    at = next[at];
  } while (at != until);
  return sum;
}

int main(void) {
  for (int i = 0; i < 39; ++i) {
    words[i] = 10 * i - 100;
    text[i] = (char)('a' + i % 26);
  }
  words[39] = INT32_MAX;
  for (int limit = -110; limit < 300; limit += 37) {
    report("not below", (unsigned)first_not_below(words, limit));
    report("not above", (unsigned)last_not_above(words + 39, limit < -100 ? -100 : limit));
  }
  for (int n = 0; n < 39; n += 1) {
    const char kept = text[n];
    text[n] = 0;
    report("length", (unsigned)length(text));
    report("place", (unsigned)place_of(text, (char)('a' + n / 2)));
    report("differ", (unsigned)differ_at(text + n / 3, n % 2 == 0 ? "abcdef" : text));
    text[n] = kept;
  }
  unsigned seed = 7;
  for (int i = 0; i < 40; ++i) {
    seed = seed * 1103515245U + 12345U;
    words[i] = (int32_t)(seed >> 8) % 100;
    insert(words, words + i);
  }
  unsigned sum = 0;
  for (int i = 0; i < 40; ++i)
    sum = mix(sum, (unsigned)words[i]);
  report("sorted", sum);
  static const uint8_t odd[2] = {0, 1};
  static const uint8_t next[8] = {3, 0, 7, 5, 1, 6, 2, 4};
  for (unsigned n = 1; n < 30; ++n)
    report("steps", collatz(odd, n));
  for (uint8_t at = 0; at < 8; ++at)
    report("chain", chain(next, at, 4));
  return 0;
}
