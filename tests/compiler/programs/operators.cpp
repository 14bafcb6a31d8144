// Operators of one's own: arithmetic, comparison, assignment, increments, subscripts, calls,
// conversions, arrow and star, comma, shifts as streams; friends; what overload resolution chooses.
#include "report.h"

namespace {

class Fraction {
 public:
  Fraction(int numerator = 0, int denominator = 1) : n_(numerator), d_(denominator) { reduce(); }
  Fraction& operator+=(const Fraction& o) {
    n_ = n_ * o.d_ + o.n_ * d_;
    d_ *= o.d_;
    reduce();
    return *this;
  }
  Fraction& operator*=(const Fraction& o) { return *this = Fraction(n_ * o.n_, d_ * o.d_); }
  friend Fraction operator+(Fraction a, const Fraction& b) { return a += b; }
  friend Fraction operator*(Fraction a, const Fraction& b) { return a *= b; }
  Fraction operator-() const { return {-n_, d_}; }
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return a + -b; }
  friend bool operator<(const Fraction& a, const Fraction& b) { return a.n_ * b.d_ < b.n_ * a.d_; }
  friend bool operator==(const Fraction& a, const Fraction& b) {
    return a.n_ == b.n_ && a.d_ == b.d_;
  }
  Fraction& operator++() { return *this += 1; }
  Fraction operator++(int) {
    Fraction old = *this;
    ++*this;
    return old;
  }
  explicit operator bool() const { return n_ != 0; }
  explicit operator int() const { return n_ / d_; }
  unsigned code() const { return static_cast<unsigned>(n_ * 1000 + d_); }

 private:
  void reduce() {
    int a = n_ < 0 ? -n_ : n_, b = d_;
    while (b != 0) {
      int rest = a % b;
      a = b;
      b = rest;
    }
    if (a > 1) {
      n_ /= a;
      d_ /= a;
    }
  }
  int n_, d_;
};

class Bits {
 public:
  class Reference {
   public:
    Reference(Bits& bits, int at) : bits_(bits), at_(at) {}
    Reference& operator=(bool value) {
      bits_.word_ = (bits_.word_ & ~(1u << at_)) | static_cast<unsigned>(value) << at_;
      return *this;
    }
    Reference& operator=(const Reference& other) { return *this = static_cast<bool>(other); }
    Reference(const Reference&) = default;
    operator bool() const { return bits_.word_ >> at_ & 1; }

   private:
    Bits& bits_;
    int at_;
  };
  Reference operator[](int at) { return {*this, at}; }
  bool operator[](int at) const { return word_ >> at & 1; }
  Bits operator~() const { return Bits{~word_}; }
  friend Bits operator^(Bits a, Bits b) { return Bits{a.word_ ^ b.word_}; }
  unsigned operator()() const { return word_; }
  unsigned operator()(int low, int high) const { return word_ >> low & ((2u << (high - low)) - 1); }
  explicit Bits(unsigned word = 0) : word_(word) {}

 private:
  unsigned word_;
};

struct Log {
  unsigned sum = 0;
  Log& operator<<(int value) { return sum = mix(sum, static_cast<unsigned>(value)), *this; }
  Log& operator<<(char value) { return sum = mix(sum, static_cast<unsigned>(value) + 5000), *this; }
  Log& operator<<(const char* text) {
    while (*text != 0)
      *this << *text++;
    return *this;
  }
  Log& operator<<(bool value) { return *this << (value ? "yes" : "no"); }
  Log& operator<<(long long value) {
    return sum = mix_long(sum, static_cast<unsigned long long>(value)), *this;
  }
};
struct Handle {
  Log* log;
  Log* operator->() const { return log; }
  Log& operator*() const { return *log; }
  unsigned operator,(unsigned right) const { return log->sum ^ right; }
};

}  // namespace

int main() {
  Fraction half(1, 2), sum;
  for (int i = 1; i < 8; ++i)
    sum += Fraction(1, i) * half - Fraction(i % 3, 4);
  report("sum", sum.code());
  Fraction before = sum++;
  report("increments", before.code() ^ (++sum).code() * 3);
  report("compared",
         static_cast<unsigned>((half < sum) + 2 * (half == Fraction(4, 8)) + 4 * (sum ? 1 : 0)));
  report("int", static_cast<unsigned>(static_cast<int>(Fraction(-17, 5) + 1)));
  Bits bits;
  for (int i = 0; i < 32; i += 3)
    bits[i] = i % 2 == 0;
  bits[1] = bits[6];
  const Bits other = ~bits ^ Bits(0x0ff0);
  report("bits", bits() + other(4, 11) * 3 + other[5]);
  Log log;
  log << 5 << 'c' << "text" << true << 7LL << (half < 1);
  Handle handle{&log};
  *handle << static_cast<int>(handle->sum % 100);
  report("log", (handle, 77u));
  return 0;
}
