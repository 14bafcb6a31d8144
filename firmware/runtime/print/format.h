/* What the parts of printf share: where characters go, and a conversion as it was asked for. */
#ifndef FINBACK_PRINT_FORMAT_H
#define FINBACK_PRINT_FORMAT_H

#include <stdarg.h>
#include <stddef.h>

/* Characters go to `at` while there is room before `end`; with no `at`, to the console. */
struct output {
  char* at;
  char* end;
  size_t written; /* with those that found no room */
};

struct conversion {
  unsigned char left, plus, space, alternate, zeros; /* the flags - + blank # 0 */
  char kind;                                         /* its letter */
  int width;
  int precision; /* negative: none was given */
};

void put_character(struct output* output, char character);

void put_repeated(struct output* output, char character, int times);

/* What stands before and behind a body of `length` characters, so that the width is filled: blanks,
 * the prefix (a sign or 0x), zeros; blanks. */
void put_before_body(struct output* output, const struct conversion* conversion, const char* prefix,
                     int length);
void put_after_body(struct output* output, const struct conversion* conversion, const char* prefix,
                    int length);

/* The sign to print before a number: "-", "+", " " or nothing. */
const char* sign_prefix(const struct conversion* conversion, int negative);

/* e E f F g G. */
void put_double(struct output* output, const struct conversion* conversion, double value);

/* The whole of printf. */
void put_formatted(struct output* output, const char* format, va_list* values);

#endif
