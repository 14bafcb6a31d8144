/* What C orders: && and ||, ?:, commas, full expressions, the operands that are not evaluated at
 * all; each evaluation writes into a log. */
#include "report.h"

static char log_text[400];
static int log_length;

APART static int saw(char what, int value) {
  log_text[log_length++] = what;
  return value;
}
static void show(const char* name) {
  unsigned s = (unsigned)log_length;
  for (int i = 0; i < log_length; i++)
    s = mix(s, (unsigned char)log_text[i]);
  report(name, s);
  log_length = 0;
}

APART static int conditions(int a, int b, int c) {
  int n = 0;
  if (saw('a', a) && (saw('b', b) || saw('c', c)))
    n += 1;
  if ((saw('d', a) && saw('e', b)) || saw('f', c))
    n += 2;
  if (!(saw('g', a) || saw('h', b)) && !saw('i', c))
    n += 4;
  n += saw('j', a) ? saw('k', 10) : saw('l', b) ? saw('m', 20) : saw('n', 30);
  n += (saw('o', a) && saw('p', b)) * 100 + (saw('q', b) || saw('r', c)) * 200;
  while (saw('s', n) > 50 && saw('t', a))
    n /= 2;
  return n;
}

static int array[8];
APART static int* slot(int index) {
  saw('0' + (char)index, 0);
  return &array[index];
}

APART static int commas(int a) {
  int b = (saw('a', 1), saw('b', a)), c;
  for (c = 0, b += 1; saw('c', c) < 3; c++, b *= 2)
    saw('d', 0);
  return saw('e', b), saw('f', b), b + c;
}

static int calls(int (*function)(char, int), int a) {
  return function('x', a) ? function('y', a - 1) : function('z', 7);
}

int main(void) {
  for (int i = 0; i < 8; i++)
    report("conditions", (unsigned)conditions(i & 1, i & 2, i & 4));
  show("conditions");
  report("commas", (unsigned)commas(5));
  show("commas");
  *slot(1) = 5;
  *slot(2) += *slot(1), *slot(3) = *slot(2) + 1;
  (*slot(4))++;
  int old = array[4]++;
  report("slots", (unsigned)(array[1] + array[2] * 10 + array[3] * 100 + array[4] * 1000 + old));
  show("slots");
  int untouched = 0;
  unsigned size = sizeof(untouched++) + sizeof saw('!', 1) + _Alignof(int);
  report("sizes", size + (unsigned)untouched);
  int chosen = _Generic(untouched++, int : 3, default : 4) + (1 ? 5 : untouched++);
  report("generic", (unsigned)(chosen + untouched));
  report("calls", (unsigned)(calls(saw, 1) + calls(saw, 0)));
  int x = 0, y = 0;
  (void)(0 && ++x), (void)(1 || ++y);
  report("skipped", (unsigned)(x + y));
  show("end");
  return 0;
}
