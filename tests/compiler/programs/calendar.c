/* Days and words: dates to day numbers and back, week days, Easter, time of day, Roman numerals,
 * numbers in words, ages; signed divisions that must round down. */
#include <stdio.h>
#include <string.h>

#include "report.h"

struct date {
  short year;
  signed char month, day;
};

static int floor_divide(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }
static int is_leap(int y) { return (y % 4 == 0 && y % 100 != 0) || y % 400 == 0; }
APART static int number_of(struct date d) {
  int y = d.year - (d.month <= 2), era = floor_divide(y, 400), of_era = y - era * 400;
  int of_year = (153 * (d.month + (d.month > 2 ? -3 : 9)) + 2) / 5 + d.day - 1;
  return era * 146097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719468;
}
APART static struct date date_of(int number) {
  number += 719468;
  int era = floor_divide(number, 146097);
  unsigned day = (unsigned)(number - era * 146097),
           year = (day - day / 1460 + day / 36524 - day / 146096) / 365;
  unsigned of_year = day - (365 * year + year / 4 - year / 100), m = (5 * of_year + 2) / 153;
  return (struct date){(short)((int)year + era * 400 + (m >= 10)),
                       (signed char)(m < 10 ? m + 3 : m - 9),
                       (signed char)(of_year - (153 * m + 2) / 5 + 1)};
}
static int weekday(int number) { return (int)((unsigned)(number % 7 + 11) % 7); }
static struct date easter(int y) {
  int a = y % 19, b = y / 100, c = y % 100,
      d = (19 * a + b - b / 4 - (b - (b + 8) / 25 + 1) / 3 + 15) % 30;
  int e = (32 + 2 * (b % 4) + 2 * (c / 4) - d - c % 4) % 7,
      f = d + e - 7 * ((a + 11 * d + 22 * e) / 451) + 114;
  return (struct date){(short)y, (signed char)(f / 31), (signed char)(f % 31 + 1)};
}
static int week_of(struct date d) {
  int n = number_of(d), thursday = n - (weekday(n) + 6) % 7 + 3;
  struct date t = date_of(thursday), first = {t.year, 1, 1};
  return (thursday - number_of(first)) / 7 + 1;
}
static char* roman(int n, char* out) {
  static const short values[] = {1000, 900, 500, 400, 100, 90, 50, 40, 10, 9, 5, 4, 1};
  static const char letters[13][3] = {"M",  "CM", "D",  "CD", "C",  "XC", "L",
                                      "XL", "X",  "IX", "V",  "IV", "I"};
  *out = 0;
  for (int i = 0; i < 13; i++)
    for (; n >= values[i]; n -= values[i])
      strcat(out, letters[i]);
  return out;
}
static int from_roman(const char* p) {
  int sum = 0, last = 0;
  for (; *p != 0; p++) {
    int v = *p == 'M'   ? 1000
            : *p == 'D' ? 500
            : *p == 'C' ? 100
            : *p == 'L' ? 50
            : *p == 'X' ? 10
            : *p == 'V' ? 5
                        : 1;
    sum += v - (v > last ? 2 * last : 0);
    last = v;
  }
  return sum;
}
static void in_words(unsigned n, char* out) {
  static const char* const small[] = {"zero",    "one",     "two",       "three",    "four",
                                      "five",    "six",     "seven",     "eight",    "nine",
                                      "ten",     "eleven",  "twelve",    "thirteen", "fourteen",
                                      "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
  static const char* const tens[] = {"twenty", "thirty",  "forty",  "fifty",
                                     "sixty",  "seventy", "eighty", "ninety"};
  static const struct {
    unsigned value;
    const char* name;
  } large[] = {{1000000, " million "}, {1000, " thousand "}, {100, " hundred "}};
  for (int i = 0; i < 3; i++)
    if (n >= large[i].value) {
      in_words(n / large[i].value, out);
      strcat(out, large[i].name);
      if ((n %= large[i].value) == 0)
        return;
      out += strlen(out);
    }
  strcpy(out, n < 20 ? small[n] : tens[n / 10 - 2]);
  if (n > 20 && n % 10 != 0)
    strcat(strcat(out, "-"), small[n % 10]);
}

int main(void) {
  unsigned s = 0, wrong = 0;
  for (int n = -800000; n < 100000; n += 3671) {
    struct date d = date_of(n);
    s = mix(s, (unsigned)(d.year * 400 + d.month * 32 + d.day) * 8u + (unsigned)weekday(n));
    wrong += number_of(d) != n;
  }
  report("dates", s + wrong);
  for (int y = 1990; y < 2030; y += 3) {
    struct date e = easter(y);
    printf("%d-%02d-%02d week %d%s\n", e.year, e.month, e.day, week_of(e),
           is_leap(y) ? " leap" : "");
  }
  printf("%d %d\n", week_of((struct date){2021, 1, 3}), week_of((struct date){2020, 12, 31}));
  char text[120];
  for (int n = 1; n < 4000; n = n * 3 + 2) {
    int back = from_roman(roman(n, text));
    printf("%s=%d ", text, back);
  }
  putchar('\n');
  static const unsigned numbers[] = {0, 13, 20, 85, 100, 701, 12345, 1000000, 987654321};
  for (int i = 0; i < 9; i++) {
    in_words(numbers[i], text);
    puts(text);
  }
  return 0;
}
