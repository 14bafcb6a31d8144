/* Structs by value of 4 to 52 bytes, changed and returned. */
#include "report.h"
struct pair { short a, b; };
struct triple { int x, y, z; };
struct big { unsigned char name[13]; short s; int values[9]; };
struct mixed { char c; long long l; short s; };
__attribute__((noinline)) static struct pair swap(struct pair p) { return (struct pair){p.b, p.a}; }
__attribute__((noinline)) static struct triple cross(struct triple a, struct triple b) {
  return (struct triple){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
__attribute__((noinline)) static struct big change(struct big b, int at, int to) {
  b.values[at] = to;
  b.name[at] ^= 0x5a;
  b.s = (short)(b.s - at);
  return b;
}
__attribute__((noinline)) static struct mixed mixed_of(struct mixed m, int n) {
  m.l += n;
  m.s = (short)(m.s * m.c);
  return m;
}
static unsigned sum_big(const struct big *b) {
  unsigned s = (unsigned)b->s;
  for (int i = 0; i < 13; i++)
    s = mix(s, b->name[i]);
  for (int i = 0; i < 9; i++)
    s = mix(s, (unsigned)b->values[i]);
  return s;
}
int main(void) {
  struct pair p = {-3, 17};
  for (int i = 0; i < 5; i++)
    p = swap(p), p.a = (short)(p.a * 3);
  report("pair", mix((unsigned)p.a, (unsigned)p.b));
  struct triple t = {1, 2, 3}, u = {-4, 5, 6};
  for (int i = 0; i < 4; i++)
    t = cross(t, u);
  report("triple", mix(mix((unsigned)t.x, (unsigned)t.y), (unsigned)t.z));
  struct big b = {"hello world!", -7, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
  for (int i = 0; i < 9; i++)
    b = change(b, i, i * i - 20);
  report("big", sum_big(&b));
  struct mixed m = {7, 1LL << 40, -9};
  m = mixed_of(m, -5);
  report("mixed", mix((unsigned)(m.l >> 32), mix((unsigned)m.l, (unsigned)m.s)));
  return 0;
}
