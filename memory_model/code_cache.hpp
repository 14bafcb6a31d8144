// One core's L1 instruction cache: which lines are in it.
//
// Models: 16 KB, four ways, lines of 32 bytes; bits 13:12 (sub-bank) and 9:5 (set) of an address
// find its set; an invalid way is taken first, then the one not used for longest, among those of
// low importance if there are any; ways that are locked keep what they have. Code has no bytes
// here: the IR is symbolic (docs/bir.md), so that a changed program cannot be old in the cache.
// Does not model: time (memory_system.hpp), the test registers. Source: hardware.md 2.2;
// Programming Reference 6-15.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <common/units.hpp>
#include <memory_model/line_fill.hpp>

namespace finback::memory {

class CodeCache {
 public:
  static constexpr std::size_t kWays = 4;
  static constexpr std::uint32_t kBytes = 16 * 1024;

  // On and empty, or off.
  void configure(bool on) { sets_.assign(on ? kBytes / kLineBytes / kWays : 0, Set{}); }
  [[nodiscard]] bool on() const { return !sets_.empty(); }
  // Bit n: way n gets no new line.
  void lock(std::uint32_t ways) { locked_ = ways; }

  [[nodiscard]] bool holds(Address address) const {
    for (const Way& way : set_of(address).ways) {
      if (way.last_use != 0 && way.line == line_of(address)) {
        return true;
      }
    }
    return false;
  }
  // The line that holds `address`, which is there, is used.
  void touch(Address address);
  // Brings it in, unless all ways are locked.
  void fill(Address address, bool important);
  void forget(Address address);

 private:
  struct Way {
    Address line = 0;
    std::uint64_t last_use = 0;  // 0: invalid
    bool important = false;
  };
  struct Set {
    std::array<Way, kWays> ways;
  };
  [[nodiscard]] const Set& set_of(Address address) const {
    return sets_[(address >> 12U & 3U) << 5U | (address >> 5U & 31U)];
  }
  [[nodiscard]] Set& set_of(Address address) {
    return sets_[(address >> 12U & 3U) << 5U | (address >> 5U & 31U)];
  }

  std::vector<Set> sets_;
  std::uint32_t locked_ = 0;
  std::uint64_t uses_ = 0;
};

}  // namespace finback::memory
