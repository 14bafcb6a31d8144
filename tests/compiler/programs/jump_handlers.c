/* setjmp as programs use it: exceptions by macros, handlers in handlers, rethrown, out of loops on
 * the loop counters, out of a comparison of qsort, through pointers to functions, coroutine-like
 * retries. */
#include <setjmp.h>
#include <stdlib.h>

#include "report.h"

struct frame {
  jmp_buf place;
  struct frame* outer;
};
static struct frame* top;
static volatile unsigned trail;

#define TRY                           \
  {                                   \
    struct frame frame_;              \
    frame_.outer = top;               \
    top = &frame_;                    \
    int code_ = setjmp(frame_.place); \
    if (code_ == 0) {
#define CATCH(name)   \
  top = frame_.outer; \
  }                   \
  else {              \
    int name = code_;
#define END \
  }         \
  }

static void note(int what) { trail = mix(trail, (unsigned)what); }
_Noreturn APART static void throw(int code) {
  struct frame* to = top;
  if (to == NULL)
    abort();
  top = to->outer;
  longjmp(to->place, code);
}
APART static int divide(int a, int b) {
  if (b == 0)
    throw(10);
  return a / b;
}
APART static int guarded(int a, int b) {
  volatile int result = -1;
  TRY note(1);
  result = divide(a, b);
  note(2);
  CATCH(code)
  note(code);
  result = code * 100;
  END return result;
}
APART static int nested(int depth) {
  volatile int seen = 0;
  TRY if (depth == 0) throw(3);
  seen = nested(depth - 1);
  throw(depth + 20);
  CATCH(code)
  note(code);
  if (depth == 2)
    throw(code + 1);
  return code + seen;
  END return -1;
}
APART static int out_of_loops(const short* p, int n, int limit) {
  volatile int row = 0;
  TRY for (int i = 0; i < n; i++) {
    int sum = 0;
    row = i;
    for (int k = 0; k <= i; k++)
      sum += p[k] * p[i - k];
    if (sum > limit)
      throw((sum & 0xff) | 1);
  }
  CATCH(code)
  return row * 1000 + code;
  END return -row;
}
static int compared;
static int fragile(const void* a, const void* b) {
  if (++compared == 20)
    throw(7);
  return *(const int*)a - *(const int*)b;
}
APART static int sorted(int* p, int n) {
  TRY qsort(p, (size_t)n, sizeof *p, fragile);
  CATCH(code)
  return code;
  END return 0;
}
APART static int retried(int needed) {
  volatile int tries = 0;
  jmp_buf again;
  int code = setjmp(again);
  tries++;
  if (tries < needed)
    longjmp(again, tries);
  return tries * 10 + code;
}

int main(void) {
  report("guarded", (unsigned)(guarded(100, 7) + guarded(5, 0)));
  TRY report("nested", (unsigned)nested(1));
  report("nested", (unsigned)nested(4));
  CATCH(code)
  report("caught", (unsigned)code);
  END short numbers[20];
  for (int i = 0; i < 20; i++)
    numbers[i] = (short)(i * 3 - 10);
  report("loops", (unsigned)(out_of_loops(numbers, 20, 500) + out_of_loops(numbers, 5, 100000)));
  int values[16];
  for (int i = 0; i < 16; i++)
    values[i] = (i * 7) % 16;
  unsigned s = (unsigned)sorted(values, 3) * 100;
  report("sort", s + (unsigned)sorted(values, 16));
  report("retried", (unsigned)(retried(1) * 1000 + retried(5)));
  report("trail", trail + (top == NULL));
  return 0;
}
