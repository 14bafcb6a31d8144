/* Several accesses a pass through one pointer, near and far, in order and not, over memory that
 * they share. */
#include "report.h"

static int words[400];
static short halves[400];
static unsigned char bytes[400];

static void fill(unsigned seed) {
  for (int i = 0; i < 400; ++i) {
    words[i] = (int)next_number(&seed);
    halves[i] = (short)next_number(&seed);
    bytes[i] = (unsigned char)next_number(&seed);
  }
}
static void tell(const char* name) {
  unsigned sum = 0;
  for (int i = 0; i < 400; ++i)
    sum = mix(mix(mix(sum, (unsigned)words[i]), (unsigned)halves[i]), bytes[i]);
  report(name, sum);
}

__attribute__((noinline)) static int* pairs(int* p, int n) {
  do {
    const int a = p[0], b = p[1];
    p[0] = a + b;
    p[1] = a - b;
    p += 2;
  } while (--n);
  return p;
}
__attribute__((noinline)) static void backwards_in_a_pass(int* to, const int* from, int n) {
  for (int i = 0; i < n; ++i) {
    to[3] = from[0];
    to[2] = from[1];
    to[1] = from[2];
    to[0] = from[3];
    to += 4;
    from += 4;
  }
}
/* The second store may hit what the first has written, and the loads both. */
__attribute__((noinline)) static void crossing(int* a, int* b, int n) {
  for (int i = 0; i < n; ++i) {
    a[1] = b[0] + 1;
    b[1] = a[0] + 2;
    a[0] = b[1] ^ 3;
    b[0] = a[1] ^ 4;
    a += 2;
    b += 2;
  }
}
__attribute__((noinline)) static int far(const int* p, int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i, ++p)
    sum += p[0] * 3 ^ p[128] ^ p[200] * 5;
  return sum;
}
__attribute__((noinline)) static void far_and_stored(int* p, int n) {
  for (int i = 0; i < n; ++i, ++p)
    p[128] = p[0] + p[1] + p[127];
}
__attribute__((noinline)) static int gaps(const short* p, int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i, p += 3)
    sum = sum * 31 + p[0] - p[2];
  return sum;
}
__attribute__((noinline)) static const short* three_halves(const short* p, int n, int* out) {
  int sum = 0;
  for (int i = 0; i < n; ++i, p += 3)
    sum += p[0] * 7 - p[1] * 5 + (unsigned short)p[2];
  *out = sum;
  return p;
}
__attribute__((noinline)) static void some_bytes(unsigned char* p, int n) {
  for (int i = 0; i < n; ++i, p += 4) {
    const unsigned char first = p[0];
    p[0] = p[3];
    p[3] = p[1];
    p[1] = p[2];
    p[2] = first;
  }
}
/* The pointer is stored, and read once more. */
__attribute__((noinline)) static int kept(int** slots, int* p, int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i, p += 2) {
    slots[0] = p;
    slots[1] = p + 1;
    sum += p[0] - p[1];
    slots += 2;
  }
  return sum;
}
__attribute__((noinline)) static unsigned ordered(volatile int* p, int n) {
  unsigned sum = 0;
  for (int i = 0; i < n; ++i, p += 2) {
    sum = sum * 3 + (unsigned)p[1];
    p[0] = (int)sum;
  }
  return sum;
}

int main(void) {
  static int* slots[80];
  int sum = 0;
  fill(1);
  report("pairs", (unsigned)(pairs(words + 10, 60) - words));
  report("one", (unsigned)(pairs(words, 1) - words));
  tell("after pairs");
  for (int distance = -6; distance <= 6; ++distance) {
    backwards_in_a_pass(words + 100 + distance, words + 100, 20);
    crossing(words + 200, words + 200 + distance, 20);
  }
  tell("overlapping");
  report("far", (unsigned)far(words, 150));
  far_and_stored(words, 200);
  tell("stored");
  report("gaps", (unsigned)gaps(halves, 100));
  report("halves", (unsigned)(three_halves(halves, 77, &sum) - halves));
  report("sum", (unsigned)sum);
  some_bytes(bytes + 1, 80);
  tell("bytes");
  report("kept", (unsigned)kept(slots, words, 30));
  for (int i = 0; i < 60; ++i)
    sum = sum * 5 + (int)(slots[i] - words);
  report("slots", (unsigned)sum);
  report("ordered", ordered(words, 100));
  tell("end");
  return 0;
}
