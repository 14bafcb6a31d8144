/* Lists: made, reversed, merged and searched by pointers. */
#include "report.h"
struct node { struct node *next; short value; unsigned char tag; };
static struct node pool[64];
static unsigned used;
static struct node *make(int value, struct node *next) {
  struct node *n = &pool[used++];
  n->value = (short)value;
  n->tag = (unsigned char)(value ^ 0x33);
  n->next = next;
  return n;
}
__attribute__((noinline)) static struct node *reverse(struct node *list) {
  struct node *done = 0;
  while (list) {
    struct node *next = list->next;
    list->next = done;
    done = list;
    list = next;
  }
  return done;
}
__attribute__((noinline)) static struct node *merge(struct node *a, struct node *b) {
  struct node head, *tail = &head;
  while (a && b) {
    struct node **smaller = a->value <= b->value ? &a : &b;
    tail = tail->next = *smaller;
    *smaller = (*smaller)->next;
  }
  tail->next = a ? a : b;
  return head.next;
}
__attribute__((noinline)) static struct node *sort(struct node *list) {
  if (!list || !list->next) return list;
  struct node *slow = list, *fast = list->next;
  while (fast && fast->next) slow = slow->next, fast = fast->next->next;
  struct node *half = slow->next;
  slow->next = 0;
  return merge(sort(list), sort(half));
}
int main(void) {
  unsigned state = 4, s = 0;
  struct node *list = 0;
  for (int i = 0; i < 60; i++) list = make((int)(next_number(&state) & 2047) - 1024, list);
  list = sort(reverse(list));
  for (struct node *n = list; n; n = n->next) s = mix(s, (unsigned)n->value * 256 + n->tag);
  report("list", s);
  return 0;
}
