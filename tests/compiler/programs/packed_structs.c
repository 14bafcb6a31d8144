/* Packed and aligned structs: members where no load of their size can go, read, written, copied, in
 * arrays, nested, with bit-fields; what is aligned to more than its size. */
#include <stddef.h>
#include <string.h>

#include "report.h"

struct __attribute__((packed)) packet {
  unsigned char kind;
  unsigned short length;
  unsigned number;
  long long time;
  double level;
  float gain;
  short samples[3];
};
struct __attribute__((packed)) inner {
  char tag;
  int value;
};
struct __attribute__((packed)) outer {
  char lead;
  struct inner inner[3];
  unsigned flags : 5, count : 12, rest : 7;
};
struct partly {
  char a;
  int b __attribute__((packed));
  short c;
};
struct __attribute__((packed, aligned(4))) even {
  char a;
  int b;
  short c;
};

APART static void fill(struct packet* p, int n) {
  p->kind = (unsigned char)n;
  p->length = (unsigned short)(n * 1000);
  p->number = (unsigned)n * 0x1234567u;
  p->time = (long long)n * -1000000007ll;
  p->level = n / 8.0;
  p->gain = (float)n * 0.25f;
  for (int i = 0; i < 3; i++)
    p->samples[i] = (short)(n * i - 500);
}
APART static unsigned sum_of(const struct packet* p) {
  unsigned s = mix(mix(p->kind, p->length), p->number);
  s = mix_long(s, (unsigned long long)p->time);
  s = mix(s, (unsigned)(int)(p->level * 8) + (unsigned)(int)(p->gain * 4));
  for (int i = 0; i < 3; i++)
    s = mix(s, (unsigned)p->samples[i]);
  return s;
}
APART static unsigned bytes_of(const void* object, size_t size) {
  unsigned char bytes[64];
  unsigned s = 0;
  memcpy(bytes, object, size);
  for (size_t i = 0; i < size; i++)
    s = mix(s, bytes[i]);
  return s;
}
APART static void change(struct outer* o, int i) {
  o->inner[i % 3].value += o->inner[(i + 1) % 3].tag;
  o->inner[i % 3].tag ^= (char)i;
  o->flags++;
  o->count += o->flags * 100u;
  o->rest = o->count >> 3;
}
APART static struct partly next(struct partly p) {
  return (struct partly){(char)(p.a + 1), p.b * 3, (short)(p.c - p.a)};
}

int main(void) {
  struct packet packets[3];
  unsigned s = 0;
  for (int i = 0; i < 3; i++)
    fill(&packets[i], i * 77 - 50);
  packets[0] = packets[2];
  packets[1].number++;
  packets[1].time >>= 3;
  packets[2].level *= 2;
  for (int i = 0; i < 3; i++) {
    s = mix(s, sum_of(&packets[i]));
    s = mix(s, bytes_of(&packets[i], sizeof packets[i]));
  }
  report("packets", s);
  struct outer o = {'o', {{'a', 1}, {'b', 2}, {'c', 3}}, 1, 2, 3};
  for (int i = 0; i < 20; i++)
    change(&o, i);
  report("outer", bytes_of(&o, sizeof o));
  struct partly p = {1, 2, 3};
  for (int i = 0; i < 9; i++)
    p = next(p);
  report("partly", mix(mix((unsigned)p.a, (unsigned)p.b), (unsigned)p.c));
  struct even e[2] = {{1, 2, 3}, {4, 5, 6}};
  e[1].b += e[0].c;
  report("even", (unsigned)(e[1].b * 100 + (int)sizeof e));
  report("sizes", (unsigned)(sizeof(struct packet) * 10000 + sizeof(struct outer) * 100 +
                             sizeof(struct partly)));
  report("offsets", (unsigned)(offsetof(struct packet, level) * 100 + offsetof(struct partly, b)));
  return 0;
}
