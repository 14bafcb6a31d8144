/* Exact decimal digits of a double: the significand as an integer, times or divided by powers of
 * two. */
#include "print/decimal.h"

#define LIMB 10000u
#define UNITS (WHOLE_LIMBS - 1)
#define FRACTION_BITS 52
#define LOWEST_EXPONENT (-1074)

static const uint16_t kPowersOfTen[4] = {1, 10, 100, 1000};

/* The first and the last limb are not 0, unless the number is. */
static void drop_zeros(struct decimal* number) {
  while (number->first + 1 < number->end && number->limbs[number->first] == 0) {
    ++number->first;
  }
  while (number->first + 1 < number->end && number->limbs[number->end - 1] == 0) {
    --number->end;
  }
}

/* Times 2^bits, of whole numbers; at most 16 bits, so that everything fits 32. */
static void shift_up(struct decimal* number, int bits) {
  uint32_t carry = 0;
  for (int i = UNITS; i >= number->first || carry != 0; --i) {
    uint32_t value = ((uint32_t)(i >= number->first ? number->limbs[i] : 0) << bits) + carry;
    carry = value / LIMB;
    number->limbs[i] = (uint16_t)(value - carry * LIMB);
    if (i < number->first) {
      number->first = i;
    }
  }
}

/* Divided by 2^bits, at most 16; what remains below the units goes on in limbs behind them. */
static void shift_down(struct decimal* number, int bits) {
  uint32_t mask = (1u << bits) - 1;
  uint32_t remainder = 0;
  for (int i = number->first; i < number->end || remainder != 0; ++i) {
    uint32_t value = remainder * LIMB + (i < number->end ? number->limbs[i] : 0);
    number->limbs[i] = (uint16_t)(value >> bits);
    remainder = value & mask;
    if (i >= number->end) {
      number->end = i + 1;
    }
  }
  drop_zeros(number);
}

static void set_whole(struct decimal* number, uint64_t value) {
  number->first = UNITS;
  number->end = UNITS + 1;
  number->limbs[UNITS] = 0;
  for (int part = 48; part >= 0; part -= 16) {
    shift_up(number, 16);
    uint32_t carry = (uint32_t)(value >> part) & 0xFFFF;
    for (int i = UNITS; carry != 0; --i) {
      uint32_t sum = (i >= number->first ? number->limbs[i] : 0) + carry;
      carry = sum / LIMB;
      number->limbs[i] = (uint16_t)(sum - carry * LIMB);
      if (i < number->first) {
        number->first = i;
      }
    }
  }
}

void decimal_of(struct decimal* number, uint64_t magnitude) {
  int exponent = (int)(magnitude >> FRACTION_BITS);
  uint64_t significand = magnitude & (((uint64_t)1 << FRACTION_BITS) - 1);
  if (exponent != 0) {
    significand |= (uint64_t)1 << FRACTION_BITS;
    --exponent;
  }
  exponent += LOWEST_EXPONENT;
  if (significand == 0) {
    exponent = 0;
  }
  for (; exponent < 0 && (significand & 1) == 0; ++exponent) {
    significand >>= 1;
  }
  set_whole(number, significand);
  for (; exponent > 0; exponent -= exponent < 16 ? exponent : 16) {
    shift_up(number, exponent < 16 ? exponent : 16);
  }
  for (; exponent<0; exponent += exponent> - 16 ? -exponent : 16) {
    shift_down(number, exponent > -16 ? -exponent : 16);
  }
  drop_zeros(number);
}

static unsigned limb_at(const struct decimal* number, int index) {
  return index >= number->first && index < number->end ? number->limbs[index] : 0;
}

/* The limb that a position lies in; limbs have four of them. */
static int limb_of(int position) { return UNITS - (position >> 2); }

unsigned decimal_digit(const struct decimal* number, int position) {
  return limb_at(number, limb_of(position)) / kPowersOfTen[position & 3] % 10;
}

int decimal_top(const struct decimal* number) {
  unsigned limb = number->limbs[number->first];
  int position = 4 * (UNITS - number->first);
  for (; limb >= 10; limb /= 10) {
    ++position;
  }
  return limb != 0 ? position : 0;
}

/* Is what lies below a multiple of 10^position more than half of it (1), half (0) or less (-1)? */
static int against_half(const struct decimal* number, int position) {
  unsigned digit = decimal_digit(number, position - 1);
  if (digit != 5) {
    return digit > 5 ? 1 : -1;
  }
  int index = limb_of(position - 1);
  if (number->end > index + 1 || limb_at(number, index) % kPowersOfTen[(position - 1) & 3] != 0) {
    return 1;
  }
  return 0;
}

void decimal_round(struct decimal* number, int position) {
  int index = limb_of(position);
  if (index + 1 > number->end || (index + 1 == number->end && (position & 3) == 0)) {
    return; /* nothing lies below */
  }
  int half = against_half(number, position);
  int up = half > 0 || (half == 0 && (decimal_digit(number, position) & 1) != 0);
  for (int i = index; i < number->first; ++i) {
    number->limbs[i] = 0;
  }
  if (index < number->first) {
    number->first = index;
  }
  unsigned unit = kPowersOfTen[position & 3];
  number->end = index + 1;
  number->limbs[index] = (uint16_t)(number->limbs[index] / unit * unit);
  for (unsigned carry = up ? unit : 0; carry != 0; --index) {
    if (index < number->first) {
      number->first = index;
      number->limbs[index] = 0;
    }
    unsigned sum = number->limbs[index] + carry;
    carry = sum >= LIMB;
    number->limbs[index] = (uint16_t)(carry != 0 ? sum - LIMB : sum);
  }
  drop_zeros(number);
}
