// Lambdas: captures by value, by reference, of this, initialised, mutable ones; as pointers to
// functions, as arguments, returned, generic, recursive, stored in a wrapper of one's own that
// forgets the type.
#include "report.h"

namespace {

template <class Signature>
class Callback;
template <class Result, class... Arguments>
class Callback<Result(Arguments...)> {
 public:
  template <class Function>
  Callback(Function function) {
    static_assert(sizeof(Function) <= sizeof storage_, "the captures are too large");
    __builtin_memcpy(storage_, &function, sizeof function);
    call_ = [](void* storage, Arguments... arguments) -> Result {
      return (*static_cast<Function*>(storage))(arguments...);
    };
  }
  Result operator()(Arguments... arguments) { return call_(storage_, arguments...); }

 private:
  alignas(8) unsigned char storage_[16];
  Result (*call_)(void*, Arguments...);
};

APART int apply(int (*function)(int), int times, int value) {
  while (times-- > 0)
    value = function(value);
  return value;
}
APART int run(Callback<int(int, int)> callback, int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i)
    sum += callback(i, sum);
  return sum;
}
auto adder(int by) {
  return [by](int value) { return value + by; };
}

struct Account {
  int balance = 100;
  auto depositor() {
    return [this](int amount) { return balance += amount; };
  }
  auto snapshot() {
    return [*this](int factor) { return balance * factor; };
  }
};

template <class Range, class Function>
void for_each(Range& range, Function&& function) {
  for (auto& value : range)
    function(value);
}

}  // namespace

int main() {
  int base = 10, calls = 0;
  auto by_value = [base](int x) { return base + x; };
  auto by_reference = [&base](int x) { return base += x; };
  auto both = [&, base](int x) { return ++calls + base * x; };
  base = 20;
  report("values", static_cast<unsigned>(by_value(1) + by_reference(2) * 100));
  report("both", static_cast<unsigned>(both(3) + base * 1000 + calls));
  auto counter = [n = 5]() mutable { return n++; };
  auto copy = counter;
  report("mutable", static_cast<unsigned>(counter() + counter() * 10 + copy() * 100));
  report("pointer", static_cast<unsigned>(apply([](int x) { return x * 3 + 1; }, 5, 2)));
  report("returned", static_cast<unsigned>(adder(7)(8) + adder(-3)(1)));
  report("callback",
         static_cast<unsigned>(run([&](int i, int sum) { return i * base - sum / 3; }, 9)));
  report("plain", static_cast<unsigned>(run([](int i, int sum) { return i ^ sum; }, 20)));
  auto generic = [](auto a, auto b) { return sizeof(a) * 100 + sizeof(b) * 10 + (a < b); };
  report("generic", static_cast<unsigned>(generic('a', 5) + generic(1LL, 2.0f) * 1000));
  auto power = [](auto self, int x, int n) -> int {
    return n == 0 ? 1 : n % 2 ? x * self(self, x, n - 1) : self(self, x * x, n / 2);
  };
  report("recursive", static_cast<unsigned>(power(power, 3, 13)));
  Account account;
  auto deposit = account.depositor();
  auto snapshot = account.snapshot();
  deposit(50);
  report("this", static_cast<unsigned>(deposit(-20) * 1000 + snapshot(2)));
  int numbers[6] = {1, 2, 3, 4, 5, 6};
  int total = 0;
  for_each(numbers, [&total, scale = 3](int& n) {
    n *= scale;
    total += n;
  });
  report("each", static_cast<unsigned>(total * 100 + numbers[5]));
  auto compose = [](auto f, auto g) { return [=](auto x) { return f(g(x)); }; };
  report("composed", static_cast<unsigned>(compose(adder(1), [](int x) { return x * x; })(9)));
  constexpr auto square = [](int x) { return x * x; };
  static_assert(square(5) == 25, "lambdas are constant");
  report("immediate", static_cast<unsigned>([&] { return total + square(2); }()));
  return 0;
}
