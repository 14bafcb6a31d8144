/* A hash table of words with open addressing. */
#include "report.h"
struct slot { const char *key; int value; };
static struct slot slots[64];
static const char *const words[] = {"census", "rank", "shd", "sad", "lrc", "map", "row", "disparity", "core", "shd", "dma", "row", "row"};
__attribute__((noinline)) static unsigned hash(const char *s) {
  unsigned h = 2166136261u;
  while (*s) h = (h ^ (unsigned char)*s++) * 16777619u;
  return h;
}
static int equal(const char *a, const char *b) {
  for (; *a == *b; a++, b++)
    if (!*a) return 1;
  return 0;
}
__attribute__((noinline)) static int *lookup(const char *key) {
  unsigned i = hash(key) & 63;
  while (slots[i].key && !equal(slots[i].key, key)) i = (i + 1) & 63;
  slots[i].key = key;
  return &slots[i].value;
}
int main(void) {
  for (unsigned i = 0; i < sizeof words / sizeof *words; i++) *lookup(words[i]) += (int)i * 3 + 1;
  unsigned s = 0;
  for (int i = 0; i < 64; i++) s = mix(s, slots[i].key ? (unsigned)slots[i].value + (unsigned char)slots[i].key[0] : 0);
  report("hash", s);
  return 0;
}
