// Templates: of functions and classes, of values and types, specialised, variadic, with deduction,
// recursion at compile time, static members, members that are templates, if constexpr, folds.
#include "report.h"

namespace {

template <class T>
struct TypeCode {
  static constexpr unsigned value = 0;
};
template <>
struct TypeCode<int> {
  static constexpr unsigned value = 1;
};
template <class T>
struct TypeCode<T*> {
  static constexpr unsigned value = 10 + TypeCode<T>::value;
};
template <class T, unsigned n>
struct TypeCode<T[n]> {
  static constexpr unsigned value = 100 * n + TypeCode<T>::value;
};

template <unsigned n>
constexpr unsigned factorial = n* factorial<n - 1>;
template <>
constexpr unsigned factorial<0> = 1;

template <class T, int rows, int columns>
class Matrix {
 public:
  template <class Function>
  static Matrix from(Function function) {
    Matrix m;
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x)
        m.values_[y][x] = static_cast<T>(function(y, x));
    ++made;
    return m;
  }
  template <int others>
  Matrix<T, rows, others> operator*(const Matrix<T, columns, others>& other) const {
    return Matrix<T, rows, others>::from([&](int y, int x) {
      T sum = 0;
      for (int k = 0; k < columns; ++k)
        sum = static_cast<T>(sum + at(y, k) * other.at(k, x));
      return sum;
    });
  }
  T at(int y, int x) const { return values_[y][x]; }
  static int made;

 private:
  T values_[rows][columns];
};
template <class T, int rows, int columns>
int Matrix<T, rows, columns>::made = 0;

template <class T>
const T& largest(const T& only) {
  return only;
}
template <class T, class... Others>
const T& largest(const T& first, const Others&... others) {
  const T& rest = largest(others...);
  return first < rest ? rest : first;
}
template <class... Values>
unsigned mixed(Values... values) {
  unsigned sum = sizeof...(values);
  ((sum = mix(sum, static_cast<unsigned>(values))), ...);
  return sum;
}
template <class T>
unsigned bits_of(T value) {
  if constexpr (sizeof(T) > sizeof(unsigned))
    return mix_long(0, static_cast<unsigned long long>(value));
  else
    return static_cast<unsigned>(value) & ((2u << (8 * sizeof(T) - 1)) - 1);
}
template <class T, class Less>
APART void sort(T* begin, T* end, Less less) {
  for (T* at = begin + 1; at < end; ++at) {
    T kept = *at;
    T* to = at;
    for (; to > begin && less(kept, to[-1]); --to)
      *to = to[-1];
    *to = kept;
  }
}
template <class Base>
struct Counted {
  unsigned cost() { return static_cast<Base*>(this)->weight() * 2; }
};
struct Heavy : Counted<Heavy> {
  unsigned weight() { return 21; }
};
template <template <class> class Box, class T>
T unboxed(Box<T> box) {
  return box.value;
}
template <class T>
struct Box {
  T value;
};
template <class T>
Box(T) -> Box<T>;

}  // namespace

int main() {
  report("codes", TypeCode<int>::value + TypeCode<int**>::value + TypeCode<int* [7]>::value);
  report("factorial", factorial<12>);
  auto a = Matrix<int, 2, 3>::from([](int y, int x) { return y * 5 - x; });
  auto b = Matrix<int, 3, 4>::from([](int y, int x) { return y + x * x; });
  auto c = a * b;
  unsigned sum = 0;
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x)
      sum = mix(sum, static_cast<unsigned>(c.at(y, x)));
  report("matrix", sum + static_cast<unsigned>(Matrix<int, 2, 4>::made + Matrix<int, 2, 3>::made));
  report("largest", static_cast<unsigned>(largest(3, 9, -4, 7)));
  report("mixed", mixed('a', 5, -1LL, true) + mixed());
  report("bits", bits_of<signed char>(-1) + bits_of<short>(-2) + bits_of(1LL << 40));
  short numbers[] = {5, -3, 9, 0, 2, -8};
  sort(numbers, numbers + 6, [](short x, short y) { return x > y; });
  for (short number : numbers)
    sum = mix(sum, static_cast<unsigned>(number));
  report("sort", sum);
  report("cost", Heavy().cost() + static_cast<unsigned>(unboxed(Box{6})));
  return 0;
}
