// When constructors and destructors run: of locals, members, bases, arrays, temporaries, arguments,
// in loops with breaks and returns, of what is moved, by placement; all written
// to a log.
#include "report.h"

inline void* operator new(decltype(sizeof 0), void* place) noexcept { return place; }

namespace {

unsigned history = 0;
void note(char what, int which) {
  history = mix(history, static_cast<unsigned>(what * 256 + which));
}

class Traced {
 public:
  explicit Traced(int id) : id_(id) { note('c', id_), ++alive; }
  Traced(const Traced& other) : id_(other.id_ + 100) { note('k', id_), ++alive; }
  Traced(Traced&& other) noexcept : id_(other.id_) {
    other.id_ = -1;
    note('m', id_), ++alive;
  }
  Traced& operator=(const Traced& other) {
    note('=', id_);
    id_ = other.id_;
    return *this;
  }
  Traced& operator=(Traced&& other) noexcept {
    note('>', id_);
    int kept = id_;
    id_ = other.id_;
    other.id_ = kept;
    return *this;
  }
  ~Traced() { note('d', id_), --alive; }
  int id() const { return id_; }
  static int alive;

 private:
  int id_;
};
int Traced::alive = 0;

struct Base {
  Traced first{1};
  ~Base() { note('B', 0); }
};
struct Derived : Base {
  explicit Derived(int id) : third(id) { note('D', id); }
  ~Derived() { note('E', 0); }
  Traced second{2};
  Traced third;
};
template <class T>
class Owner {
 public:
  explicit Owner(T* object) : object_(object) {}
  Owner(Owner&& other) noexcept : object_(other.object_) { other.object_ = nullptr; }
  Owner(const Owner&) = delete;
  Owner& operator=(Owner&& other) noexcept {
    T* kept = object_;
    object_ = other.object_;
    other.object_ = kept;
    return *this;
  }
  ~Owner() { delete object_; }
  T& operator*() const { return *object_; }
  T* operator->() const { return object_; }

 private:
  T* object_;
};

APART Traced made(int id) {
  Traced local(id);
  return local;
}
APART int taken(Traced by_value, const Traced& by_reference) {
  return by_value.id() * 10 + by_reference.id();
}
APART int loops(int n) {
  for (int i = 0; i < n; ++i) {
    Traced outer(30 + i);
    if (i == 1)
      continue;
    for (int k = 0; k < 3; ++k) {
      Traced inner(40 + k);
      if (k == i)
        break;
      if (i + k == 4)
        return inner.id();
    }
  }
  return -1;
}
int& shared() {
  static int once = made(77).id();
  return once;
}
template <class T>
T&& moved(T& value) {
  return static_cast<T&&>(value);
}

}  // namespace

int main() {
  {
    Traced a(5), b = made(6);
    Traced c(a), d(moved(b));
    a = d;
    c = made(8);
    report("locals", history + static_cast<unsigned>(Traced::alive));
    const Traced nine = made(9);
    report("taken", static_cast<unsigned>(taken(a, nine)));
  }
  report("gone", history + static_cast<unsigned>(Traced::alive));
  { Derived derived(3); }
  report("derived", history);
  { Traced array[3] = {Traced(50), Traced(51), made(52)}; }
  report("array", history);
  report("loops", static_cast<unsigned>(loops(2) + loops(5)) + history);
  report("static", static_cast<unsigned>(++shared() + 100) + history);
  {
    Owner<Traced> one(new Traced(60)), two(new Traced(61));
    one = moved(two);
    Owner<Derived> three(new Derived(62));
    report("owned", static_cast<unsigned>(one->id() * 100 + (*two).id() + three->third.id()));
  }
  alignas(Traced) unsigned char room[2 * sizeof(Traced)];
  Traced* placed = new (room) Traced(70);
  new (room + sizeof(Traced)) Traced(moved(*placed));
  placed[1].~Traced();
  placed->~Traced();
  const Traced& extended = made(80);
  report("placed", history + static_cast<unsigned>(Traced::alive * 1000 + extended.id()));
  return 0;
}
