// Stores to L1 that are on their way there.
//
// Models: a load that comes within some cycles after a store and shares a byte with it finds its
// data in the buffer. Does not model: how many stores the buffer holds, draining it early, partial
// forwarding. Source: hardware.md 1.5 (certainty M, hence two parameters).
#pragma once

#include <array>
#include <cstddef>

#include <isa_sim/core/core_parameters.hpp>
#include <isa_sim/core/placed.hpp>

namespace finback::core {

class StoreBuffer {
 public:
  explicit StoreBuffer(const CoreParameters& parameters)
      : stall_(cycles_of(parameters.store_buffer_stall)),
        stay_(cycles_of(parameters.store_buffer_stay)) {}

  // False: whatever a load finds there is forwarded at no cost, and nobody need ask.
  [[nodiscard]] bool stalls() const { return stall_ > 0; }

  // An access to L1 at `at`; the stall that it meets.
  [[nodiscard]] Cycles access(Address address, int bytes, bool write, Cycles at) {
    if (write) {
      stores_[next_] = {address, static_cast<Address>(bytes), at};
      next_ = (next_ + 1) % stores_.size();
      return 0;
    }
    for (const Store& store : stores_) {
      if (store.bytes != 0 && at - store.at < stay_ && address < store.address + store.bytes &&
          store.address < address + static_cast<Address>(bytes)) {
        return stall_;
      }
    }
    return 0;
  }

 private:
  struct Store {
    Address address = 0;
    Address bytes = 0;  // 0: none
    Cycles at = 0;
  };
  // A push of all registers and more: none that is young enough is lost.
  static constexpr std::size_t kStores = 32;

  Cycles stall_;
  Cycles stay_;
  std::array<Store, kStores> stores_{};
  std::size_t next_ = 0;
};

}  // namespace finback::core
