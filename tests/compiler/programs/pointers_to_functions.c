/* Tables of functions, methods in structs, a comparison handed to a sort. */
#include "report.h"
typedef int (*operation)(int, int);
static int add(int a, int b) { return a + b; }
static int subtract(int a, int b) { return a - b; }
static int multiply(int a, int b) { return a * b; }
static int apply_twice(operation f, int x) { return f(f(x, 3), 5); }
static const operation table[] = {add, subtract, multiply};
struct object { operation method; int state; struct object *next; };
static struct object last = {multiply, 3, 0}, middle = {subtract, 9, &last}, first = {add, 4, &middle};
__attribute__((noinline)) static int walk(struct object *o, int x) {
  for (; o != 0; o = o->next) x = o->method(x, o->state);
  return x;
}
static int compare(const void *a, const void *b) { return *(const short *)a - *(const short *)b; }
__attribute__((noinline)) static void sort(void *base, unsigned n, unsigned size, int (*less)(const void *, const void *)) {
  char *p = base;
  for (unsigned i = 1; i < n; i++)
    for (unsigned j = i; j > 0 && less(p + (j - 1) * size, p + j * size) > 0; j--)
      for (unsigned k = 0; k < size; k++) {
        char t = p[j * size + k];
        p[j * size + k] = p[(j - 1) * size + k];
        p[(j - 1) * size + k] = t;
      }
}
int main(void) {
  unsigned s = 0;
  for (int i = 0; i < 12; i++) s = mix(s, (unsigned)table[i % 3](i * 7, i - 4));
  for (int i = 0; i < 3; i++) s = mix(s, (unsigned)apply_twice(table[i], i + 10));
  report("table", s);
  report("walk", (unsigned)walk(&first, 100));
  short numbers[20];
  unsigned state = 3;
  for (int i = 0; i < 20; i++) numbers[i] = (short)next_number(&state);
  sort(numbers, 20, sizeof numbers[0], compare);
  for (int i = 0; i < 20; i++) s = mix(s, (unsigned)numbers[i]);
  report("sort", s);
  return 0;
}
