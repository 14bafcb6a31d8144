/* Indices and pointers that go round in circles: circindex and circptr, and what C says in their
 * place, from every start, in steps of both signs, two at once, nested, and where the start or the
 * count are such that nothing goes round. */
#include "report.h"

#ifdef __FINBACK__
#include <ccblkfn.h>
#else
static int circindex(int index, int step, unsigned count) {
  const int next = index + step;
  return next < 0 ? next + (int)count : next >= (int)count ? next - (int)count : next;
}
static void* circptr(const void* pointer, int step, const void* base, unsigned bytes) {
  return (char*)base + circindex((int)((const char*)pointer - (const char*)base), step, bytes);
}
#endif

#define COUNT(array) (sizeof(array) / sizeof *(array))

static short halves[16];
static int words[37];
static unsigned char bytes[29];
static short taps[24];

/* A delay line as C has it: the newest sample and those before it. */
APART int filter(const short* line, unsigned size, unsigned head, unsigned count) {
  int sum = 0;
  for (unsigned k = 0; k < count; ++k) {
    sum += taps[k] * line[head];
    if (++head == size)
      head = 0;
  }
  return sum;
}
APART int filter_back(const short* line, int size, int head, int count) {
  int sum = 0;
  for (int k = 0; k < count; ++k) {
    sum += taps[k] * line[head];
    head = head == 0 ? size - 1 : head - 1;
  }
  return sum;
}
APART int filter_below_zero(const short* line, int size, int head, int count) {
  int sum = 0;
  for (int k = 0; k < count; ++k) {
    sum += taps[k] * line[head];
    if (--head < 0)
      head = size - 1;
  }
  return sum;
}
APART int filter_masked(unsigned head, int count) {
  int sum = 0;
  for (int k = 0; k < count; ++k)
    sum += taps[k] * halves[(head - (unsigned)k) & 15];
  return sum;
}
APART unsigned step_masked(unsigned head, int count, unsigned* last) {
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    sum = mix(sum, (unsigned)halves[head & 15]);
    head = (head + 5) & 15;
  }
  *last = head;
  return sum;
}
APART unsigned step_remainder(unsigned head, unsigned size, int count) {
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    sum = mix(sum, (unsigned)words[head]);
    head = (head + 3) % size;
  }
  return mix(sum, head);
}
APART unsigned known_size(int head, int count) {
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    sum = mix(sum, (unsigned)words[head]);
    head = head + 7 < 37 ? head + 7 : head + 7 - 37;
  }
  return mix(sum, (unsigned)head);
}
APART unsigned of_bytes(unsigned head, int count) {
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    sum = 3 * sum + bytes[head];
    head = head + 1 < COUNT(bytes) ? head + 1 : 0;
  }
  return sum;
}

/* Written, read at both ends of the step, with one index for two arrays. */
APART int put(const int* from, int count, int head) {
  for (int k = 0; k < count; ++k) {
    words[head] = from[k];
    head = circindex(head, 1, COUNT(words));
  }
  return head;
}
APART unsigned before_and_behind(int head, int step, int count) {
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    const int old = words[head];
    head = circindex(head, step, COUNT(words));
    sum = mix(sum, (unsigned)(old - words[head]));
  }
  return mix(sum, (unsigned)head);
}
APART unsigned behind(int head, int count) {
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    head = circindex(head, -2, COUNT(words));
    sum = mix(sum, (unsigned)words[head]);
  }
  return sum;
}
APART int two_arrays(const short* a, short* restrict b, int head, int count) {
  int sum = 0;
  for (int k = 0; k < count; ++k) {
    sum += a[head];
    b[head] = (short)(a[head] + k);
    head = circindex(head, 1, 16);
  }
  return sum;
}

/* Two circles of different lengths, by pointers. */
APART unsigned two_circles(const int* a, int na, int sa, const short* b, int nb, int sb,
                           int count) {
  const int* at = a;
  const short* other = b;
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    sum += (unsigned)(*at * *other);
    at = circptr(at, sa * (int)sizeof *a, a, (unsigned)na * sizeof *a);
    other = circptr(other, sb * (int)sizeof *b, b, (unsigned)nb * sizeof *b);
  }
  return mix(sum, mix((unsigned)(at - a), (unsigned)(other - b)));
}
APART unsigned three_circles(int count) {
  const int *x = words, *y = words + 5, *z = words + 11;
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    sum = sum * 5 + (unsigned)(*x + 2 * *y - *z);
    x = circptr(x, 4, words, 5 * sizeof *words);
    y = circptr(y, 8, words + 5, 6 * sizeof *words);
    z = circptr(z, -4, words + 11, 26 * sizeof *words);
  }
  return sum;
}

/* A filter over samples: the outer loop steps the head, the inner one begins there. */
APART unsigned over_samples(const short* in, int count, unsigned size) {
  static short line[24];
  unsigned head = 0, sum = 0;
  for (int i = 0; i < count; ++i) {
    line[head] = in[i];
    sum = mix(sum, (unsigned)filter(line, size, head, size));
    int inside = 0;
    unsigned at = head;
    for (unsigned k = 0; k < size; ++k) {
      inside += taps[k] * line[at];
      at = at == 0 ? size - 1 : at - 1;
    }
    sum = mix(sum, (unsigned)inside);
    head = head + 1 == size ? 0 : head + 1;
  }
  return sum;
}

/* Divisions, which are calls, in front of the loop and behind it, and for the first step of a ring
 * that is read behind its steps. */
APART unsigned mean(unsigned head, unsigned size, unsigned other, unsigned divisor, int count) {
  unsigned sum = divisor / (head + 1);
  for (int k = 0; k < count; ++k) {
    sum += (unsigned)words[head];
    head = head + 1 < size ? head + 1 : 0;
    other = (other + 7) % size;
    sum ^= (unsigned)words[other];
  }
  return sum / divisor + sum % (head + 2);
}

/* No circle: the start lies beyond the end that is asked for, and never meets it. */
APART unsigned beyond(const int* from, unsigned size, unsigned at, int count) {
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    sum = mix(sum, (unsigned)from[at]);
    if (++at == size)
      at = 0;
  }
  return sum;
}
/* A way out in between. */
APART int find(int head, int wanted) {
  for (int k = 0; k < 37; ++k) {
    if (words[head] == wanted)
      return head;
    head = circindex(head, 1, 37);
  }
  return -1;
}
/* Calls in between. */
APART unsigned with_calls(int head, int count) {
  unsigned sum = 0;
  for (int k = 0; k < count; ++k) {
    sum = mix(sum, (unsigned)filter(halves, 16, (unsigned)words[head] & 15, 5));
    head = circindex(head, 1, 37);
  }
  return sum;
}

int main(void) {
  unsigned sum = 0, last = 0;
  for (unsigned i = 0; i < COUNT(words); ++i)
    words[i] = (int)(i * i * 77 + 3);
  for (unsigned i = 0; i < COUNT(halves); ++i)
    halves[i] = (short)(1000 - 333 * (int)i);
  for (unsigned i = 0; i < COUNT(bytes); ++i)
    bytes[i] = (unsigned char)(i * 37);
  for (unsigned i = 0; i < COUNT(taps); ++i)
    taps[i] = (short)(40 - 7 * (int)i);
  for (unsigned head = 0; head < 16; ++head)
    for (unsigned count = 0; count < 24; count += 1 + head % 3) {
      sum = mix(sum, (unsigned)filter(halves, 16, head, count));
      sum = mix(sum, (unsigned)filter_back(halves, 16, (int)head, (int)count));
      sum = mix(sum, (unsigned)filter_below_zero(halves, 16, (int)head, (int)count));
      sum = mix(sum, (unsigned)filter_masked(head + 48, (int)count));
      sum = mix(sum, step_masked(head * 7, (int)count, &last));
      sum = mix(sum, last);
      sum = mix(sum, of_bytes(head + 10, (int)count));
    }
  report("delay lines", sum);
  for (int head = 0; head < 37; ++head) {
    sum = mix(sum, step_remainder((unsigned)head % 11, 11, head + 9));
    sum = mix(sum, step_remainder((unsigned)head, 37, head + 9));
    sum = mix(sum, step_remainder(0, 1 + (unsigned)head % 4, head));
    sum = mix(sum, known_size(head, 20));
    sum = mix(sum, mean((unsigned)head, 37, (unsigned)head / 2, 3 + (unsigned)head, 30 + head));
    for (int step = -37; step <= 37; step += 5)
      sum = mix(sum, before_and_behind(head, step, 41));
    sum = mix(sum, behind(head, 50));
    sum = mix(sum, (unsigned)find(head, words[(head * 5 + 3) % 37]));
    sum = mix(sum, with_calls(head, 6));
  }
  report("steps", sum);
  static short copy[16];
  for (int head = 0; head < 16; ++head)
    sum = mix(sum, (unsigned)two_arrays(halves, copy, head, 7 + head));
  for (unsigned i = 0; i < COUNT(copy); ++i)
    sum = mix(sum, (unsigned)copy[i]);
  report("two arrays", sum);
  for (int step = -9; step <= 9; ++step)
    sum = mix(sum, two_circles(words, 9 + (step & 15), step, halves, 16, 2 - step, 60));
  report("two circles", mix(sum, three_circles(70)));
  report("over samples", over_samples((const short*)halves, 16, 7));
  static int much[60];
  for (int i = 0; i < 60; ++i)
    much[i] = i * 91;
  for (unsigned at = 0; at < 12; ++at)
    sum = mix(sum, beyond(much, 7, at, 40));
  report("beyond", sum);
  int head = 30;
  for (int count = 0; count < 38; count += 4)
    head = put(much + count / 4, count, head);
  for (unsigned i = 0; i < COUNT(words); ++i)
    sum = mix(sum, (unsigned)words[i]);
  report("put", mix(sum, (unsigned)head));
  return 0;
}
