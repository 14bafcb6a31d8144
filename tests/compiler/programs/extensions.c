/* GNU C: statement expressions, typeof, __auto_type, omitted operands, local labels, choices at
 * compile time, nested ranges, attributes that change what is generated: cleanup, weak, alias by
 * macro, pure. */
#include "report.h"

#define MAX(a, b)                    \
  ({                                 \
    __typeof__(a) left_ = (a);       \
    __typeof__(b) right_ = (b);      \
    left_ > right_ ? left_ : right_; \
  })
#define SWAP(a, b)           \
  do {                       \
    __auto_type kept_ = (a); \
    (a) = (b);               \
    (b) = kept_;             \
  } while (0)
#define FIND(array, count, what)         \
  ({                                     \
    __label__ done;                      \
    int at_ = -1;                        \
    for (int i_ = 0; i_ < (count); i_++) \
      if ((array)[i_] == (what)) {       \
        at_ = i_;                        \
        goto done;                       \
      }                                  \
  done:                                  \
    at_;                                 \
  })
#define SIZE_KIND(x) \
  __builtin_choose_expr(sizeof(x) == 1, 1, __builtin_choose_expr(sizeof(x) == 4, 4, 99))

static int calls, released;
static void release(int* p) { released = released % 100000 * 10 + *p; }
static void close_all(const char* const* p) { released += **p; }
APART static int next(void) { return ++calls; }
__attribute__((weak)) int overridable(int x) { return x + 1; }
__attribute__((const, noinline)) static int constant(int x) { return x * x; }
__attribute__((pure, noinline)) static int pure(const int* p) { return p[0] + p[1]; }
__attribute__((always_inline)) static inline int inlined(int x) { return x & 1 ? x : -x; }
__attribute__((cold, noinline)) static int cold(int x) { return x - 100; }
__attribute__((hot, used)) static int hot(int x) { return x + 100; }
static int __attribute__((unused)) not_used(void) { return 5; }
typedef int __attribute__((aligned(1))) unaligned_int;
typedef unsigned __attribute__((may_alias)) any_unsigned;

APART static int cleaned(int n) {
  int first __attribute__((cleanup(release))) = n;
  for (int i = 0; i < 3; i++) {
    int inner __attribute__((cleanup(release))) = i + 1;
    const char* name __attribute__((cleanup(close_all))) = "z";
    if (i == n)
      continue;
    if (i + n == 7)
      return inner;
    (void)name;
  }
  return first;
}
APART static int expected(int x) {
  if (__builtin_expect(x < 0, 0))
    return cold(x);
  if (__builtin_expect(x > 100, 1))
    return hot(x);
  return __builtin_constant_p(x) ? 0 : x;
}
APART static int unreachable(int x) {
  switch (x & 3) {
    case 0:
      return 5;
    case 1:
      return 7;
    case 2:
      return 11;
    case 3:
      return 13;
  }
  __builtin_unreachable();
}
APART static unsigned misaligned(const char* p) {
  return *(const unaligned_int*)(p + 1) + *(const unaligned_int*)(p + 2);
}
APART static unsigned bits_of(float f) { return *(any_unsigned*)&f; }

/* Objects without bytes. */
struct nothing {};
struct nothing nothing;
static struct nothing nothing_more;
__attribute__((noinline)) static int nothing_at(struct nothing *at) {
  nothing_more = *at;
  return at == &nothing ? 2 : 3;
}

int main(void) {
  report("max", (unsigned)(MAX(next(), 0) + MAX(3, next() * 2) * 10 + calls * 1000));
  int a = 5, b = -6;
  SWAP(a, b);
  report("swap", (unsigned)(a * 100 + b));
  static const short numbers[] = {4, 8, 15, 16, 23, 42};
  report("find", (unsigned)(FIND(numbers, 6, 16) * 10 + FIND(numbers, 6, 5)));
  report("kinds", (unsigned)(SIZE_KIND('c') + SIZE_KIND((char)1) * 10 + SIZE_KIND(1ll) * 100));
  report("types", (unsigned)(__builtin_types_compatible_p(int, signed) +
                             2 * __builtin_types_compatible_p(int, short)));
  report("omitted", (unsigned)((next() ?: 50) + (0 ?: 7) + calls * 100));
  for (int i = 0; i < 6; i++)
    report("cleaned", (unsigned)(cleaned(i) + released * 10));
  report("weak", (unsigned)overridable(1));
  int p[] = {1, 2};
  int twice = pure(p) + constant(3);
  p[0] = 10;
  report("pure", (unsigned)(twice + pure(p) * 100 + constant(3) + inlined(8)));
  report("expected", (unsigned)(expected(-5) + expected(500) * 2 + expected(50)));
  unsigned s = 0;
  for (int i = 0; i < 8; i++)
    s = mix(s, (unsigned)unreachable(i));
  report("unreachable", s + misaligned("\1\2\3\4\5\6\7") + bits_of(1.5f));
  report("statement", (unsigned)({
                        int x = 3;
                        x += 4;
                        x;
                      }) + sizeof(__typeof__(numbers)));
  report("nothing", (unsigned)(nothing_at(&nothing) + (&nothing != &nothing_more)));
  return 0;
}
