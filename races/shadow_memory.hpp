// For every byte of memory that was touched: who wrote it last, and who has read it since.
//
// Most bytes are read by one actor between two writes; those that several read, none of them
// ordered behind the other, keep one mark an actor. Pages come into being when they are touched.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <races/vector_clock.hpp>
#include <unordered_map>

#include <common/units.hpp>

namespace finback::races {

// An access: whose, at which of its steps, and where it was asked for (an index that the owner of
// the marks understands). Step 0: none.
struct Mark {
  std::uint32_t step = 0;
  std::uint32_t place = 0;
  std::uint8_t actor = 0;
};
// `actor` of a cell's read mark: there are several readers.
inline constexpr std::uint8_t kSeveral = 0xFF;
static_assert(kActorCount < kSeveral);

struct Cell {
  Mark write;
  Mark read;
};

class ShadowMemory {
 public:
  using Readers = std::array<Mark, kActorCount>;

  // Of the byte at `address`.
  [[nodiscard]] Cell& cell(Address address) {
    const Address page = address / kPageBytes;
    if (page != last_page_) {
      last_ = &page_at(page);
      last_page_ = page;
    }
    return last_->cells[address % kPageBytes];
  }
  // Its readers, where they are several.
  [[nodiscard]] Readers& readers(Address address) { return several_[address]; }
  void forget_readers(Address address) { several_.erase(address); }

 private:
  static constexpr Address kPageBytes = 4096;
  struct Page {
    std::array<Cell, kPageBytes> cells{};
  };
  [[nodiscard]] Page& page_at(Address page);

  std::unordered_map<Address, std::unique_ptr<Page>> pages_;
  std::unordered_map<Address, Readers> several_;
  Address last_page_ = ~Address{0};
  Page* last_ = nullptr;
};

}  // namespace finback::races
