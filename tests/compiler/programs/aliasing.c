/* What one pointer stores another one loads: of one type, of unions, of characters; what may not
 * be moved. */
#include "report.h"
union word { unsigned w; unsigned short h[2]; unsigned char b[4]; };
static int data[16];
__attribute__((noinline)) static void shift_by_one(int *to, const int *from, int n) {
  for (int i = 0; i < n; i++) to[i] = from[i] + 1;
}
__attribute__((noinline)) static int same(int *a, int *b) {
  *a = 1;
  *b = 2;
  return *a;
}
__attribute__((noinline)) static unsigned bytes(unsigned x) {
  union word u = {x};
  unsigned t = u.b[0];
  u.b[0] = u.b[3];
  u.b[3] = (unsigned char)t;
  u.h[1] ^= u.h[0];
  return u.w;
}
int main(void) {
  for (int i = 0; i < 16; i++) data[i] = i;
  shift_by_one(data + 1, data, 15);
  unsigned s = 0;
  for (int i = 0; i < 16; i++) s = mix(s, (unsigned)data[i]);
  report("overlap", s);
  report("same", (unsigned)same(data, data) * 16 + (unsigned)same(data, data + 1));
  report("bytes", bytes(0x12345678));
  return 0;
}
