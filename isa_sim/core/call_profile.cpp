#include <algorithm>

#include <isa_sim/core/call_profile.hpp>

namespace finback::core {

void CallProfile::push(std::uint32_t function, Address return_address, Cycles now) {
  stack_.push_back({function, return_address, now, stolen_, false});
  ++functions_[function].active;
}

void CallProfile::pop(Cycles now) {
  const Frame& frame = stack_.back();
  Function& function = functions_[frame.function];
  if (--function.active == 0) {
    function.inclusive += now - frame.entered - (stolen_ - frame.stolen);
  }
  stack_.pop_back();
}

void CallProfile::ret(Address address, Cycles now) {
  std::size_t depth = stack_.size();
  while (depth > 1 && !stack_[depth - 1].interrupt && stack_[depth - 1].return_address != address) {
    --depth;
  }
  if (depth <= 1 || stack_[depth - 1].interrupt) {
    return;
  }
  while (stack_.size() >= depth) {
    pop(now);
  }
}

void CallProfile::enter_interrupt(std::uint32_t function, Address return_address, Cycles now) {
  push(function, return_address, now);
  stack_.back().interrupt = true;
}

void CallProfile::leave_interrupt(Cycles now) {
  if (std::ranges::none_of(stack_, &Frame::interrupt)) {
    return;  // a program that begins as an event's handler
  }
  while (stack_.size() > 1) {
    const Frame frame = stack_.back();
    pop(now);
    if (frame.interrupt) {
      stolen_ = frame.stolen + (now - frame.entered);
      return;
    }
  }
}

std::vector<Cycles> CallProfile::inclusive(Cycles now) const {
  CallProfile closed = *this;
  while (!closed.stack_.empty()) {
    const bool interrupt = closed.stack_.back().interrupt;
    const Cycles entered = closed.stack_.back().entered;
    const Cycles stolen = closed.stack_.back().stolen;
    closed.pop(now);
    if (interrupt) {
      closed.stolen_ = stolen + (now - entered);
    }
  }
  std::vector<Cycles> result(functions_.size());
  std::ranges::transform(closed.functions_, result.begin(), &Function::inclusive);
  return result;
}

}  // namespace finback::core
