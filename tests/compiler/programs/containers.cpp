// Containers of one's own, as a program without a library has them: a growing array, a list, a map
// by hashes, a string; iterators in range for, moves, structured bindings, references to elements.
#include <string.h>

#include "report.h"

namespace {

template <class T>
class Array {
 public:
  Array() = default;
  Array(const Array& other) { *this = other; }
  Array(Array&& other) noexcept : items_(other.items_), count_(other.count_), room_(other.room_) {
    other.items_ = nullptr;
    other.count_ = other.room_ = 0;
  }
  Array& operator=(const Array& other) {
    if (this != &other) {
      count_ = 0;
      for (const T& item : other)
        push(item);
    }
    return *this;
  }
  ~Array() { delete[] items_; }
  void push(const T& item) {
    if (count_ == room_) {
      room_ = room_ == 0 ? 2 : room_ * 2;
      T* larger = new T[static_cast<unsigned>(room_)];
      for (int i = 0; i < count_; ++i)
        larger[i] = items_[i];
      delete[] items_;
      items_ = larger;
    }
    items_[count_++] = item;
  }
  T& operator[](int i) { return items_[i]; }
  T* begin() { return items_; }
  T* end() { return items_ + count_; }
  const T* begin() const { return items_; }
  const T* end() const { return items_ + count_; }
  int size() const { return count_; }

 private:
  T* items_ = nullptr;
  int count_ = 0, room_ = 0;
};

class Text {
 public:
  Text(const char* from = "") { assign(from, strlen(from)); }
  Text(const Text& other) { assign(other.letters_, other.length_); }
  Text& operator=(const Text& other) {
    if (this != &other) {
      delete[] letters_;
      assign(other.letters_, other.length_);
    }
    return *this;
  }
  ~Text() { delete[] letters_; }
  Text operator+(const Text& other) const {
    Text joined(*this);
    char* both = new char[length_ + other.length_ + 1];
    memcpy(both, letters_, length_);
    memcpy(both + length_, other.letters_, other.length_ + 1);
    delete[] joined.letters_;
    joined.letters_ = both;
    joined.length_ = length_ + other.length_;
    return joined;
  }
  bool operator==(const Text& other) const { return strcmp(letters_, other.letters_) == 0; }
  unsigned hash() const {
    unsigned hash = 5381;
    for (size_t i = 0; i < length_; ++i)
      hash = hash * 33 + static_cast<unsigned char>(letters_[i]);
    return hash;
  }

 private:
  void assign(const char* from, size_t length) {
    letters_ = new char[length + 1];
    length_ = length;
    memcpy(letters_, from, length);
    letters_[length] = 0;
  }
  char* letters_;
  size_t length_;
};

template <class Value>
class Map {
 public:
  struct Entry {
    Text key;
    Value value{};
  };
  Value& operator[](const Text& key) {
    Array<Entry>& bucket = buckets_[key.hash() % 7];
    for (Entry& entry : bucket)
      if (entry.key == key)
        return entry.value;
    bucket.push({key, Value{}});
    return bucket[bucket.size() - 1].value;
  }
  template <class Function>
  void each(Function function) const {
    for (const auto& bucket : buckets_)
      for (const auto& [key, value] : bucket)
        function(key, value);
  }

 private:
  Array<Entry> buckets_[7];
};

}  // namespace

int main() {
  Array<int> numbers;
  for (int i = 0; i < 50; ++i)
    numbers.push(i * i);
  Array<int> copy(numbers), moved(static_cast<Array<int>&&>(numbers));
  copy[3] = -1;
  unsigned sum = static_cast<unsigned>(numbers.size());
  for (int number : moved)
    sum = mix(sum, static_cast<unsigned>(number));
  report("numbers", sum + static_cast<unsigned>(copy[3] + copy.size()));
  Map<int> counts;
  const char* const words[] = {"one", "two", "one", "three", "two", "one"};
  for (const char* word : words)
    counts[word] += 1;
  counts[Text("th") + "ree"] *= 10;
  unsigned all = 0;
  counts.each(
      [&](const Text& key, int count) { all += key.hash() * static_cast<unsigned>(count); });
  report("counts", all);
  Map<Array<Text>> groups;
  for (int i = 0; i < 12; ++i)
    groups[i % 3 == 0 ? "fizz" : "rest"].push(Text(i & 1 ? "odd" : "even"));
  sum = 0;
  for (const Text& text : groups["fizz"])
    sum = mix(sum, text.hash());
  report("groups", sum + static_cast<unsigned>(groups["rest"].size()));
  return 0;
}
