/* volatile objects of every kind: each access happens, in order, once; members, bit-fields, arrays,
 * pointers to them and volatile pointers, structs as a whole, 64 bits, loops that wait on them. */
#include "report.h"

struct device {
  volatile unsigned control, status;
  volatile unsigned short data[4];
  volatile unsigned ready : 1, level : 4, rest : 27;
};
static struct device device;
static volatile int plain = 5;
static volatile unsigned char byte;
static volatile long long wide;
static volatile double real = 1.5;
static int* volatile moving;
static volatile struct pair {
  int a;
  short b;
} whole;
static int cells[4];

APART static int reads(void) { return plain + plain * 2 - plain + (plain & 3); }
APART static int writes(int x) {
  plain = x;
  plain = x + 1;
  plain += plain;
  plain++;
  int old = plain--;
  old = old * 100 + plain;
  return old + (plain = 7);
}
APART static unsigned drive(struct device* d, int n) {
  unsigned s = 0;
  for (int i = 0; i < n; i++) {
    d->control = (unsigned)i;
    d->status |= 1u << (i & 7);
    d->data[i & 3] = (unsigned short)(d->data[(i + 1) & 3] + i);
    d->ready ^= 1;
    d->level = d->level + 3;
    if (d->status & 4)
      d->status &= ~4u;
    s = mix(s, d->control + d->status * 3 + d->data[i & 3] + d->ready + d->level);
  }
  return s;
}
APART static int waits(volatile const int* flag, volatile int* count) {
  while (*count < *flag)
    *count = *count + 2;
  for (; *count > 3; --*count) {
  }
  return *count;
}
APART static long long wides(int n) {
  for (int i = 0; i < n; i++) {
    wide += (long long)i << 30;
    wide ^= wide >> 7;
  }
  return wide;
}
APART static int pointers(void) {
  moving = cells;
  *moving++ = 4;
  *moving = 5;
  moving[1] = *moving + 1;
  return (int)(moving - cells) * 100 + cells[0] + cells[1] * 2 + cells[2] * 3;
}
APART static int structs(int n) {
  struct pair local = {n, (short)-n};
  whole.a = local.a;
  whole.b = local.b;
  whole.a += whole.b * 3;
  struct pair copy = whole;
  return copy.a * 10 + copy.b;
}
APART static unsigned bytes(const char* text) {
  unsigned s = 0;
  for (; *text != 0; text++) {
    byte = (unsigned char)*text;
    byte = (unsigned char)(byte << 1);
    s = mix(s, byte);
    byte >>= 2;
    s += byte;
  }
  return s;
}
APART static double doubles(int n) {
  while (n-- > 0)
    real = real * 1.25 - 0.125;
  return real;
}
APART static int qualified(const volatile int* const p, volatile short q[static 2]) {
  return *p + *p + q[0] - q[1]++;
}

int main(void) {
  report("reads", (unsigned)reads());
  report("writes", (unsigned)writes(20));
  report("device", drive(&device, 25));
  int count = 0;
  report("waits", (unsigned)waits(&plain, &count));
  report("wide", mix_long(0, (unsigned long long)wides(20)));
  report("pointers", (unsigned)pointers());
  report("structs", (unsigned)structs(123));
  report("bytes", bytes("each byte, twice"));
  report("real", (unsigned)(int)(doubles(9) * 10000));
  volatile short halves[2] = {30, 4};
  volatile int local[3] = {1, 2, 3};
  local[1] = local[0] + local[2];
  report("qualified", (unsigned)(qualified(local + 1, halves) + halves[1] * 100));
  return 0;
}
