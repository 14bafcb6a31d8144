/* atoi, strtol, strtoul, abs, div; ctype.h. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

/* What 32 bits hold of the host's wider long. */
static int clamped(long value) {
  return value > 2147483647l ? 2147483647 : value < -2147483647l - 1 ? -2147483647 - 1 : (int)value;
}
static unsigned clamped_unsigned(unsigned long value) {
  return value > 4294967295ul ? 4294967295u : (unsigned)value;
}

int main(void) {
  static const char *const texts[] = {"0", "42", "  -17 rest", "+8", "0x1fz", "0X", "077", "08", "zz", "-", "",
                                      "2147483647", "-2147483648", "123abc", "\t\n 5",
                                      "4294967295", "4294967296", "99999999999"};
  for (unsigned i = 0; i < sizeof texts / sizeof *texts; i++) {
    char *end;
    /* atoi itself has no say about what is too large. */
    if (clamped(strtol(texts[i], &end, 10)) != 2147483647) printf("%d", atoi(texts[i]));
    static const int bases[] = {0, 2, 8, 10, 16, 36};
    for (int b = 0; b < 6; b++) {
      int value = clamped(strtol(texts[i], &end, bases[b]));
      printf(" %d@%d", value, (int)(end - texts[i]));
      if (strchr(texts[i], '-') != NULL) continue;
      unsigned other = clamped_unsigned(strtoul(texts[i], &end, bases[b]));
      printf(" %u@%d", other, (int)(end - texts[i]));
    }
    putchar('\n');
  }
  printf("%d %d %lld\n", abs(-5), abs(7), llabs(-1ll << 40));
  div_t parts = div(-17, 5);
  printf("%d %d\n", parts.quot, parts.rem);
  for (int c = 0; c < 128; c++) {
    unsigned classes = (unsigned)(!!isalpha(c) | !!isdigit(c) << 1 | !!isalnum(c) << 2 |
                                  !!isspace(c) << 3 | !!isupper(c) << 4 | !!islower(c) << 5 |
                                  !!ispunct(c) << 6 | !!isprint(c) << 7 | !!iscntrl(c) << 8 |
                                  !!isxdigit(c) << 9 | !!isgraph(c) << 10 | !!isblank(c) << 11);
    report("class", classes << 16 | (unsigned)toupper(c) << 8 | (unsigned)tolower(c));
  }
  return 0;
}
