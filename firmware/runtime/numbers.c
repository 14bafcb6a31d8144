/* Absolute values, division with both results, and numbers out of text. */
#include <ctype.h>
#include <limits.h>
#include <stdlib.h>

int(abs)(int value) { return value < 0 ? -value : value; }

long(labs)(long value) { return value < 0 ? -value : value; }

long long(llabs)(long long value) { return value < 0 ? -value : value; }

div_t div(int dividend, int divisor) {
  div_t result = {dividend / divisor, 0};
  result.rem = dividend - result.quot * divisor;
  return result;
}

struct number {
  unsigned long magnitude;
  int negative;
  int overflow;
};

/* A digit's value, or more than any base. */
static unsigned digit_of(char c) {
  if (isdigit(c)) {
    return (unsigned)c - '0';
  }
  return isalpha(c) ? ((unsigned)c | 32) - 'a' + 10 : 99;
}

static struct number read_number(const char* text, char** end, unsigned base) {
  struct number number = {0, 0, 0};
  const char* at = text;
  while (isspace(*at)) {
    ++at;
  }
  if (*at == '-' || *at == '+') {
    number.negative = *at++ == '-';
  }
  if ((base == 0 || base == 16) && at[0] == '0' && (at[1] | 32) == 'x' && digit_of(at[2]) < 16) {
    at += 2;
    base = 16;
  } else if (base == 0) {
    base = *at == '0' ? 8 : 10;
  }
  if (digit_of(*at) < base) {
    text = at; /* else nothing was read */
  }
  for (unsigned digit = digit_of(*at); digit < base; digit = digit_of(*at)) {
    unsigned long long next = (unsigned long long)number.magnitude * base + digit;
    number.overflow |= next > ULONG_MAX;
    number.magnitude = (unsigned long)next;
    text = ++at;
  }
  if (end != NULL) {
    *end = (char*)text;
  }
  return number;
}

long strtol(const char* restrict text, char** restrict end, int base) {
  struct number number = read_number(text, end, (unsigned)base);
  unsigned long limit = (unsigned long)LONG_MAX + (unsigned long)number.negative;
  if (number.overflow || number.magnitude > limit) {
    return number.negative ? LONG_MIN : LONG_MAX;
  }
  return (long)(number.negative ? 0 - number.magnitude : number.magnitude);
}

unsigned long strtoul(const char* restrict text, char** restrict end, int base) {
  struct number number = read_number(text, end, (unsigned)base);
  if (number.overflow) {
    return ULONG_MAX;
  }
  return number.negative ? 0 - number.magnitude : number.magnitude;
}

long atol(const char* text) { return strtol(text, NULL, 10); }

int atoi(const char* text) { return (int)atol(text); }
