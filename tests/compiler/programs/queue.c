/* A ring of bytes that fills and empties. */
#include "report.h"
#define SIZE 16
struct queue { unsigned char slots[SIZE]; unsigned head, tail; };
static struct queue q;
__attribute__((noinline)) static int put(struct queue *s, unsigned char v) {
  unsigned next = (s->head + 1) % SIZE;
  if (next == s->tail) return 0;
  s->slots[s->head] = v;
  s->head = next;
  return 1;
}
__attribute__((noinline)) static int take(struct queue *s) {
  if (s->head == s->tail) return -1;
  int v = s->slots[s->tail];
  s->tail = (s->tail + 1) & (SIZE - 1);
  return v;
}
int main(void) {
  unsigned state = 40, s = 0;
  for (int i = 0; i < 400; i++) s = mix(s, next_number(&state) % 5 < 3 ? (unsigned)put(&q, (unsigned char)i) : (unsigned)take(&q));
  report("queue", s);
  return 0;
}
