/* Arguments in registers and on the stack, of mixed widths; structs among them. */
#include "report.h"
struct point { int x, y; };
__attribute__((noinline)) static int nine(int a, char b, short c, long long d, unsigned char e, int f, long long g, short h, int i) {
  return a + b * 2 + c * 3 + (int)d * 5 + e * 7 + f * 11 + (int)(g >> 32) * 13 + h * 17 + i * 19;
}
__attribute__((noinline)) static struct point mixed(int a, struct point p, int b, struct point q, int c) {
  return (struct point){a * p.x + b * q.x, p.y * q.y - c};
}
__attribute__((noinline)) static long long split(int a, int b, long long c, int d) { return c * a - b + d; }
__attribute__((noinline)) static int forward(int a, int b, int c, int d, int e, int f) {
  return nine(f, (char)e, (short)d, c, (unsigned char)b, a, (long long)f << 33, (short)e, d) - a;
}
int main(void) {
  unsigned s = 0;
  for (int i = 0; i < 10; i++) {
    s = mix(s, (unsigned)nine(i, 2, -3, 4LL * i, 250, -6, -7LL << 34, 8, 9 - i));
    struct point p = mixed(i, (struct point){i + 1, 2}, 3, (struct point){-4, i}, 5);
    s = mix(s, (unsigned)(p.x ^ p.y << 8));
    s = mix(s, (unsigned)(split(i, 1, 0x100000001LL * i, 7) >> 16));
    s = mix(s, (unsigned)forward(1, i, 3, 4, 5, 6));
  }
  report("arguments", s);
  return 0;
}
