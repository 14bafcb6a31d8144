/* Names and how long their objects live: shadowing, block-scope externs and functions, static
 * locals in recursion and in loops, tags and labels of their own, register, automatic objects that
 * begin anew. */
#include "report.h"

int shared = 1;
static int hidden = 2;
enum { low = 1, high = 10 };
struct tag {
  int a;
};

APART static int shadowed(int x) {
  int s = x;
  {
    int x = s * 2;
    {
      short x = 7;
      s += x;
    }
    s += x;
    for (int x = 0; x < 3; x++) {
      int s = x * 100;
      x += s > 50;
    }
  }
  {
    extern int shared;
    int hidden = shared++;
    s += hidden * 1000;
  }
  return s + x + hidden;
}
APART static int tags(void) {
  struct tag {
    char a, b;
  } own = {1, 2};
  enum { low = 5, middle };
  int size = sizeof(struct tag) * 10 + low + middle;
  {
    struct tag;
    struct tag {
      long long a[3];
    };
    size += sizeof(struct tag);
  }
  typedef int tag;
  tag value = own.b;
  return size * 100 + value + high;
}
APART static int depth(int n) {
  static int deepest, calls = 100;
  int here = ++calls;
  if (n > 0)
    depth(n - 1);
  if (calls - 100 > deepest)
    deepest = calls - 100;
  return deepest * 1000 + here;
}
APART static int fresh(int n) {
  int total = 0;
  for (int i = 0; i < n; i++) {
    int array[4] = {i}, scalar = 5;
    struct tag pair[2] = {{.a = i}};
    static int kept = 3;
    scalar += array[0] + array[3] + pair[0].a + pair[1].a;
    array[3] = 99;
    pair[1].a = kept++;
    total += scalar * (array[3] + pair[1].a);
  }
  return total;
}
APART static const int* constants(int which) {
  static const int first[] = {1, 2, 3}, second[] = {4, 5, 6};
  return which ? first : second;
}
APART static int labels(int n) {
  int a = 0;
a:
  a += n;
  if (--n > 0)
    goto a;
  struct {
    int a;
  } b = {a};
b:
  if (b.a++ < 20)
    goto b;
  return a * 100 + b.a;
}
APART static int registers(register int n, register const short* p) {
  register int sum = 0;
  for (register int i = 0; i < n; i++)
    sum += *p++;
  return sum;
}
APART static int* counter(void) {
  static int count;
  count++;
  return &count;
}
static int declared_later(int), (*pointer)(int) = declared_later, plain = 4,
                                *address = &plain, array[3] = {5, 6};
static int declared_later(int x) { return x * plain + array[1]; }
APART static int old_style(a, b)
int a;
char b;
{ return a * 10 + b; }

int main(void) {
  int early(int);
  report("shadowed", (unsigned)(shadowed(3) + shadowed(4)));
  report("tags", (unsigned)tags());
  report("depth", (unsigned)(depth(3) + depth(1) * 7));
  report("fresh", (unsigned)(fresh(4) + fresh(2) * 3));
  report("constants", (unsigned)(constants(0)[1] * 10 + constants(1)[2]));
  report("labels", (unsigned)labels(4));
  static const short numbers[] = {1, -2, 30};
  report("registers", (unsigned)registers(3, numbers));
  *counter() += 10;
  report("counter", (unsigned)*counter());
  *address += 2;
  report("later", (unsigned)(pointer(7) + early(3)));
  report("old", (unsigned)old_style(5, 'c'));
  report("shared", (unsigned)(shared * 10 + hidden + low));
  return 0;
}
int early(int x) { return x + shared; }
