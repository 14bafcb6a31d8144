/* printf's formats: flags, widths, precisions, lengths; integers, characters and texts. Doubles are
 * print_double.c's. */
#include <ctype.h>
#include <limits.h>
#include <stdint.h>
#include <string.h>

#include "print/format.h"

/* 64 bits in octal. */
#define MOST_DIGITS 22

void put_repeated(struct output* output, char character, int times) {
  for (; times > 0; --times) {
    put_character(output, character);
  }
}

static int padding(const struct conversion* conversion, const char* prefix, int length) {
  return conversion->width - length - (int)strlen(prefix);
}

void put_before_body(struct output* output, const struct conversion* conversion, const char* prefix,
                     int length) {
  int fill = padding(conversion, prefix, length);
  if (!conversion->left && !conversion->zeros) {
    put_repeated(output, ' ', fill);
  }
  for (const char* at = prefix; *at != 0; ++at) {
    put_character(output, *at);
  }
  if (!conversion->left && conversion->zeros) {
    put_repeated(output, '0', fill);
  }
}

void put_after_body(struct output* output, const struct conversion* conversion, const char* prefix,
                    int length) {
  if (conversion->left) {
    put_repeated(output, ' ', padding(conversion, prefix, length));
  }
}

const char* sign_prefix(const struct conversion* conversion, int negative) {
  return negative ? "-" : conversion->plus ? "+" : conversion->space ? " " : "";
}

static void put_text(struct output* output, struct conversion conversion, const char* text,
                     int length) {
  conversion.zeros = 0;
  put_before_body(output, &conversion, "", length);
  for (int i = 0; i < length; ++i) {
    put_character(output, text[i]);
  }
  put_after_body(output, &conversion, "", length);
}

static void put_string(struct output* output, const struct conversion* conversion,
                       const char* text) {
  if (text == NULL) {
    text = conversion->precision >= 0 && conversion->precision < 6 ? "" : "(null)";
  }
  int limit = conversion->precision < 0 ? INT_MAX : conversion->precision;
  put_text(output, *conversion, text, (int)strnlen(text, (size_t)limit));
}

/* Writes digits before `end` and returns the first; none of 0. */
static char* write_digits(char* end, uint64_t value, unsigned base, char ten) {
  for (; value > UINT32_MAX; value /= base) {
    unsigned digit = (unsigned)(value % base);
    *--end = (char)(digit < 10 ? '0' + digit : (unsigned)ten + digit - 10);
  }
  for (uint32_t low = (uint32_t)value; low != 0; low /= base) {
    unsigned digit = low % base;
    *--end = (char)(digit < 10 ? '0' + digit : (unsigned)ten + digit - 10);
  }
  return end;
}

static unsigned base_of(char kind) {
  switch (kind) {
    case 'o':
      return 8;
    case 'x':
    case 'X':
    case 'p':
      return 16;
    default:
      return 10;
  }
}

static void put_integer(struct output* output, struct conversion conversion, uint64_t value,
                        int negative) {
  char digits[MOST_DIGITS];
  char* end = digits + MOST_DIGITS;
  char ten = conversion.kind == 'X' ? 'A' : 'a';
  unsigned base = base_of(conversion.kind);
  char* first = write_digits(end, value, base, ten);
  int length = (int)(end - first);
  int zeros = (conversion.precision < 0 ? 1 : conversion.precision) - length;
  if (conversion.kind == 'o' && conversion.alternate && zeros <= 0) {
    zeros = 1;
  }
  if (zeros < 0) {
    zeros = 0;
  }
  conversion.zeros &= conversion.precision < 0;
  const char* prefix = "";
  if (conversion.kind == 'd') {
    prefix = sign_prefix(&conversion, negative);
  } else if (base == 16 && (conversion.kind == 'p' || (conversion.alternate && value != 0))) {
    prefix = conversion.kind == 'X' ? "0X" : "0x";
  }
  put_before_body(output, &conversion, prefix, zeros + length);
  put_repeated(output, '0', zeros);
  for (; first != end; ++first) {
    put_character(output, *first);
  }
  put_after_body(output, &conversion, prefix, zeros + length);
}

/* How many bytes an argument counts: of a length modifier, which `*format` is moved behind. */
static unsigned read_size(const char** format) {
  char first = **format;
  if (first != 'h' && first != 'l' && first != 'j' && first != 'z' && first != 't') {
    return 4;
  }
  ++*format;
  int twice = **format == first && (first == 'h' || first == 'l');
  *format += twice;
  switch (first) {
    case 'h':
      return twice ? 1 : 2;
    case 'l':
      return twice ? sizeof(long long) : sizeof(long);
    case 'j':
      return sizeof(intmax_t);
    default:
      return sizeof(size_t);
  }
}

static void put_signed(struct output* output, struct conversion conversion, unsigned size,
                       va_list* values) {
  int64_t value;
  if (size == 8) {
    value = va_arg(*values, long long);
  } else {
    int narrow = va_arg(*values, int);
    value = size == 1 ? (signed char)narrow : size == 2 ? (short)narrow : narrow;
  }
  conversion.kind = 'd';
  put_integer(output, conversion, value < 0 ? 0 - (uint64_t)value : (uint64_t)value, value < 0);
}

static void put_unsigned(struct output* output, const struct conversion* conversion, unsigned size,
                         va_list* values) {
  uint64_t value;
  if (size == 8) {
    value = va_arg(*values, unsigned long long);
  } else {
    unsigned narrow = va_arg(*values, unsigned);
    value = size == 1 ? (unsigned char)narrow : size == 2 ? (unsigned short)narrow : narrow;
  }
  put_integer(output, *conversion, value, 0);
}

/* %n: how much was written so far. */
static void store_count(const struct output* output, unsigned size, void* target) {
  if (size == 8) {
    *(long long*)target = (long long)output->written;
  } else if (size == 2) {
    *(short*)target = (short)output->written;
  } else if (size == 1) {
    *(signed char*)target = (signed char)output->written;
  } else {
    *(int*)target = (int)output->written;
  }
}

static void put_conversion(struct output* output, const struct conversion* conversion,
                           unsigned size, va_list* values) {
  switch (conversion->kind) {
    case 'd':
    case 'i':
      put_signed(output, *conversion, size, values);
      break;
    case 'u':
    case 'o':
    case 'x':
    case 'X':
      put_unsigned(output, conversion, size, values);
      break;
    case 'p':
      put_integer(output, *conversion, (uintptr_t)va_arg(*values, void*), 0);
      break;
    case 'c': {
      char character = (char)va_arg(*values, int);
      put_text(output, *conversion, &character, 1);
      break;
    }
    case 's':
      put_string(output, conversion, va_arg(*values, const char*));
      break;
    case 'n':
      store_count(output, size, va_arg(*values, void*));
      break;
    case 'e':
    case 'E':
    case 'f':
    case 'F':
    case 'g':
    case 'G':
      put_double(output, conversion, va_arg(*values, double));
      break;
    default:
      put_character(output, conversion->kind); /* %%, and what is no conversion */
      break;
  }
}

/* A number written in the format, or a * for one among the arguments. */
static int read_count(const char** format, va_list* values) {
  if (**format == '*') {
    ++*format;
    return va_arg(*values, int);
  }
  int count = 0;
  for (; isdigit(**format); ++*format) {
    count = count * 10 + (**format - '0');
  }
  return count;
}

static const char* read_flags(struct conversion* conversion, const char* format) {
  for (;; ++format) {
    switch (*format) {
      case '-':
        conversion->left = 1;
        break;
      case '+':
        conversion->plus = 1;
        break;
      case ' ':
        conversion->space = 1;
        break;
      case '#':
        conversion->alternate = 1;
        break;
      case '0':
        conversion->zeros = 1;
        break;
      default:
        return format;
    }
  }
}

void put_formatted(struct output* output, const char* format, va_list* values) {
  for (; *format != 0; ++format) {
    if (*format != '%') {
      put_character(output, *format);
      continue;
    }
    struct conversion conversion = {0};
    format = read_flags(&conversion, format + 1);
    conversion.width = read_count(&format, values);
    if (conversion.width < 0) {
      conversion.left = 1;
      conversion.width = -conversion.width;
    }
    conversion.precision = -1;
    if (*format == '.') {
      ++format;
      conversion.precision = read_count(&format, values);
    }
    if (*format == 'L') {
      ++format; /* long double is double */
    }
    unsigned size = read_size(&format);
    conversion.kind = *format;
    if (*format == 0) {
      return;
    }
    put_conversion(output, &conversion, size, values);
  }
}
