// The FIFO of a DMA channel, or of a stream's two channels: bytes in the order in which they came.
//
// Knows nothing of time or of elements; capacity is fixed when it is made.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace finback::dma {

class ByteFifo {
 public:
  explicit ByteFifo(std::uint32_t capacity) : bytes_(capacity) {}

  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] std::uint32_t capacity() const { return static_cast<std::uint32_t>(bytes_.size()); }
  [[nodiscard]] std::uint32_t room() const { return capacity() - size_; }

  // At most room() bytes.
  void push(const std::uint8_t* from, std::uint32_t count) {
    const std::uint32_t begin = (first_ + size_) % capacity();
    const std::uint32_t here = std::min(count, capacity() - begin);
    std::memcpy(bytes_.data() + begin, from, here);
    std::memcpy(bytes_.data(), from + here, count - here);
    size_ += count;
  }
  // At most size() bytes, which stay.
  void peek(std::uint8_t* to, std::uint32_t count) const {
    const std::uint32_t here = std::min(count, capacity() - first_);
    std::memcpy(to, bytes_.data() + first_, here);
    std::memcpy(to + here, bytes_.data(), count - here);
  }
  void drop(std::uint32_t count) {
    first_ = (first_ + count) % capacity();
    size_ -= count;
  }
  void clear() { size_ = 0; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint32_t first_ = 0;
  std::uint32_t size_ = 0;
};

}  // namespace finback::dma
