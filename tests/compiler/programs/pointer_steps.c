/* Loads and stores that step their pointer, of all widths, both ways. */
#include "report.h"
static unsigned char bytes[64];
static short halves[64];
static int words[64];
__attribute__((noinline)) static unsigned up_and_down(int n) {
  unsigned s = 0;
  const unsigned char *b = bytes;
  const short *h = halves + 64;
  int *w = words;
  while (n--) {
    s += *b++;
    s ^= (unsigned)*--h;
    *w++ += (int)s;
  }
  return mix(s, (unsigned)(b - bytes) + (unsigned)(h - halves) * 64 + (unsigned)(w - words) * 4096);
}
__attribute__((noinline)) static void interleave(short *to, const unsigned char *a, const unsigned char *b, int n) {
  do {
    *to++ = *a++;
    *to++ = (short)-*b--;
  } while (--n);
}
__attribute__((noinline)) static int stride(const int *p, int step, int n) {
  int s = 0;
  for (int i = 0; i < n; i++, p += step) s = s * 3 + *p;
  return s;
}
__attribute__((noinline)) static unsigned self(unsigned *p, int n) {
  for (int i = 0; i < n; i++) {
    *p = (unsigned)i * 5;
    p++;
  }
  return (unsigned)n;
}
int main(void) {
  unsigned s = 0;
  for (int i = 0; i < 64; i++) bytes[i] = (unsigned char)(i * 37), halves[i] = (short)(i * -999), words[i] = i << 20;
  s = mix(s, up_and_down(50));
  interleave(halves, bytes, bytes + 63, 30);
  for (int i = 0; i < 64; i++) s = mix(s, (unsigned)halves[i]);
  for (int i = -3; i < 4; i++) s = mix(s, (unsigned)stride(words + 32, i, 9));
  s = mix(s, self((unsigned *)words, 10));
  for (int i = 0; i < 64; i++) s = mix(s, (unsigned)words[i]);
  report("steps", s);
  return 0;
}
