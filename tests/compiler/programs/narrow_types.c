/* Wrapping and comparing of 8 and 16 bits, averages, _Bool. */
#include "report.h"
__attribute__((noinline)) static signed char wrap8(int n) {
  signed char c = 100;
  for (int i = 0; i < n; i++) c++;
  return c;
}
__attribute__((noinline)) static unsigned short wrap16(unsigned n) {
  unsigned short s = 65000;
  while (n--) s += 7;
  return s;
}
__attribute__((noinline)) static int compare_mixed(signed char a, unsigned char b, short c, unsigned short d) {
  return (a < b) + 2 * (c < a) + 4 * (d > c) + 8 * ((unsigned char)a == b) + 16 * ((unsigned)a > d);
}
__attribute__((noinline)) static short average(const short *p, int n) {
  int sum = 0;
  for (int i = 0; i < n; i++) sum += p[i];
  return (short)(sum / n);
}
__attribute__((noinline)) static unsigned char saturate(int x) { return (unsigned char)(x < 0 ? 0 : x > 255 ? 255 : x); }
_Bool truth(int x) { return x; }
int main(void) {
  unsigned s = 0;
  for (int i = 0; i < 300; i += 13) s = mix(s, (unsigned)wrap8(i));
  for (unsigned i = 0; i < 300; i += 13) s = mix(s, wrap16(i));
  for (int i = -300; i < 300; i += 41)
    s = mix(s, (unsigned)compare_mixed((signed char)i, (unsigned char)i, (short)(i * 100), (unsigned short)(i * 200)));
  static const short numbers[] = {1, -500, 32767, 32767, -32768, 12};
  s = mix(s, (unsigned)average(numbers, 6));
  for (int i = -100; i < 400; i += 50) s = mix(s, saturate(i));
  s = mix(s, truth(256) + truth(0));
  report("narrow", s);
  return 0;
}
