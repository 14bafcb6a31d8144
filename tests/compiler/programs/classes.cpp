// C++ without its run time: virtual functions, templates, lambdas, operators, destructors, local
// statics, new and delete.
#include "report.h"

namespace {

struct Shape {
  virtual ~Shape() {}
  virtual int area() const = 0;
  virtual int twice() const { return 2 * area(); }
  int tag = 3;
};
struct Box : Shape {
  Box(int w, int h) : width(w), height(h) {}
  int area() const override { return width * height; }
  int width, height;
};
struct Square : Box {
  explicit Square(int side) : Box(side, side) {}
  int twice() const override { return -area(); }
};

template <class Value, int size>
struct Stack {
  ~Stack() { report("gone", static_cast<unsigned>(count)); }
  void push(Value value) { values[count++] = value; }
  Value pop() { return values[--count]; }
  Value values[size];
  int count = 0;
};

template <class Function>
int sum_over(Function function, int count) {
  int sum = 0;
  for (int i = 0; i < count; ++i)
    sum += function(i);
  return sum;
}

struct Vector {
  int x, y;
  Vector operator+(const Vector& other) const { return {x + other.x, y + other.y}; }
  bool operator==(const Vector& other) const { return x == other.x && y == other.y; }
};

int& same(int& value) { return value; }

int counter() {
  static int count = [] { return 40; }();
  return ++count;
}

int sum_of(const int (&values)[3]) {
  int sum = 0;
  for (int value : values)
    sum += value;
  return sum;
}

enum class Colour : unsigned char { red, green };

}  // namespace

int main() {
  Box box(3, 4);
  Square square(5);
  const Shape* shapes[] = {&box, &square};
  unsigned mixed = 0;
  for (const Shape* shape : shapes)
    mixed = mix(mixed, static_cast<unsigned>(shape->twice() + shape->tag));
  report("virtual", mixed);
  {
    Stack<long long, 8> stack;
    stack.push(1);
    stack.push(1LL << 40);
    report("stack", static_cast<unsigned>(stack.pop() >> 35));
  }
  Shape* made = new Square(9);
  int* many = new int[12];
  for (int i = 0; i < 12; ++i)
    many[i] = made->area() * i;
  report("new", static_cast<unsigned>(many[11]));
  delete[] many;
  delete made;
  int factor = 7;
  report("lambda", static_cast<unsigned>(sum_over([&](int i) { return i * factor; }, 5)));
  const Vector v = Vector{1, 2} + Vector{3, 4};
  report("vector", static_cast<unsigned>(v.x * 10 + v.y + (v == Vector{4, 6})));
  same(factor) = 9;
  report("reference", static_cast<unsigned>(factor));
  const int values[3] = {1, 2, 3};
  report("sum", static_cast<unsigned>(sum_of(values)));
  report("static", static_cast<unsigned>(counter() + counter()));
  int large = 1'000;
#ifdef __FINBACK__
  __asm__("%0 += 5;" : "+d"(large));
#else
  large += 5;
#endif
  report("large", static_cast<unsigned>(large));
  constexpr auto colour = Colour::green;
  report("colour", static_cast<unsigned>(colour));
  return 0;
}
