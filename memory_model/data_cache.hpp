// One core's L1 data cache: its lines, with a copy of the bytes, and which line goes.
//
// Models: up to two banks of 16 KB, two ways, lines of 32 bytes, least recently used first out;
// bits 13:12 (sub-bank) and 10:5 (set) of an address find its set, bit 14 or 23 its bank where both
// are cache. Beyond the chip's one dirty bit it knows which bytes were stored to and which were
// changed behind its back, for the warnings of stale_watch.hpp. Does not model: time
// (memory_system.hpp), the test registers' view of tags. Source: hardware.md 2.2; Programming
// Reference, chapter 6.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <common/units.hpp>
#include <memory_model/line_fill.hpp>
#include <memory_model/stale_watch.hpp>

namespace finback::memory {

// Bytes of one bank that can be cache.
inline constexpr std::uint32_t kCacheBankBytes = 16 * 1024;
inline constexpr int kDataCacheBanks = 2;

// What a store does to memory and to a line that the cache lacks.
enum class CachePolicy : std::uint8_t {
  uncached,
  write_through,           // goes to memory at once, too; only reads bring lines in
  write_through_allocate,  // the same, and stores bring lines in
  write_back,              // stays in the cache until the line goes
};

// One bit for each byte of a line.
using LineBytes = std::uint32_t;
[[nodiscard]] constexpr LineBytes line_bytes(Address address, std::uint32_t bytes) {
  return static_cast<LineBytes>((std::uint64_t{1} << bytes) - 1) << (address % kLineBytes);
}

struct CacheLine {
  Address address = 0;  // of its first byte
  bool valid = false;
  LineBytes dirty = 0;          // stored to, and not yet written back
  LineBytes stale = 0;          // changed by others since the line was filled
  std::uint32_t stored_at = 0;  // the last store's place in the code
  Accessor stale_by{};          // who changed it last
  std::array<std::uint8_t, kLineBytes> bytes{};

  [[nodiscard]] std::uint8_t* at(Address byte) { return bytes.data() + (byte - address); }
};

class DataCache {
 public:
  // The first `banks` banks (0 to 2) are cache, and empty. `high_select`: bit 23 of an address
  // tells its bank, not bit 14.
  void configure(int banks, bool high_select);
  [[nodiscard]] int banks() const { return banks_; }
  [[nodiscard]] bool on() const { return banks_ > 0; }

  [[nodiscard]] int bank_of(Address address) const {
    return banks_ < kDataCacheBanks ? 0 : static_cast<int>(address >> select_bit_ & 1U);
  }
  // The line that holds `address`, or nullptr; whoever uses it says so by touch().
  [[nodiscard]] CacheLine* find(Address address) {
    Set& set = set_of(address);
    for (CacheLine& line : set.ways) {
      if (line.valid && line.address == line_of(address)) {
        return &line;
      }
    }
    return nullptr;
  }
  // The line was used last in its set.
  void touch(const CacheLine& line) {
    Set& set = set_of(line.address);
    set.oldest = &line == set.ways.data() ? 1 : 0;
  }
  // The line that makes room for `address`: an invalid one, the first of two, or the one that was
  // not used for longer. Its content is still the old one.
  [[nodiscard]] CacheLine& victim(Address address);
  // All lines, valid or not.
  template <class Visit>
  void for_each_line(const Visit& visit) {
    for (Set& set : sets_) {
      for (CacheLine& line : set.ways) {
        visit(line);
      }
    }
  }

 private:
  static constexpr std::size_t kWays = 2;
  static constexpr std::size_t kSetsPerBank = kCacheBankBytes / kLineBytes / kWays;
  struct Set {
    std::array<CacheLine, kWays> ways;
    std::size_t oldest = 0;
  };
  // Of a cache that is on.
  [[nodiscard]] Set& set_of(Address address) {
    const std::size_t sub_bank = address >> 12U & 3U;
    const std::size_t index = address >> 5U & 63U;
    return sets_[static_cast<std::size_t>(bank_of(address)) * kSetsPerBank + (sub_bank << 6U) +
                 index];
  }

  int banks_ = 0;
  std::uint32_t select_bit_ = 14;
  std::vector<Set> sets_;
};

}  // namespace finback::memory
