/* Initialisers of static objects that are more than numbers: addresses with offsets, of members and
 * of functions, differences, casts, sizes, conditions, numbers of every type, literals in the
 * middle. */
#include <stddef.h>
#include <stdint.h>

#include "report.h"

struct node {
  const char* name;
  struct node *next, **back;
  int (*call)(int);
  short weights[3];
};

static int add_one(int x) { return x + 1; }
static int negate(int x) { return -x; }
static int numbers[10] = {1, 2, 3, [9] = 10};
static int *const third = numbers + 2, *const last = &numbers[10] - 1;
static const int* const* const indirect = (const int* const*)&third;
static char text[] = "text to point into";
static char *const word = text + 5, *end = text + sizeof text - 1;
static const char* middle = &"a literal"[2];
static struct node nodes[3] = {
    {"first", &nodes[1], &nodes[2].next, add_one, {1, 2, 3}},
    {"second" + 3, nodes + 2, &nodes[0].next, negate, {4}},
    {.name = (const char*)&nodes[0].weights,
     .next = nodes,
     .back = &nodes[1].next,
     .call = &add_one},
};
static short* const weight = &nodes[1].weights[0] + 1;
static const uintptr_t plain = (uintptr_t)0x1234 * 2 + sizeof(struct node*) * 0;
static void* const from_number = (void*)(uintptr_t)(0x1000 | 0x20);
static const unsigned sizes[] = {sizeof numbers / sizeof *numbers, sizeof text,
                                 offsetof(
                                     struct {
                                       char a;
                                       short b;
                                       int c;
                                     },
                                     c)};
static const long long wide = (1ll << 40) - 3 * 0x7fffffffll, low = (int)0xfffffff0,
                       high = 0xfffffff0;
static const signed char narrow = (signed char)0x180 + (sizeof(int) == 4 ? 5 : 6);
static const double real = 1.0 / 3 + (float)0.1, whole = 7 / 2, negative = -(1 << 20);
static const float single = 16777217, sum = 0.1f + 0.2f;
static const _Bool truths[] = {0.5, 0, "text" != 0, -1, !5, 3 > 2 && 1 < 0};
static const enum { a = -5, b, c = b * 3, d = 'x' - sizeof(int) } enumerated[] = {a, b, c, d};
static int (*const table[2][2])(int) = {{add_one, negate}, {0, add_one}};
static const struct {
  int count;
  const int* items;
} lists[] = {{3, (const int[]){7, 8, 9}}, {1, &(const int){6}}, {0, NULL}};

int main(void) {
  *third += 100;
  *last = 77;
  report("numbers", mix((unsigned)**indirect, (unsigned)(numbers[2] + numbers[9])));
  *end = '!';
  report("text",
         mix(mix((unsigned char)word[0], (unsigned char)middle[0]), (unsigned)(end - word)));
  text[18] = 0;
  unsigned s = 0;
  const struct node* n = nodes;
  for (int i = 0; i < 7; i++) {
    s = mix(s, (unsigned)n->call(i) + (unsigned)(*n->back - nodes));
    if (n != &nodes[2])
      s = mix(s, (unsigned char)n->name[0]);
    n = n->next;
  }
  *weight = 9;
  report("nodes",
         mix(s, (unsigned)(nodes[1].weights[1] + (nodes[2].name == (char*)nodes[0].weights))));
  report("plain", (unsigned)plain + (unsigned)(uintptr_t)from_number);
  for (int i = 0; i < 3; i++)
    s = mix(s, sizes[i]);
  report("sizes", s);
  report("wide", mix_long(mix_long(mix_long(0, (unsigned long long)wide), (unsigned long long)low),
                          (unsigned long long)high));
  report("narrow", (unsigned)narrow);
  report("real", (unsigned)(real * 1e8) + (unsigned)whole + (unsigned)(int)negative +
                     (unsigned)single + (unsigned)(sum * 1e7f));
  for (int i = 0; i < 6; i++)
    s = s * 2 + truths[i];
  for (int i = 0; i < 4; i++)
    s = mix(s, (unsigned)enumerated[i]);
  report("truths", s);
  report("table", (unsigned)(table[0][1](5) * 10 + table[1][1](6) + (table[1][0] == 0)));
  report("lists", (unsigned)(lists[0].items[lists[0].count - 1] * 10 + *lists[1].items +
                             (lists[2].items == 0)));
  return 0;
}
