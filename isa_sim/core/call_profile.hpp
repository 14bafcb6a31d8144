// Inclusive time by function: a shadow of the call stack, kept at calls and returns.
//
// Models calls by CALL and returns by RTS; a jump into another function counts for its caller. Time
// in interrupt handlers is not charged to the function that was interrupted. A recursive function
// counts its outermost call.
#pragma once

#include <cstdint>
#include <vector>

#include <common/units.hpp>

namespace finback::core {

class CallProfile {
 public:
  explicit CallProfile(std::size_t function_count) : functions_(function_count) {}

  void start(std::uint32_t function, Cycles now) { push(function, 0, now); }
  void call(std::uint32_t function, Address return_address, Cycles now) {
    push(function, return_address, now);
    ++functions_[function].calls;
  }
  // A return to `address`: ends the calls above the one that will return there; a return that
  // matches no call (a program that juggles RETS) changes nothing.
  void ret(Address address, Cycles now);
  void enter_interrupt(std::uint32_t function, Address return_address, Cycles now);
  void leave_interrupt(Cycles now);

  [[nodiscard]] std::uint64_t calls(std::uint32_t function) const {
    return functions_[function].calls;
  }
  // As if every open call returned at `now`.
  [[nodiscard]] std::vector<Cycles> inclusive(Cycles now) const;

 private:
  struct Frame {
    std::uint32_t function = 0;
    Address return_address = 0;
    Cycles entered = 0;
    Cycles stolen = 0;  // stolen_ when it was entered
    bool interrupt = false;
  };
  struct Function {
    std::uint64_t calls = 0;
    Cycles inclusive = 0;
    std::uint32_t active = 0;
  };

  void push(std::uint32_t function, Address return_address, Cycles now);
  void pop(Cycles now);

  std::vector<Function> functions_;
  std::vector<Frame> stack_;
  Cycles stolen_ = 0;  // by interrupt handlers that have returned
};

}  // namespace finback::core
