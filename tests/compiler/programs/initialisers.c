/* Static initialisers: pointers to objects and functions, designators, the rest zero. */
#include "report.h"
struct entry { const char *name; int (*function)(int); short values[3]; const struct entry *link; };
static int twice(int x) { return 2 * x; }
static int square(int x) { return x * x; }
static const struct entry entries[] = {
    {"twice", twice, {1, 2, 3}, &entries[1]}, {"square", square, {-4, 5}, 0}, {.name = "none", .values = {[2] = 9}, .link = entries}};
static const unsigned char *const middle = (const unsigned char *)&entries[1].values[1];
static int grid[3][4] = {{1}, {[2] = 5}, {7, 8, 9, 10}};
static char letters[10] = "abc";
static long long wide = -1234567890123LL;
static unsigned short tiny[] = {1, 65535};
int main(void) {
  unsigned s = 0;
  for (int i = 0; i < 3; i++) {
    const struct entry *e = &entries[i];
    s = mix(s, (unsigned char)e->name[1]);
    if (e->function) s = mix(s, (unsigned)e->function(i + 5));
    for (int k = 0; k < 3; k++) s = mix(s, (unsigned)e->values[k]);
    s = mix(s, e->link ? (unsigned)(e->link - entries) : 77);
  }
  s = mix(s, *middle);
  for (int i = 0; i < 12; i++) s = mix(s, (unsigned)grid[0][i]);
  for (int i = 0; i < 10; i++) s = mix(s, (unsigned char)letters[i]);
  s = mix(s, (unsigned)wide ^ (unsigned)(wide >> 32));
  report("data", mix(s, tiny[1]));
  return 0;
}
