/* Variable arguments of every type, structs among them; lists copied, handed on, and walked twice;
 * many of them; 64-bit ones at every place. */
#include <stdarg.h>

#include "report.h"

struct small {
  short a, b;
};
struct large {
  int v[5];
};
enum kind { red, green };

APART static unsigned collect(const char* types, va_list list) {
  unsigned s = 0;
  for (; *types != 0; types++) {
    switch (*types) {
      case 'c':
        s = mix(s, (unsigned)va_arg(list, int));
        break;
      case 'u':
        s = mix(s, va_arg(list, unsigned));
        break;
      case 'l':
        s = mix_long(s, va_arg(list, unsigned long long));
        break;
      case 'd':
        s = mix(s, (unsigned)(int)(va_arg(list, double) * 16));
        break;
      case 'p':
        s = mix(s, (unsigned)*va_arg(list, int*));
        break;
      case 's': {
        struct small x = va_arg(list, struct small);
        s = mix(s, (unsigned)(x.a * 1000 + x.b));
        break;
      }
      case 'L': {
        struct large x = va_arg(list, struct large);
        for (int i = 0; i < 5; i++)
          s = mix(s, (unsigned)x.v[i]);
        break;
      }
      case 'f':
        s = mix(s, (unsigned)va_arg(list, int (*)(int))(7));
        break;
    }
  }
  return s;
}
APART static unsigned sum(const char* types, ...) {
  va_list list, again;
  va_start(list, types);
  va_copy(again, list);
  unsigned s = collect(types, list);
  unsigned t = collect(types, again);
  va_end(again);
  va_end(list);
  return s == t ? s : 0xbad;
}
APART static long long after_five(int a, int b, long long c, int d, int e, ...) {
  va_list list;
  va_start(list, e);
  long long s = a + b + c + d + e;
  for (int i = 0; i < 3; i++)
    s = s * 3 + va_arg(list, long long);
  va_end(list);
  return s;
}
APART static int count_until(int stop, ...) {
  va_list list;
  int n = 0;
  va_start(list, stop);
  while (va_arg(list, int) != stop)
    n++;
  va_end(list);
  return n;
}
APART static int half_read(int n, ...) {
  va_list list;
  va_start(list, n);
  int first = n > 0 ? va_arg(list, int) : -1;
  va_list* p = &list;
  int second = n > 1 ? va_arg(*p, int) : -2;
  va_end(list);
  return first * 10 + second;
}
static int square(int x) { return x * x; }

int main(void) {
  int object = 77;
  struct small small = {-3, 4};
  struct large large = {{1, 2, 3, 4, 5}};
  report("chars", sum("cccc", 'a', (signed char)-1, (short)-5, (unsigned char)200));
  report("mixed", sum("culdp", 1, 2u, 3ll << 40, 4.25, &object));
  report("shifted", sum("lcldcl", 1ll, 2, -3ll, 0.5f, 4, 5ull << 60));
  report("structs", sum("sLcsLd", small, large, 9, small, large, -1.5));
  report("functions", sum("fcf", square, green, square));
  report("none", sum(""));
  report("many", sum("cccccccccccccccccccccccccccccc", 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13,
                     14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30));
  report("five", mix_long(0, (unsigned long long)after_five(1, 2, 3, 4, 5, 6ll << 33, -7ll, 8ll)));
  report("until", (unsigned)count_until(0, 5, 4, 3, 2, 1, 0));
  report("half", (unsigned)(half_read(0) + half_read(1, 5) * 100 + half_read(2, 6, 7) * 10000));
  return 0;
}
