/* memcpy, memset and memmove as the compiler calls them by itself, for structs and arrays. */
#include "report.h"
void *memcpy(void *, const void *, unsigned long);
void *memset(void *, int, unsigned long);
void *memmove(void *, const void *, unsigned long);
struct block { int words[40]; char tail[3]; };
static struct block a, b;
static char text[200];
int main(void) {
  unsigned s = 0;
  for (int i = 0; i < 40; i++) a.words[i] = i * 3;
  a.tail[2] = 'x';
  b = a;
  struct block local = b;
  for (int i = 0; i < 40; i++) s = mix(s, (unsigned)local.words[i]);
  s = mix(s, (unsigned char)local.tail[2]);
  report("copy", s);
  memset(text, 'a', 100);
  for (int i = 0; i < 50; i++) text[i] = (char)('0' + i);
  memmove(text + 7, text, 60);
  memmove(text, text + 3, 90);
  memcpy(text + 150, text + 20, 33);
  for (int i = 0; i < 200; i++) s = mix(s, (unsigned char)text[i]);
  report("move", s);
  return 0;
}
