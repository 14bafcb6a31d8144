// What is called: overloads by type, constness, reference and value, default arguments, namespaces
// and argument lookup, conversions, templates against functions, references of both kinds,
// bindings.
#include "report.h"

namespace first {
struct Thing {
  int value;
};
int weigh(const Thing& thing) { return thing.value; }
int weigh(Thing&& thing) { return thing.value + 1000; }
inline namespace current {
int version() { return 2; }
}  // namespace current
}  // namespace first
namespace second = first::current;

namespace {

int kind(int) { return 1; }
int kind(unsigned) { return 2; }
int kind(long long) { return 3; }
int kind(double) { return 4; }
int kind(char) { return 5; }
int kind(bool) { return 6; }
int kind(const char*) { return 7; }
int kind(const void*) { return 8; }
int kind(decltype(nullptr)) { return 9; }
template <class T>
int kind(const T&) {
  return 20;
}
int kind(first::Thing) { return 10; }

int reference(int&) { return 1; }
int reference(const int&) { return 2; }
int reference(int&&) { return 3; }
template <class T>
int forwarded(T&& value) {
  return reference(static_cast<T&&>(value));
}
int many(int a, int b = 2, int c = 30) { return a + b * 10 + c * 100; }
int many(int a, char b) { return a - b; }

struct Convertible {
  operator int() const { return 42; }
  operator const char*() const { return "text"; }
};
struct Chain {
  int total = 0;
  Chain& add(int by) & { return total += by, *this; }
  Chain add(int by) && { return Chain{total + by * 2}; }
  int get() const { return total; }
  int get() { return -total; }
};
struct Pair {
  int a;
  short b;
};
enum Plain { zero, one };
enum class Strict { one = 1 };
using Binary = int (*)(int, int);
int sum(int a, int b) { return a + b; }
int difference(int a, int b) { return a - b; }
template <Binary function>
int applied(int a, int b) {
  return function(a, b);
}
APART Pair make(int n) { return {n, static_cast<short>(-n)}; }
int& larger(int& a, int& b) { return a > b ? a : b; }

}  // namespace

int main() {
  short small = 1;
  unsigned codes = 0;
  const int kinds[] = {kind(small),   kind(2u),
                       kind(3LL),     kind(1.5f),
                       kind('c'),     kind(true),
                       kind("s"),     kind(&small),
                       kind(nullptr), kind(first::Thing{1}),
                       kind(one),     kind(Strict::one),
                       kind('a' + 1), kind(static_cast<const void*>(&small)),
                       kind(1.5)};
  for (int code : kinds)
    codes = mix(codes, static_cast<unsigned>(code));
  report("kinds", codes);
  int object = 5;
  const int constant = 6;
  int&& named = 7;
  report("references", static_cast<unsigned>(reference(object) + reference(constant) * 10 +
                                             reference(8) * 100 + reference(named) * 1000 +
                                             forwarded(object) * 10000 + forwarded(9) * 100000));
  report("many", static_cast<unsigned>(many(1) + many(1, 3) + many(1, '\3') + many(1, 1, 1)));
  first::Thing thing{5};
  report("lookup", static_cast<unsigned>(weigh(thing) + weigh(first::Thing{6}) + second::version() +
                                         first::version()));
  Convertible convertible;
  int as_int = convertible;
  const char* as_text = convertible;
  report("conversions", static_cast<unsigned>(as_int + as_text[1]));
  Chain chain;
  const Chain& view = chain.add(1).add(2);
  report("chain",
         static_cast<unsigned>(view.get() * 100 + chain.get() + Chain{1}.add(2).add(3).get()));
  auto [a, b] = make(9);
  int numbers[] = {4, 8};
  auto& [x, y] = numbers;
  x += a;
  y -= b;
  report("bindings", static_cast<unsigned>(numbers[0] * 100 + numbers[1]));
  report("applied", static_cast<unsigned>(applied<sum>(3, 4) * 10 + applied<difference>(3, 4)));
  larger(object, x) = 99;
  report("larger", static_cast<unsigned>(object * 100 + x));
  if (int n = make(3).a; n > 2)
    report("if", static_cast<unsigned>(n));
  switch (auto p = make(4); p.b) {
    case -4:
      report("switch", 4);
      break;
    default:
      report("switch", 0);
  }
  return 0;
}
