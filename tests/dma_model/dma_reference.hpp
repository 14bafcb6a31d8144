// The plain truth about a DMA channel: element by element, no time, no bursts, no FIFO.
//
// A channel is asked for its addresses one by one; it loads descriptors where its work unit ends,
// and tells after which elements it interrupts. Written from hardware.md 3.1 alone.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include <common/units.hpp>

namespace finback::dma {

struct ReferenceRegisters {
  std::uint32_t next_descriptor = 0, current_descriptor = 0, start = 0;
  std::uint16_t config = 0, x_count = 0, y_count = 0;
  std::int16_t x_modify = 0, y_modify = 0;
};

class ReferenceChannel {
 public:
  using ReadHalf = std::function<std::uint16_t(Address)>;

  ReferenceChannel(const ReferenceRegisters& registers, ReadHalf read)
      : r_(registers), read_(std::move(read)) {
    if (flow() >= 4) {
      fetch();
    } else {
      load();
    }
  }

  [[nodiscard]] bool running() const { return running_; }
  [[nodiscard]] Address address() const { return address_; }
  [[nodiscard]] std::uint32_t width() const { return 1U << (r_.config >> 2 & 3); }
  [[nodiscard]] const ReferenceRegisters& registers() const { return r_; }
  // Passes one element; true: it interrupts behind it.
  bool step() {
    const bool two_dimensional = (r_.config & 0x10) != 0;
    const bool enabled = (r_.config & 0x80) != 0;
    const bool by_row = two_dimensional && (r_.config & 0x40) != 0;
    if (++x_ < count(r_.x_count)) {
      address_ += static_cast<Address>(r_.x_modify);
      return false;
    }
    x_ = 0;
    if (two_dimensional && ++y_ < count(r_.y_count)) {
      address_ += static_cast<Address>(r_.y_modify);
      return enabled && by_row;
    }
    if (flow() == 0) {
      running_ = false;
    } else if (flow() == 1) {
      load();
    } else {
      fetch();
    }
    return enabled;
  }

 private:
  static std::uint32_t count(std::uint16_t value) { return value == 0 ? 65536 : value; }
  [[nodiscard]] int flow() const { return r_.config >> 12 & 7; }
  void load() {
    address_ = r_.start;
    x_ = y_ = 0;
  }
  void fetch() {
    const int model = flow();
    if (model != 4) {
      r_.current_descriptor = r_.next_descriptor;
    }
    std::deque<std::uint16_t> words;
    for (int left = r_.config >> 8 & 15; left > 0; --left, r_.current_descriptor += 2) {
      words.push_back(read_(r_.current_descriptor));
    }
    const auto take = [&words](const std::function<void(std::uint16_t)>& into) {
      if (!words.empty()) {
        into(words.front());
        words.pop_front();
      }
    };
    if (model >= 6) {
      take([this](std::uint16_t w) { r_.next_descriptor = (r_.next_descriptor & 0xFFFF0000) | w; });
    }
    if (model == 7) {
      take([this](std::uint16_t w) {
        r_.next_descriptor = (r_.next_descriptor & 0xFFFF) | std::uint32_t{w} << 16;
      });
    }
    take([this](std::uint16_t w) { r_.start = (r_.start & 0xFFFF0000) | w; });
    take([this](std::uint16_t w) { r_.start = (r_.start & 0xFFFF) | std::uint32_t{w} << 16; });
    take([this](std::uint16_t w) { r_.config = w; });
    take([this](std::uint16_t w) { r_.x_count = w; });
    take([this](std::uint16_t w) { r_.x_modify = static_cast<std::int16_t>(w); });
    take([this](std::uint16_t w) { r_.y_count = w; });
    take([this](std::uint16_t w) { r_.y_modify = static_cast<std::int16_t>(w); });
    running_ = (r_.config & 1) != 0;
    load();
  }

  ReferenceRegisters r_;
  ReadHalf read_;
  bool running_ = true;
  Address address_ = 0;
  std::uint32_t x_ = 0, y_ = 0;
};

}  // namespace finback::dma
