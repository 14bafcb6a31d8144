/* Structs in structs and arrays of them: assignment of parts, addresses of members, arrays inside,
 * offsets, copies of large ones and of themselves, lists through members. */
#include <stddef.h>

#include "report.h"

struct point {
  short x, y;
};
struct line {
  struct point from, to;
  unsigned char colour[3];
};
struct drawing {
  int count;
  struct line lines[6];
  struct {
    struct point low, high;
    struct line* longest;
  } bounds;
};

static struct drawing first, second;

APART static int length(const struct line* l) {
  int dx = l->to.x - l->from.x, dy = l->to.y - l->from.y;
  return dx * dx + dy * dy;
}
APART static void add(struct drawing* d, struct point from, struct point to, unsigned colour) {
  struct line* l = &d->lines[d->count++];
  l->from = from;
  l->to = to;
  for (int i = 0; i < 3; i++)
    l->colour[i] = (unsigned char)(colour >> 8 * i);
  if (d->count == 1 || length(l) > length(d->bounds.longest))
    d->bounds.longest = l;
}
APART static void enclose(struct drawing* d) {
  struct point low = d->lines[0].from, high = low;
  for (struct line* l = d->lines; l < d->lines + d->count; l++) {
    const struct point* const ends[] = {&l->from, &l->to};
    for (int i = 0; i < 2; i++) {
      if (ends[i]->x < low.x)
        low.x = ends[i]->x;
      if (ends[i]->y < low.y)
        low.y = ends[i]->y;
      if (ends[i]->x > high.x)
        high.x = ends[i]->x;
      if (ends[i]->y > high.y)
        high.y = ends[i]->y;
    }
  }
  d->bounds.low = low;
  d->bounds.high = high;
}
APART static void reverse(struct drawing* d) {
  for (int i = 0, j = d->count - 1; i < j; i++, j--) {
    struct line kept = d->lines[i];
    d->lines[i] = d->lines[j];
    d->lines[j] = kept;
  }
  for (int i = 0; i < d->count; i++) {
    struct point kept = d->lines[i].from;
    d->lines[i].from = d->lines[i].to;
    d->lines[i].to = kept;
  }
}
static unsigned sum_of(const struct drawing* d) {
  unsigned s = (unsigned)d->count;
  for (int i = 0; i < d->count; i++) {
    const struct line* l = &d->lines[i];
    s = mix(mix(s, (unsigned)(l->from.x * 1000 + l->from.y)), (unsigned)(l->to.x * 1000 + l->to.y));
    s = mix(s, l->colour[0] + l->colour[1] * 256u + l->colour[2] * 65536u);
  }
  return mix(s, (unsigned)(d->bounds.low.x + d->bounds.low.y * 3 + d->bounds.high.x * 5 +
                           d->bounds.high.y * 7));
}
APART static void copy_through(struct drawing* to, const struct drawing* from) {
  *to = *from;
  to->bounds.longest = to->lines + (from->bounds.longest - from->lines);
}

int main(void) {
  for (int i = 0; i < 6; i++)
    add(&first, (struct point){(short)(i * 7 - 20), (short)(i * i)},
        (struct point){(short)(30 - i * 3), (short)-i}, 0x102030u * (unsigned)i);
  enclose(&first);
  report("first", sum_of(&first));
  copy_through(&second, &first);
  reverse(&second);
  report("second", sum_of(&second));
  report("longest", (unsigned)(second.bounds.longest - second.lines) * 10 +
                        (unsigned)(first.bounds.longest - first.lines));
  struct drawing* same = &first;
  *same = first;
  first.lines[2] = second.lines[3];
  first.lines[0].to = first.lines[5].from;
  report("parts", sum_of(&first));
  short* y = &first.lines[1].to.y;
  *y += 5;
  ((struct line*)(void*)((char*)y - offsetof(struct line, to.y)))->colour[1] ^= 0x55;
  report("address", sum_of(&first));
  report("sizes", (unsigned)(sizeof(struct line) * 100 + offsetof(struct line, colour[2])));
  report("offset", (unsigned)offsetof(struct drawing, lines[3].to.y));
  return 0;
}
