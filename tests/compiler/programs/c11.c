/* What C11 added and C99 before it: static assertions, generic selections, alignment, functions
 * that do not return, restrict, inline, static array parameters, declarations in for, __func__,
 * _Pragma. */
#include <limits.h>
#include <setjmp.h>
#include <stdalign.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdnoreturn.h>

#include "report.h"

_Static_assert(sizeof(int) == 4 && CHAR_BIT == 8, "int has 32 bits");
_Static_assert(INT_MAX == 2147483647 && INT64_MAX == LLONG_MAX, "limits");
_Static_assert((int8_t)200 == -56 && UINT16_MAX == 0xffff, "exact widths");

#define NAME_OF(x)                                                                                \
  _Generic((x), char : 1, signed char : 2, unsigned char : 3, short : 4, unsigned short : 5,      \
           int : 6, unsigned : 7, long long : 8, unsigned long long : 9, float : 10, double : 11, \
           _Bool : 12, char* : 13, const char* : 14, int* : 15, void* : 16, default : 17)
#define MAGNITUDE(x) _Generic((x), double : of_double, float : of_double, default : of_int)(x)

static int of_int(int x) { return x < 0 ? -x : x; }
static int of_double(double x) { return (int)((x < 0 ? -x : x) * 10); }

static jmp_buf back;
APART noreturn static void leave(int with) { longjmp(back, with); }
APART static int left(int x) {
  int code = setjmp(back);
  if (code != 0)
    return code + x;
  leave(x * 2);
}

struct aligned {
  char a;
  alignas(8) char b;
  _Alignas(short) char c;
  struct {
    int inside;
  };
};
static alignas(16) char buffer[20];

APART static void add(int n, int* restrict to, const int* restrict from) {
  for (int i = 0; i < n; i++)
    to[i] += from[i] * to[0];
}
APART static int at_least(const int p[static 4], const int fixed[const 2]) {
  return p[3] + fixed[1];
}
static inline int twice(int x) { return 2 * x; }
extern inline int thrice(int x);
inline int thrice(int x) { return 3 * x; }

int main(void) {
  char c = 'c', *text = &c;
  const char* constant = text;
  short h = 1;
  unsigned char b = 2;
  int i = 3;
  report("names",
         (unsigned)(NAME_OF(c) + 100 * NAME_OF(h) + 10000 * NAME_OF(b) + 1000000 * NAME_OF(i)));
  report("promoted", (unsigned)(NAME_OF(c + c) + 100 * NAME_OF(h * 1u) +
                                10000 * NAME_OF(b ? 1ll : 0) + 1000000 * NAME_OF(1.f + i)));
  report("pointers", (unsigned)(NAME_OF(text) + 100 * NAME_OF(constant) + 10000 * NAME_OF(&i) +
                                1000000 * NAME_OF((void*)0)));
  report("others", (unsigned)(NAME_OF((bool)1) + 100 * NAME_OF("s") + 10000 * NAME_OF(1.0) +
                              1000000 * NAME_OF(&h)));
  report("magnitude", (unsigned)(MAGNITUDE(-5) + MAGNITUDE(-2.5) + MAGNITUDE(1.5f)));
  report("left", (unsigned)left(7));
  report("aligned",
         (unsigned)(offsetof(struct aligned, b) * 1000 + offsetof(struct aligned, c) * 100 +
                    alignof(struct aligned) * 10 + sizeof(struct aligned) / 8));
  report("buffer",
         (unsigned)((uintptr_t)buffer % 16) + alignof(int) * 10 + (unsigned)sizeof buffer);
  alignas(32) int local[3] = {1, 2, 3};
  report("local", (unsigned)((uintptr_t)local % 32) + (unsigned)local[2]);
  int numbers[4] = {2, 3, 4, 5}, more[4] = {1, 1, 2, 2};
  add(4, numbers, more);
  report("restrict", (unsigned)(numbers[0] * 1000 + numbers[3] * 10 + at_least(numbers, more)));
  report("inline", (unsigned)(twice(5) + thrice(7)));
  unsigned s = 0;
  for (const char* p = __func__; *p; p++)
    s = mix(s, (unsigned char)*p);
  report("func", s);
  _Pragma("GCC diagnostic push") report("pragma", true + false);
  _Pragma("GCC diagnostic pop");
  /* main returns 0 here, C11 5.1.2.2.3 */
}
