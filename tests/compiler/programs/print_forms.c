/* snprintf's rooms and printf's forms that programs use: columns, tables, widths and precisions by
 * arguments, hexadecimal dumps, all lengths, characters, pointers, mixed with doubles, texts cut
 * short. */
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "report.h"

APART static int wrapped(char* to, size_t room, const char* format, ...) {
  va_list list;
  va_start(list, format);
  int length = vsnprintf(to, room, format, list);
  va_end(list);
  return length;
}
static void dump(const void* object, unsigned size) {
  const unsigned char* p = object;
  for (unsigned at = 0; at < size; at += 8) {
    printf("%04x ", at);
    for (unsigned i = at; i < at + 8; i++)
      i < size ? printf(" %02x", p[i]) : printf("   ");
    printf("  |");
    for (unsigned i = at; i < at + 8 && i < size; i++)
      putchar(p[i] >= ' ' && p[i] < 127 ? p[i] : '.');
    puts("|");
  }
}
struct row {
  const char* name;
  int count;
  double share;
};

int main(void) {
  static const struct row rows[] = {{"first", 7, 0.125},
                                    {"a longer name", -12345, 99.995},
                                    {"", 0, 1e-9},
                                    {"last", 2147483647, 12345678.9}};
  for (int i = 0; i < 4; i++)
    printf("|%-10.10s|%11d|%+8d|%12.3f|%-9.2e|%g\n", rows[i].name, rows[i].count,
           rows[i].count / 1000, rows[i].share, rows[i].share, rows[i].share);
  dump("bytes\0\1\2and more\xff\x80", 17);
  for (int width = 0; width < 8; width += 3)
    for (int precision = -1; precision < 5; precision += 2)
      printf("[%*.*d][%-*.*x][%*.*s][%0*d]", width, precision, 42, width, precision, 0xbeefu, width,
             precision, "text", width, -5);
  putchar('\n');
  char small[12];
  for (size_t room = 0; room < sizeof small; room += 3) {
    memset(small, '#', sizeof small);
    int length = wrapped(small, room, "%s:%d", "room", 98765);
    printf("%d ", length);
    for (unsigned i = 0; i < sizeof small; i++)
      putchar(small[i] == 0 ? '_' : small[i]);
    putchar('\n');
  }
  printf("%hhd %hhu %hd %hu %lld %llx %zu %td\n", (signed char)300, (unsigned char)300,
         (short)70000, (unsigned short)70000, -(1ll << 40), 1ull << 63, (size_t)12, (ptrdiff_t)-3);
  printf("%5c|%-5c|%c%c%c|%%|\n", 'a', 'b', 'x', 'y', 'z');
  printf("%#x %#o %#X %x %#.5x % d %+d\n", 255, 8, 3054, 0, 17, 5, 0);
  printf("%08.3f %+.1f %.0f %#.0f % .3e %G %g %g\n", 3.14159, 2.25, 0.5, 3.0, -12345.678, 1e-10,
         100000.0, 1000000.0);
  printf("%d %s %lld %f %c %u %s\n", 1, "two", 3ll, 4.0, '5', 6u, "seven");
  char built[80] = "";
  for (int i = 0; i < 6; i++)
    sprintf(built + strlen(built), i ? ", %d" : "%d", i * i);
  puts(built);
  int before = printf("%s", ""), length = printf("%-20s|\n", "counted");
  report("lengths", (unsigned)(before * 100 + length));
  return 0;
}
