/* Bit-fields in storage units of more than 64 bits, packed and not. */
#include "report.h"

#pragma pack(push, 1)
struct packed {
  unsigned char before;
  unsigned a : 31;
  int b : 27;
  unsigned long long c : 45;
  int d : 3;
  unsigned e : 30;
  int f : 13;
};
#pragma pack(pop)

struct loose {
  signed char before;
  unsigned long long a : 61;
  unsigned b : 30;
  int c : 17;
  long long d : 50;
  unsigned e : 1;
};

static unsigned sum_packed(const struct packed *p) {
  unsigned sum = mix(p->before, p->a);
  sum = mix(mix(sum, (unsigned)p->b), (unsigned)p->c);
  sum = mix(mix(sum, (unsigned)(p->c >> 32)), (unsigned)p->d);
  return mix(mix(sum, p->e), (unsigned)p->f);
}

static unsigned sum_loose(const struct loose *p) {
  unsigned sum = mix((unsigned)p->before, (unsigned)p->a);
  sum = mix(mix(sum, (unsigned)(p->a >> 32)), p->b);
  sum = mix(mix(sum, (unsigned)p->c), (unsigned)p->d);
  return mix(mix(sum, (unsigned)((unsigned long long)p->d >> 32)), p->e);
}

int main(void) {
  static struct packed many[3] = {{1, 300, 3992, 12345678901ull, -2, 7, -77}};
  static struct loose other[2] = {{-1, 0x123456789abcdefull, 99, -5, -123456789012ll, 1}};
  unsigned state = 5;
  for (int i = 0; i < 40; i++) {
    struct packed *p = &many[i % 3];
    struct loose *q = &other[i % 2];
    unsigned long long wide = (unsigned long long)next_number(&state) << 20 ^ next_number(&state);
    p->a = next_number(&state);
    p->b = -(int)(next_number(&state) & 0xfffff);
    p->c ^= wide;
    p->d++;
    p->e -= p->a;
    p->f += i;
    q->a += wide << 13;
    q->b = p->e;
    q->c ^= p->b;
    q->d -= (long long)wide;
    q->e = !q->e;
  }
  for (int i = 0; i < 3; i++) report("packed", sum_packed(&many[i]));
  for (int i = 0; i < 2; i++) report("loose", sum_loose(&other[i]));
  return 0;
}
