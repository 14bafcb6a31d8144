/* Every compound assignment on objects of every width, through pointers, members and indices that
 * are evaluated once; increments and decrements, before and after, and their values. */
#include "report.h"

typedef signed char i8;
typedef unsigned char u8;
typedef short i16;
typedef unsigned short u16;
typedef unsigned u32;
typedef long long i64;

#define ON(type)                                          \
  APART static unsigned on_##type(type* p, int n) {       \
    unsigned s = 0;                                       \
    s = mix_long(s, (unsigned long long)(*p += (type)n)); \
    s = mix_long(s, (unsigned long long)(*p -= 3));       \
    s = mix_long(s, (unsigned long long)(*p *= 5));       \
    s = mix_long(s, (unsigned long long)(*p /= 7));       \
    s = mix_long(s, (unsigned long long)(*p ^= 0x55));    \
    s = mix_long(s, (unsigned long long)(*p |= 8));       \
    s = mix_long(s, (unsigned long long)(*p &= 0x7f));    \
    s = mix_long(s, (unsigned long long)(*p %= 50));      \
    s = mix_long(s, (unsigned long long)(*p <<= 1));      \
    s = mix_long(s, (unsigned long long)(*p >>= n & 3));  \
    s = mix_long(s, (unsigned long long)(*p)++);          \
    s = mix_long(s, (unsigned long long)++(*p));          \
    s = mix_long(s, (unsigned long long)(*p)--);          \
    return mix_long(s, (unsigned long long)--(*p));       \
  }
ON(i8)
ON(u8)
ON(i16)
ON(u16)
ON(u32)
ON(i64)

static int calls;
APART static int next(void) { return calls++; }

struct cell {
  short values[4];
  struct cell* other;
};

APART static unsigned through(struct cell* cell) {
  cell->values[next() & 3] += 7;
  cell->other->values[next() & 3] -= 9;
  (&cell->values[2])[-(next() & 1)] *= 3;
  *(next() & 1 ? &cell->values[0] : &cell->other->values[3]) ^= 0x1234;
  cell->other->other->values[cell->values[0] & 3]++;
  return (unsigned)calls;
}

APART static unsigned pointers(int* p, int n) {
  int* start = p;
  *p++ = n;
  *p++ += *start;
  *++p = 7;
  (*p)++;
  int first = *p--, second = *--p;
  p += 2;
  p -= 1;
  *p = first - second;
  return (unsigned)(p - start);
}

#define CHECK(type)                      \
  {                                      \
    type object = 11;                    \
    unsigned s = 0;                      \
    for (int i = -9; i < 30; i += 2)     \
      s = mix(s, on_##type(&object, i)); \
    report(#type, s);                    \
  }

int main(void) {
  CHECK(i8)
  CHECK(u8)
  CHECK(i16)
  CHECK(u16)
  CHECK(u32)
  CHECK(i64)
  struct cell a = {{1, 2, 3, 4}, 0}, b = {{-1, -2, -3, -4}, &a};
  a.other = &b;
  unsigned s = 0;
  for (int i = 0; i < 9; i++)
    s = mix(s, through(i & 1 ? &a : &b));
  for (int i = 0; i < 4; i++)
    s = mix(mix(s, (unsigned)a.values[i]), (unsigned)b.values[i]);
  report("through", s);
  int numbers[6] = {0, 1, 2, 3, 4, 5};
  s = pointers(numbers, 40);
  for (int i = 0; i < 6; i++)
    s = mix(s, (unsigned)numbers[i]);
  report("pointers", s);
  return 0;
}
