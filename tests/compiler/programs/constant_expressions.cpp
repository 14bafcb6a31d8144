// constexpr: tables, sorting, parsing and arithmetic at compile time, the same functions at run
// time, constexpr classes, user-defined literals, enumerations with types, static_assert.
#include "report.h"

namespace {

constexpr unsigned crc_entry(unsigned x) {
  for (int i = 0; i < 8; ++i)
    x = x & 1 ? x >> 1 ^ 0xedb88320u : x >> 1;
  return x;
}
struct Table {
  unsigned values[256] = {};
  constexpr Table() {
    for (unsigned i = 0; i < 256; ++i)
      values[i] = crc_entry(i);
  }
  constexpr unsigned operator[](unsigned i) const { return values[i]; }
};
constexpr Table kTable;
static_assert(kTable[1] == 0x77073096, "a table made by the compiler");

constexpr unsigned crc(const char* text) {
  unsigned crc = ~0u;
  for (; *text != 0; ++text)
    crc = crc >> 8 ^ kTable[(crc ^ static_cast<unsigned char>(*text)) & 255];
  return ~crc;
}

template <int n>
struct Sorted {
  short values[n];
  constexpr explicit Sorted(const short (&from)[n]) : values() {
    for (int i = 0; i < n; ++i) {
      int k = i;
      for (; k > 0 && values[k - 1] > from[i]; --k)
        values[k] = values[k - 1];
      values[k] = from[i];
    }
  }
  constexpr int find(short what) const {
    int low = 0, high = n;
    while (low < high) {
      int middle = (low + high) / 2;
      if (values[middle] < what)
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  }
};
constexpr short kUnsorted[] = {30, -5, 12, 99, 0, 12, -77};
constexpr Sorted kSorted(kUnsorted);
static_assert(kSorted.find(12) == 3 && kSorted.values[0] == -77, "sorted by the compiler");

class Angle {
 public:
  constexpr explicit Angle(int sixteenths) : value_(sixteenths & 0xffff) {}
  constexpr Angle operator+(Angle other) const { return Angle(value_ + other.value_); }
  constexpr Angle operator-() const { return Angle(-value_); }
  constexpr bool operator<(Angle other) const { return value_ < other.value_; }
  constexpr int value() const { return value_; }

 private:
  int value_;
};
constexpr Angle operator""_deg(unsigned long long degrees) {
  return Angle(static_cast<int>(degrees * 65536 / 360));
}
constexpr unsigned operator""_hash(const char* text, decltype(sizeof 0) length) {
  unsigned hash = 2166136261u;
  for (unsigned i = 0; i < length; ++i)
    hash = (hash ^ static_cast<unsigned char>(text[i])) * 16777619u;
  return hash;
}
enum class Level : signed char { low = -1, middle, high };
constexpr Level next(Level level) {
  return level == Level::high ? Level::low : static_cast<Level>(static_cast<int>(level) + 1);
}
constexpr long long fibonacci(int n) { return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2); }
constexpr int kSmall = static_cast<int>(fibonacci(20));

APART int chosen(const char* word) {
  unsigned hash = 2166136261u;
  for (; *word != 0; ++word)
    hash = (hash ^ static_cast<unsigned char>(*word)) * 16777619u;
  switch (hash) {
    case "start"_hash:
      return 1;
    case "stop"_hash:
      return 2;
    case "whale"_hash:
      return 3;
    default:
      return 0;
  }
}

}  // namespace

int main() {
  constexpr unsigned at_compile_time = crc("123456789");
  report("crc", at_compile_time);
  char text[] = "123456789";
  report("same", crc(text) == at_compile_time);
  text[3] = 'x';
  report("other", crc(text));
  unsigned sum = 0;
  for (short value : kSorted.values)
    sum = mix(sum, static_cast<unsigned>(value + kSorted.find(value)));
  report("sorted", sum);
  constexpr Angle right = 90_deg;
  Angle turned = right;
  for (int i = 0; i < 3; ++i)
    turned = turned + right + -10_deg;
  report("angle", static_cast<unsigned>(turned.value() * 2 + (turned < right)));
  Level level = Level::low;
  for (int i = 0; i < 5; ++i)
    level = next(level), sum = sum * 3 + static_cast<unsigned>(level);
  report("levels", sum + sizeof level);
  report("words",
         static_cast<unsigned>(chosen("stop") * 100 + chosen("whale") * 10 + chosen("hale")));
  int array[kSmall % 10 + 3] = {};
  report("array", sizeof array / sizeof *array + static_cast<unsigned>(kSmall));
  return 0;
}
