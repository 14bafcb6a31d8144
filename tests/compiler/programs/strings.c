/* Functions on strings written by hand: lengths, comparison, search, numbers. */
#include "report.h"
static unsigned length(const char *s) {
  const char *p = s;
  while (*p) p++;
  return (unsigned)(p - s);
}
__attribute__((noinline)) static int compare(const char *a, const char *b) {
  while (*a && *a == *b) a++, b++;
  return (unsigned char)*a - (unsigned char)*b;
}
__attribute__((noinline)) static char *append(char *to, const char *from) {
  char *p = to + length(to);
  while ((*p++ = *from++) != 0) {}
  return to;
}
__attribute__((noinline)) static void reverse(char *s) {
  for (unsigned i = 0, j = length(s); i + 1 < j; i++) {
    char t = s[i];
    s[i] = s[--j];
    s[j] = t;
  }
}
__attribute__((noinline)) static int to_number(const char *s) {
  int sign = *s == '-' ? (s++, -1) : 1, n = 0;
  for (; *s >= '0' && *s <= '9'; s++) n = n * 10 + *s - '0';
  return sign * n;
}
__attribute__((noinline)) static const char *find(const char *text, const char *what) {
  for (; *text; text++) {
    unsigned i = 0;
    while (what[i] && text[i] == what[i]) i++;
    if (!what[i]) return text;
  }
  return 0;
}
int main(void) {
  char line[64] = "stereo";
  append(append(line, " "), "vision");
  report("length", length(line));
  report("compare", (unsigned)(compare(line, "stereo visioN") > 0) + 2u * (compare("a", "b") < 0) + 4u * (compare("", "") == 0));
  report("find", (unsigned)(find(line, "vis") - line));
  report("absent", find(line, "xyz") == 0);
  reverse(line);
  unsigned s = 0;
  for (unsigned i = 0; line[i]; i++) s = mix(s, (unsigned char)line[i]);
  report("reverse", s);
  report("number", (unsigned)to_number("-20480x"));
  return 0;
}
