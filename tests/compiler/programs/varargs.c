/* Variable arguments: integers, 64 bits, strings; a formatter. */
#include "report.h"
#include <stdarg.h>
__attribute__((noinline)) static int sum(int n, ...) {
  va_list list;
  va_start(list, n);
  int s = 0;
  for (int i = 0; i < n; i++) s = s * 3 + va_arg(list, int);
  va_end(list);
  return s;
}
__attribute__((noinline)) static unsigned format(char *to, const char *text, ...) {
  va_list list;
  va_start(list, text);
  char *start = to;
  for (; *text; text++) {
    if (*text != '%') {
      *to++ = *text;
      continue;
    }
    char digits[12];
    int n = 0;
    switch (*++text) {
      case 'd': {
        int v = va_arg(list, int);
        unsigned u = v < 0 ? 0u - (unsigned)v : (unsigned)v;
        if (v < 0) *to++ = '-';
        do digits[n++] = (char)('0' + u % 10);
        while (u /= 10);
        while (n) *to++ = digits[--n];
        break;
      }
      case 's':
        for (const char *s = va_arg(list, const char *); *s; s++) *to++ = *s;
        break;
      case 'l': {
        long long v = va_arg(list, long long);
        *to++ = (char)('a' + (v >> 33 & 15));
        break;
      }
      default: *to++ = *text;
    }
  }
  *to = 0;
  va_end(list);
  return (unsigned)(to - start);
}
int main(void) {
  char text[80];
  report("sum", (unsigned)sum(7, 1, 2, 3, 4, 5, 6, 7));
  report("none", (unsigned)sum(0));
  unsigned s = format(text, "d=%d %s%% %l %d", -2048, "two", 5LL << 33, 77);
  for (char *p = text; *p; p++) s = mix(s, (unsigned char)*p);
  report("format", s);
  return 0;
}
