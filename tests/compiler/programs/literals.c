/* Literals: strings wide and of UTF-8, UTF-16 and UTF-32, escapes, joined ones, their sizes, shared
 * or not; characters; integers in all bases with all suffixes; floating point in hexadecimal. */
#include <stddef.h>

#include "report.h"

typedef __CHAR16_TYPE__ char16_t;
typedef __CHAR32_TYPE__ char32_t;

static const char escapes[] =
    "\a\b\f\n\r\t\v\\\"\'\?\0\1\12\123\x41\xff"
    "7";
static const char utf8[] = u8"\u00e4\u20ac\U0001f40b";
static const char16_t utf16[] = u"whale \u20ac \U0001f40b";
static const char32_t utf32[] = U"\U0001f40b\u00df.";
static const wchar_t wide[] =
    L"wide \x263a"
    L" text";
static char writable[16] = "fits exactly 16!";
static char shorter[4] = {"ab"};
static const char* const joined =
    "one "
    "two " /* comment */
    "three"
    " four";
static const char* const table[] = {"", "a", "tail", "same", "same"};

#define TEXT_OF(x) #x
#define JOIN(a, b) a##b

APART static unsigned sum_of(const void* p, unsigned size) {
  unsigned s = size;
  for (unsigned i = 0; i < size; i++)
    s = mix(s, ((const unsigned char*)p)[i]);
  return s;
}
APART static unsigned length(const char* p) {
  unsigned n = 0;
  while (p[n] != 0)
    n++;
  return n;
}

int main(void) {
  report("escapes", sum_of(escapes, sizeof escapes));
  report("utf8", sum_of(utf8, sizeof utf8));
  report("utf16", sum_of(utf16, sizeof utf16));
  report("utf32", sum_of(utf32, sizeof utf32));
  unsigned s = sizeof wide / sizeof *wide;
  for (unsigned i = 0; i < sizeof wide / sizeof *wide; i++)
    s = mix(s, (unsigned)wide[i]);
  report("wide", s);
  writable[4] = '_';
  report("arrays", sum_of(writable, 16) + sum_of(shorter, 4));
  report("joined", sum_of(joined, length(joined) + 1));
  for (unsigned i = 0; i < 5; i++)
    s = mix(s, sum_of(table[i], length(table[i])));
  report("table", s);
  report("characters", mix(mix('a' + '\0' * 3, (unsigned)'\xff'),
                           mix(L'\u20ac', u'\u00e4') + U'\U0001f40b' + sizeof 'c'));
  report("bases", mix(mix(0x1f + 017 + 0b1011, 0xffffffffu), mix_long(0xFFFu, 123456789012345ll)));
  report("types", sizeof(2147483648ll) * 10 + sizeof(0x80000000) + (0x80000000 > 0) * 100 +
                      (-1 < 0u) * 1000 + (2147483647 + 1u > 0) * 10000);
  double hexadecimal = 0x1.8p+3 + 0x.4p-1 + 1e2 + .5 + 3.f;
  report("floats", (unsigned)(hexadecimal * 64));
  report("macros", sum_of(TEXT_OF(a + "b\n" c), sizeof TEXT_OF(a + "b\n" c)) + JOIN(12, 34) +
                       sizeof __func__);
  report("indexed", (unsigned)("index"[2] + 3 ["abcdef"] + *"star" + (&"address"[3])[1]));
  char local[] = "local copy", *p = local;
  while (*p)
    *p++ ^= 0x20;
  report("local", sum_of(local, sizeof local));
  return 0;
}
