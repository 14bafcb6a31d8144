/* Printing of doubles with every digit right, however many are asked for. */
#include <stdint.h>

#include "print/decimal.h"
#include "print/format.h"

#define INFINITE_BITS ((uint64_t)0x7FF << 52)

/* How the digits stand: from 10^top down to 10^bottom, with a point behind 10^point. */
struct layout {
  int top;
  int bottom;
  int point;
  int with_exponent;
  int exponent;
};

static int is_upper(const struct conversion* conversion) { return (conversion->kind & 32) == 0; }

static void put_word(struct output* output, struct conversion conversion, const char* prefix,
                     const char* word) {
  conversion.zeros = 0;
  put_before_body(output, &conversion, prefix, 3);
  for (int i = 0; i < 3; ++i) {
    put_character(output, (char)(is_upper(&conversion) ? word[i] - 32 : word[i]));
  }
  put_after_body(output, &conversion, prefix, 3);
}

static struct layout fixed_layout(const struct decimal* number, int precision) {
  int top = decimal_top(number);
  return (struct layout){top > 0 ? top : 0, -precision, 0, 0, 0};
}

static struct layout exponent_layout(const struct decimal* number, int precision) {
  int top = decimal_top(number);
  return (struct layout){top, top - precision, top, 1, top};
}

static int is_zero(const struct decimal* number) { return number->limbs[number->first] == 0; }

/* Rounds to so many digits behind the first. */
static void round_to_digits(struct decimal* number, int digits) {
  if (!is_zero(number)) {
    decimal_round(number, decimal_top(number) - digits);
  }
}

/* g: as many digits as the precision says; with an exponent where that is shorter. */
static struct layout general_layout(struct decimal* number, int precision, int keep_zeros) {
  int digits = precision != 0 ? precision : 1;
  round_to_digits(number, digits - 1);
  int top = decimal_top(number);
  struct layout layout = top >= -4 && top < digits ? fixed_layout(number, digits - 1 - top)
                                                   : exponent_layout(number, digits - 1);
  while (!keep_zeros && layout.bottom < layout.point && decimal_digit(number, layout.bottom) == 0) {
    ++layout.bottom;
  }
  return layout;
}

static struct layout layout_of(struct decimal* number, const struct conversion* conversion) {
  int precision = conversion->precision < 0 ? 6 : conversion->precision;
  switch (conversion->kind | 32) {
    case 'f':
      decimal_round(number, -precision);
      return fixed_layout(number, precision);
    case 'e':
      round_to_digits(number, precision);
      return exponent_layout(number, precision);
    default:
      return general_layout(number, precision, conversion->alternate);
  }
}

static int exponent_digits(int exponent) { return exponent >= 100 || exponent <= -100 ? 3 : 2; }

static void put_exponent(struct output* output, char letter, int exponent) {
  put_character(output, letter);
  put_character(output, exponent < 0 ? '-' : '+');
  unsigned magnitude = (unsigned)(exponent < 0 ? -exponent : exponent);
  if (magnitude >= 100) {
    put_character(output, (char)('0' + magnitude / 100));
  }
  put_character(output, (char)('0' + magnitude / 10 % 10));
  put_character(output, (char)('0' + magnitude % 10));
}

static void put_digits(struct output* output, const struct conversion* conversion,
                       struct decimal* number, const char* prefix) {
  struct layout layout = layout_of(number, conversion);
  int with_point = layout.bottom < layout.point || conversion->alternate;
  int length = layout.top - layout.bottom + 1 + with_point;
  if (layout.with_exponent) {
    length += 2 + exponent_digits(layout.exponent);
  }
  put_before_body(output, conversion, prefix, length);
  for (int position = layout.top; position >= layout.bottom; --position) {
    put_character(output, (char)('0' + decimal_digit(number, position)));
    if (position == layout.point && with_point) {
      put_character(output, '.');
    }
  }
  if (layout.with_exponent) {
    put_exponent(output, is_upper(conversion) ? 'E' : 'e', layout.exponent);
  }
  put_after_body(output, conversion, prefix, length);
}

void put_double(struct output* output, const struct conversion* conversion, double value) {
  union {
    double value;
    uint64_t bits;
  } both = {value};
  const char* prefix = sign_prefix(conversion, both.bits >> 63 != 0);
  uint64_t magnitude = both.bits & ~((uint64_t)1 << 63);
  if (magnitude >= INFINITE_BITS) {
    put_word(output, *conversion, prefix, magnitude == INFINITE_BITS ? "inf" : "nan");
    return;
  }
  struct decimal number;
  decimal_of(&number, magnitude);
  put_digits(output, conversion, &number, prefix);
}
