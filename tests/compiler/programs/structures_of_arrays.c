/* Arrays of structs in structs, members of all widths. */
#include "report.h"
struct particle { short x, y; signed char vx, vy; unsigned char alive, age; };
struct world { struct particle all[20]; int count; struct { unsigned hits[4]; unsigned short total; } statistics; };
static struct world world;
__attribute__((noinline)) static void step(struct world *w) {
  for (int i = 0; i < w->count; i++) {
    struct particle *p = &w->all[i];
    if (!p->alive) continue;
    p->x = (short)(p->x + p->vx);
    p->y = (short)(p->y + p->vy);
    if (p->x < 0 || p->x > 500) p->vx = (signed char)-p->vx, w->statistics.hits[0]++;
    if (p->y < 0 || p->y > 300) p->vy = (signed char)-p->vy, w->statistics.hits[1 + (p->y > 300)]++;
    if (++p->age > 90) p->alive = 0, w->statistics.total++;
  }
}
int main(void) {
  unsigned state = 14, s = 0;
  world.count = 20;
  for (int i = 0; i < 20; i++)
    world.all[i] = (struct particle){(short)(next_number(&state) % 500), (short)(next_number(&state) % 300),
                                     (signed char)(next_number(&state) % 41 - 20), (signed char)(next_number(&state) % 31 - 15), 1,
                                     (unsigned char)i};
  for (int i = 0; i < 80; i++) step(&world);
  for (int i = 0; i < 20; i++) s = mix(s, (unsigned)(world.all[i].x * 1000 + world.all[i].y) + world.all[i].alive);
  for (int i = 0; i < 4; i++) s = mix(s, world.statistics.hits[i]);
  report("world", mix(s, world.statistics.total));
  return 0;
}
