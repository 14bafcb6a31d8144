// Inheritance: virtual functions through several bases, with adjusted this, virtual bases,
// overriding at several levels, pure ones, calls from constructors, pointers to members, hidden
// names, final classes.
#include "report.h"

namespace {

struct Named {
  virtual int name() const { return 1; }
  virtual ~Named() {}
  int id = 10;
};
struct Sized {
  virtual int size() const = 0;
  virtual int doubled() const { return 2 * size(); }
  virtual ~Sized() {}
  int unit = 3;
};
struct File : Named, Sized {
  explicit File(int length) : length(length) {}
  int name() const override { return 100 + id; }
  int size() const override { return length * unit; }
  int length;
};
struct Archive final : File {
  Archive(int length, int parts) : File(length), parts(parts) {}
  int size() const override { return File::size() * parts; }
  int doubled() const override { return Sized::doubled() + 1; }
  int parts;
};
struct Clock {
  explicit Clock(int start) : ticks(start) {}
  virtual int step() { return ++ticks; }
  virtual ~Clock() {}
  int ticks;
};
struct Fast : virtual Clock {
  Fast() : Clock(1) {}
  int step() override { return ticks += 10; }
};
struct Loud : virtual Clock {
  Loud() : Clock(2) {}
  virtual int sound() { return ticks * 2; }
};
struct Alarm : Fast, Loud {
  Alarm() : Clock(1000) {}
  int sound() override { return Loud::sound() + step(); }
};
struct Early {
  Early() : seen(code()) {}
  virtual int code() const { return 5; }
  virtual ~Early() {}
  int seen;
};
struct Late : Early {
  Late() : own(code()) {}
  int code() const override { return 6; }
  int own;
};
struct Hiding : Clock {
  using Clock::Clock;
  int step(int by) { return ticks += by; }
  using Clock::step;
};
struct Empty {};
struct WithEmpty : Empty {
  int value = 4;
};
struct Device {
  int on() { return state |= 1; }
  int off() { return state &= ~1; }
  virtual int toggle() { return state ^= 1; }
  int state = 4, level = 9;
};
struct Lamp : Device {
  int toggle() override { return state ^= 3; }
};

APART int measure(const Sized& sized) { return sized.size() * 1000 + sized.doubled(); }
APART int named(const Named* named) { return named->name(); }
APART int stepped(Clock& clock) { return clock.step() + clock.step(); }
APART int call(Device& device, int (Device::*function)(), int Device::*member) {
  return (device.*function)() * 100 + device.*member;
}

}  // namespace

int main() {
  File file(7);
  Archive archive(5, 4);
  report("measured", static_cast<unsigned>(measure(file) + measure(archive)));
  report("named", static_cast<unsigned>(named(&file) + named(&archive) * 1000));
  const Sized* sized = &archive;
  report("back", static_cast<unsigned>(static_cast<const File*>(sized)->length + sized->unit));
  report("same", static_cast<const void*>(sized) != static_cast<const void*>(&archive));
  Alarm alarm;
  report("virtual", static_cast<unsigned>(stepped(alarm) + alarm.sound() * 3));
  Loud& loud = alarm;
  Clock* clock = &loud;
  report("shared", static_cast<unsigned>(loud.sound() + clock->step() + alarm.ticks));
  Late late;
  report("early", static_cast<unsigned>(late.seen * 10 + late.own));
  Hiding hiding(50);
  report("hidden", static_cast<unsigned>(hiding.step() * 1000 + hiding.step(7)));
  report("empty", sizeof(WithEmpty) + sizeof(Empty));
  Lamp lamp;
  int (Device::*const functions[])() = {&Device::on, &Device::toggle, &Device::off};
  unsigned sum = 0;
  for (auto function : functions)
    sum = mix(sum, static_cast<unsigned>(call(lamp, function, &Device::state) +
                                         call(lamp, function, &Device::level)));
  int Device::*none = nullptr;
  report("members", sum + (none == nullptr) + (functions[1] == &Device::toggle));
  Named* owned = new Archive(2, 2);
  sum = static_cast<unsigned>(owned->name());
  delete owned;
  report("deleted", sum);
  return 0;
}
