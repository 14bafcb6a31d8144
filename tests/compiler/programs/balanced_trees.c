/* Search trees that stay balanced: insertion and removal with rotations, by pointers to pointers;
 * the order, the depth and the balance are looked at after every step; walks without recursion. */
#include <stddef.h>

#include "report.h"

struct node {
  struct node* child[2];
  int key;
  signed char depth;
};
static struct node pool[130], *unused, *root;
static int rotations;

static int depth(const struct node* n) { return n == NULL ? 0 : n->depth; }
static void measure(struct node* n) {
  int left = depth(n->child[0]), right = depth(n->child[1]);
  n->depth = (signed char)((left > right ? left : right) + 1);
}
static void rotate(struct node** place, int to) {
  struct node *n = *place, *up = n->child[!to];
  n->child[!to] = up->child[to];
  up->child[to] = n;
  *place = up;
  measure(n);
  measure(up);
  rotations++;
}
static void balance(struct node** place) {
  struct node* n = *place;
  int lean = depth(n->child[1]) - depth(n->child[0]);
  if (lean >= -1 && lean <= 1) {
    measure(n);
    return;
  }
  int heavy = lean > 0;
  struct node* c = n->child[heavy];
  if (depth(c->child[!heavy]) > depth(c->child[heavy]))
    rotate(&n->child[heavy], heavy);
  rotate(place, !heavy);
}
static int insert(struct node** place, int key) {
  if (*place == NULL) {
    struct node* n = unused;
    unused = n->child[0];
    *n = (struct node){{NULL, NULL}, key, 1};
    *place = n;
    return 1;
  }
  if ((*place)->key == key)
    return 0;
  int added = insert(&(*place)->child[key > (*place)->key], key);
  balance(place);
  return added;
}
static void take_least(struct node** place, struct node** least) {
  if ((*place)->child[0] == NULL) {
    *least = *place;
    *place = (*place)->child[1];
    return;
  }
  take_least(&(*place)->child[0], least);
  balance(place);
}
static int erase(struct node** place, int key) {
  struct node* n = *place;
  if (n == NULL)
    return 0;
  int erased = 1;
  if (n->key != key) {
    erased = erase(&n->child[key > n->key], key);
  } else {
    if (n->child[1] == NULL) {
      *place = n->child[0];
    } else {
      struct node* least;
      take_least(&n->child[1], &least);
      least->child[0] = n->child[0];
      least->child[1] = n->child[1];
      *place = least;
    }
    n->child[0] = unused;
    unused = n;
  }
  if (*place != NULL)
    balance(place);
  return erased;
}
static unsigned walk(int* sorted) {
  struct node *stack[16], *n = root;
  int top = 0, last = -1;
  unsigned s = 0;
  *sorted = 1;
  while (n != NULL || top > 0) {
    for (; n != NULL; n = n->child[0])
      stack[top++] = n;
    n = stack[--top];
    if (n->key <= last)
      *sorted = 0;
    last = n->key;
    s = mix(s, (unsigned)n->key);
    n = n->child[1];
  }
  return s;
}
static int at_least(int key) {
  int best = -1;
  for (const struct node* n = root; n != NULL;)
    if (n->key >= key) {
      best = n->key;
      n = n->child[0];
    } else {
      n = n->child[1];
    }
  return best;
}

int main(void) {
  for (int i = 0; i < 130; i++)
    pool[i].child[0] = i < 129 ? &pool[i + 1] : NULL;
  unused = pool;
  unsigned state = 19, s = 0;
  int count = 0, sorted, all_sorted = 1;
  for (int i = 0; i < 400; i++) {
    int key = (int)(next_number(&state) % 120);
    count += i % 3 != 0 || i < 100 ? insert(&root, key) : -erase(&root, key);
    s = mix(s, (unsigned)(count * 100 + depth(root)));
    if (i % 20 == 0) {
      s = mix(s, walk(&sorted));
      all_sorted &= sorted;
    }
  }
  report("walks", s);
  report("sorted", (unsigned)(all_sorted + rotations * 10));
  for (int i = 0; i < 130; i += 7)
    s = mix(s, (unsigned)at_least(i));
  report("bounds", s);
  for (int i = 0; i < 120; i++)
    count -= erase(&root, i * 7 % 120);
  report("empty", (unsigned)count + (root == NULL));
  return 0;
}
