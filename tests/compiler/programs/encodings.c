/* Bytes as text and back: hexadecimal, base 64, base 85, UTF-8, run lengths, variable-length
 * integers, Morse; what is wrong is refused. */
#include <string.h>

#include "report.h"

typedef unsigned char u8;
static const char letters64[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

static unsigned sum_of(const void* p, int n) {
  unsigned s = (unsigned)n;
  for (int i = 0; i < n; i++)
    s = mix(s, ((const u8*)p)[i]);
  return s;
}
APART static int to_base64(const u8* in, int n, char* out) {
  char* start = out;
  for (; n > 0; n -= 3, in += 3) {
    unsigned x = (unsigned)in[0] << 16 | (n > 1 ? (unsigned)in[1] << 8 : 0) | (n > 2 ? in[2] : 0);
    *out++ = letters64[x >> 18];
    *out++ = letters64[x >> 12 & 63];
    *out++ = n > 1 ? letters64[x >> 6 & 63] : '=';
    *out++ = n > 2 ? letters64[x & 63] : '=';
  }
  *out = 0;
  return (int)(out - start);
}
APART static int from_base64(const char* in, u8* out) {
  unsigned held = 0, bits = 0;
  int n = 0;
  for (; *in != 0 && *in != '='; in++) {
    const char* at = strchr(letters64, *in);
    if (at == NULL)
      return -1;
    held = held << 6 | (unsigned)(at - letters64);
    bits += 6;
    if (bits >= 8)
      out[n++] = (u8)(held >> (bits -= 8));
  }
  return n;
}
APART static void to_base85(unsigned x, char* out) {
  for (int i = 4; i >= 0; i--, x /= 85)
    out[i] = (char)('!' + x % 85);
}
APART static int to_utf8(unsigned c, u8* out) {
  if (c < 0x80)
    return *out = (u8)c, 1;
  int n = c < 0x800 ? 2 : c < 0x10000 ? 3 : 4;
  for (int i = n - 1; i > 0; i--, c >>= 6)
    out[i] = (u8)(0x80 | (c & 0x3f));
  out[0] = (u8)(0xf0 << (4 - n) | c);
  return n;
}
APART static int from_utf8(const u8* in, unsigned* c) {
  static const unsigned least[] = {0, 0, 0x80, 0x800, 0x10000};
  int n = in[0] < 0x80   ? 1
          : in[0] < 0xc0 ? 0
          : in[0] < 0xe0 ? 2
          : in[0] < 0xf0 ? 3
          : in[0] < 0xf8 ? 4
                         : 0;
  if (n < 2)
    return *c = in[0], n;
  *c = in[0] & (0x7fu >> n);
  for (int i = 1; i < n; i++) {
    if ((in[i] & 0xc0) != 0x80)
      return 0;
    *c = *c << 6 | (in[i] & 0x3f);
  }
  return *c < least[n] || (*c >= 0xd800 && *c < 0xe000) || *c > 0x10ffff ? 0 : n;
}
APART static int to_runs(const u8* in, int n, u8* out) {
  int written = 0;
  for (int i = 0; i < n;) {
    int run = 1;
    while (i + run < n && run < 255 && in[i + run] == in[i])
      run++;
    out[written++] = (u8)run;
    out[written++] = in[i];
    i += run;
  }
  return written;
}
APART static int to_variable(unsigned long long x, u8* out) {
  int n = 0;
  for (; x >= 0x80; x >>= 7)
    out[n++] = (u8)(x | 0x80);
  out[n++] = (u8)x;
  return n;
}
static unsigned zigzag(int x) { return (unsigned)x << 1 ^ (unsigned)(x >> 31); }
static int from_zigzag(unsigned x) { return (int)(x >> 1) ^ -(int)(x & 1); }
APART static int from_hexadecimal(const char* in, u8* out) {
  int n = 0;
  for (; in[0] != 0; in += 2, n++) {
    int value = 0;
    for (int i = 0; i < 2; i++) {
      int c = in[i] | 0x20, digit = c >= '0' && c <= '9'   ? c - '0'
                                    : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                                           : -1;
      if (digit < 0)
        return -n - 1;
      value = value * 16 + digit;
    }
    out[n] = (u8)value;
  }
  return n;
}

int main(void) {
  u8 bytes[64], back[200];
  char text[100];
  unsigned s = 0, c;
  for (int i = 0; i < 64; i++)
    bytes[i] = (u8)(i * i * 5 + (i >> 2));
  for (int n = 0; n < 20; n++) {
    s = mix(s, sum_of(text, to_base64(bytes, n, text)));
    s = mix(s, from_base64(text, back) == n && memcmp(bytes, back, (unsigned)n) == 0);
  }
  report("base64", s + (unsigned)from_base64("ab*d", back));
  to_base85(0xdeadbeef, text);
  report("base85", sum_of(text, 5));
  for (unsigned x = 1; x < 0x110000; x = x * 3 + 1) {
    int n = to_utf8(x, back);
    s = mix(s, sum_of(back, n) + (from_utf8(back, &c) == n && c == x));
  }
  s = s * 16 +
      (unsigned)(from_utf8((const u8*)"\xc0\x80", &c) + from_utf8((const u8*)"\xed\xa0\x80", &c) +
                 from_utf8((const u8*)"\xe2\x28", &c));
  report("utf8", s);
  memset(bytes + 10, 7, 30);
  report("runs", sum_of(back, to_runs(bytes, 64, back)));
  for (int x = -70000; x < 70000; x += 4999)
    s = mix(s,
            sum_of(back, to_variable(zigzag(x), back)) + (unsigned)(from_zigzag(zigzag(x)) == x));
  report("variable", mix(s, sum_of(back, to_variable(1ull << 62 | 5, back))));
  report("hexadecimal", sum_of(back, from_hexadecimal("00fFa5C3", back)) +
                            (unsigned)from_hexadecimal("12g4", back));
  return 0;
}
