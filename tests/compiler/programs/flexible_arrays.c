/* Structs that end in an array without length, in memory from the heap and in a static initialiser;
 * growing ones; a zero-length array; one struct seen as the head of others. */
#include <stdlib.h>
#include <string.h>

#include "report.h"

struct text {
  unsigned short length;
  char characters[];
};
struct series {
  int used, room;
  short values[];
};
struct head {
  unsigned char kind, size;
};
struct number {
  struct head head;
  int value;
};
struct name {
  struct head head;
  char letters[0];
};

static struct text fixed = {5, {'f', 'i', 'x', 'e', 'd'}};

APART static struct text* make(const char* from) {
  size_t length = strlen(from);
  struct text* t = malloc(sizeof *t + length);
  t->length = (unsigned short)length;
  memcpy(t->characters, from, length);
  return t;
}
APART static struct text* join(const struct text* a, const struct text* b) {
  struct text* t = malloc(sizeof *t + a->length + b->length);
  t->length = (unsigned short)(a->length + b->length);
  memcpy(t->characters, a->characters, a->length);
  memcpy(t->characters + a->length, b->characters, b->length);
  return t;
}
APART static struct series* push(struct series* s, int value) {
  if (s == NULL || s->used == s->room) {
    int room = s == NULL ? 2 : s->room * 2, used = s == NULL ? 0 : s->used;
    s = realloc(s, sizeof *s + (size_t)room * sizeof s->values[0]);
    s->used = used;
    s->room = room;
  }
  s->values[s->used++] = (short)value;
  return s;
}
APART static unsigned walk(const unsigned char* p, int count) {
  unsigned s = 0;
  for (int i = 0; i < count; i++) {
    const struct head* h = (const void*)p;
    if (h->kind == 1)
      s = mix(s, (unsigned)((const struct number*)(const void*)p)->value);
    else
      for (int k = 0; k < h->size - (int)sizeof(struct name); k++)
        s = mix(s, (unsigned char)((const struct name*)(const void*)p)->letters[k]);
    p += (h->size + 3) & ~3;
  }
  return s;
}
static unsigned sum_of(const struct text* t) {
  unsigned s = t->length;
  for (int i = 0; i < t->length; i++)
    s = mix(s, (unsigned char)t->characters[i]);
  return s;
}

int main(void) {
  struct text *a = make("flexible "), *b = join(a, &fixed);
  report("text", sum_of(b));
  free(a);
  free(b);
  struct series* s = NULL;
  for (int i = 0; i < 100; i++)
    s = push(s, i * i - 300);
  unsigned sum = (unsigned)s->room;
  for (int i = 0; i < s->used; i++)
    sum = mix(sum, (unsigned)s->values[i]);
  report("series", sum);
  free(s);
  static _Alignas(4) unsigned char memory[64];
  unsigned char* p = memory;
  *(struct number*)(void*)p = (struct number){{1, sizeof(struct number)}, 12345};
  p += sizeof(struct number);
  struct name* name = (void*)p;
  name->head = (struct head){2, sizeof(struct name) + 5};
  memcpy(p + sizeof(struct name), "names", 5);
  p += 8;
  *(struct number*)(void*)p = (struct number){{1, sizeof(struct number)}, -6};
  report("walk", walk(memory, 3));
  report("sizes",
         (unsigned)(sizeof(struct text) * 100 + sizeof(struct series) * 10 + sizeof(struct name)));
  return 0;
}
