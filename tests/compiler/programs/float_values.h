/* Values that floating-point arithmetic must get right, and their bits. What is no number is one value:
 * its bits are the machine's own. */
#ifndef FLOAT_VALUES_H
#define FLOAT_VALUES_H

static inline unsigned float_bits(float value) {
  union {
    float value;
    unsigned bits;
  } both = {value};
  return value == value ? both.bits : 0x7fc00000u;
}

static inline unsigned long long double_bits(double value) {
  union {
    double value;
    unsigned long long bits;
  } both = {value};
  return value == value ? both.bits : 0x7ff8000000000000ull;
}

static inline float float_from_bits(unsigned bits) {
  union {
    unsigned bits;
    float value;
  } both = {bits};
  return both.value;
}

static inline double double_from_bits(unsigned long long bits) {
  union {
    unsigned long long bits;
    double value;
  } both = {bits};
  return both.value;
}

static volatile const unsigned float_edges[] = {
    0x00000000, 0x80000000, 0x3f800000, 0xbf800000, 0x3f800001, 0x3f7fffff, 0x40490fdb, 0x00000001,
    0x80000001, 0x007fffff, 0x00800000, 0x00800001, 0x7f7fffff, 0xff7fffff, 0x7f800000, 0xff800000,
    0x7fc00000, 0x7f800001, 0x4b800000, 0x4b7fffff, 0x33800000, 0x34000000, 0x4f000000, 0x4effffff,
};

static volatile const unsigned long long double_edges[] = {
    0x0000000000000000, 0x8000000000000000, 0x3ff0000000000000, 0xbff0000000000000,
    0x3ff0000000000001, 0x3fefffffffffffff, 0x400921fb54442d18, 0x0000000000000001,
    0x8000000000000001, 0x000fffffffffffff, 0x0010000000000000, 0x0010000000000001,
    0x7fefffffffffffff, 0xffefffffffffffff, 0x7ff0000000000000, 0xfff0000000000000,
    0x7ff8000000000000, 0x7ff0000000000001, 0x4340000000000000, 0x433fffffffffffff,
    0x3ca0000000000000, 0x3cb0000000000000, 0x36a0000000000000, 0x47efffffe0000000,
};

#define EDGES 24

#endif
