// DMA bursts that pass through one core's L1: whether they take a sub-bank and half from the core.
//
// Models: a DMA word takes its sub-bank, and the half that bit 2 of its address names, for one
// cycle, one word every so many cycles; DMA goes before the core. Does not model: the phase of
// SCLK, the rest of a block that the core had begun when the burst was asked for, instruction
// memory. Source: hardware.md 1.5, 2.2.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <common/units.hpp>

namespace finback::memory {

struct L1Burst {
  Address first = 0;
  std::int32_t stride = 0;
  std::uint32_t words = 0;
  Cycles start = 0;
  Cycles word = 1;  // from one to the next

  [[nodiscard]] Cycles done() const { return start + words * word; }
  // The word that passes in the cycle `now`, if one does.
  [[nodiscard]] bool passes(Cycles now, Address& address) const {
    if (now < start || now >= done() || (now - start) % word != 0) {
      return false;
    }
    address = first + static_cast<Address>(stride) * static_cast<Address>((now - start) / word);
    return true;
  }
};

class L1Bursts {
 public:
  void add(const L1Burst& burst) { bursts_.push_back(burst); }
  [[nodiscard]] bool empty() const { return bursts_.empty(); }
  // Forgets what is over at `now`; true when there was something.
  bool prune(Cycles now) {
    return std::erase_if(bursts_, [now](const L1Burst& burst) { return burst.done() <= now; }) > 0;
  }
  // Whether a word passes at `now` in the sub-bank and half of `address`.
  [[nodiscard]] bool meets(Address address, Cycles now, std::uint32_t sub_bank_bytes) const {
    return std::ranges::any_of(bursts_, [&](const L1Burst& burst) {
      Address word = 0;
      return burst.passes(now, word) && word / sub_bank_bytes == address / sub_bank_bytes &&
             ((word ^ address) & 4U) == 0;
    });
  }
  // Whether a burst touches a sub-bank of the `size` bytes at `base`.
  [[nodiscard]] bool near(Address base, std::uint32_t size, std::uint32_t sub_bank_bytes) const {
    return std::ranges::any_of(bursts_, [&](const L1Burst& burst) {
      const Address last = burst.first + static_cast<Address>(burst.stride) * (burst.words - 1);
      const Address low = std::min(burst.first, last) / sub_bank_bytes;
      const Address high = std::max(burst.first, last) / sub_bank_bytes;
      return low <= (base + (size - 1)) / sub_bank_bytes && base / sub_bank_bytes <= high;
    });
  }

 private:
  std::vector<L1Burst> bursts_;
};

}  // namespace finback::memory
