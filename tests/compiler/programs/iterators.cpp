// Ranges made by hand: iterators over numbers, strides, pairs, trees, filtered and mapped ones,
// through range for and algorithms of one's own; sentinels, lazy chains, move-only values, static
// polymorphism.
#include "report.h"

namespace {

class Numbers {
 public:
  struct Iterator {
    int value, step;
    int operator*() const { return value; }
    Iterator& operator++() { return value += step, *this; }
    bool operator!=(const Iterator& other) const {
      return step > 0 ? value < other.value : value > other.value;
    }
  };
  constexpr Numbers(int from, int to, int step = 1) : from_(from), to_(to), step_(step) {}
  Iterator begin() const { return {from_, step_}; }
  Iterator end() const { return {to_, step_}; }

 private:
  int from_, to_, step_;
};

template <class Range, class Test>
class Filtered {
 public:
  Filtered(const Range& range, Test test) : range_(range), test_(test) {}
  class Iterator {
   public:
    using Inner = typename Range::Iterator;
    Iterator(Inner at, Inner end, const Test& test) : at_(at), end_(end), test_(&test) { skip(); }
    auto operator*() const { return *at_; }
    Iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    bool operator!=(const Iterator& other) const { return at_ != other.at_; }

   private:
    void skip() {
      while (at_ != end_ && !(*test_)(*at_))
        ++at_;
    }
    Inner at_, end_;
    const Test* test_;
  };
  Iterator begin() const { return {range_.begin(), range_.end(), test_}; }
  Iterator end() const { return {range_.end(), range_.end(), test_}; }

 private:
  const Range range_;
  Test test_;
};

struct End {};
struct Words {
  const char* text;
  struct Iterator {
    const char* at;
    int length;
    int operator*() const { return length; }
    void operator++() {
      at += length;
      while (*at == ' ')
        ++at;
      for (length = 0; at[length] != 0 && at[length] != ' ';)
        ++length;
    }
    bool operator!=(End) const { return *at != 0; }
  };
  Iterator begin() const {
    Iterator first{text, 0};
    ++first;
    return first;
  }
  End end() const { return {}; }
};

struct Tree {
  int value;
  Tree *left, *right;
  template <class Visit>
  void each(Visit&& visit) const {
    if (left != nullptr)
      left->each(visit);
    visit(value);
    if (right != nullptr)
      right->each(visit);
  }
};
template <class T, class Range, class Combine>
APART T folded(const Range& range, T start, Combine combine) {
  for (auto&& value : range)
    start = combine(start, value);
  return start;
}
template <class Iterator, class Less>
Iterator least(Iterator from, Iterator to, Less less) {
  Iterator best = from;
  for (; from != to; ++from)
    if (less(*from, *best))
      best = from;
  return best;
}
}  // namespace

int main() {
  unsigned sum = 0;
  for (int i : Numbers(3, 20, 4))
    sum = mix(sum, static_cast<unsigned>(i));
  for (int i : Numbers(5, -6, -5))
    sum = mix(sum, static_cast<unsigned>(i));
  for (int i : Numbers(5, 5))
    sum = mix(sum, static_cast<unsigned>(i) + 0xbad);
  report("numbers", sum);
  auto odd = Filtered(Numbers(0, 40, 3), [](int x) { return x % 2 != 0; });
  auto large = Filtered(odd, [least = 12](int x) { return x > least; });
  report("filtered",
         folded(large, 7u, [](unsigned s, int x) { return mix(s, static_cast<unsigned>(x)); }));
  report("words", static_cast<unsigned>(folded(Words{" some words  of a text "}, 0,
                                               [](int s, int length) { return s * 10 + length; })));
  Tree leaves[] = {{1, nullptr, nullptr}, {4, nullptr, nullptr}, {9, nullptr, nullptr}};
  Tree inner{3, &leaves[0], &leaves[1]}, root{7, &inner, &leaves[2]};
  int order = 0;
  root.each([&order](int value) { order = order * 10 + value; });
  report("tree", static_cast<unsigned>(order));
  short values[] = {40, -3, 17, -3, 99};
  short* smallest = least(values, values + 5, [](short a, short b) { return a < b; });
  *smallest += 100;
  report("least",
         static_cast<unsigned>((smallest - values) * 1000 +
                               *least(values, values + 5, [](short a, short b) { return a > b; })));
  unsigned squares[4];
  for (auto& square : squares)
    square = static_cast<unsigned>((&square - squares) * (&square - squares));
  report("squares", folded(squares, 1u, [](unsigned s, unsigned x) { return s * 5 + x; }));
  return 0;
}
