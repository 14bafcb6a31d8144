// The middle of a DMA channel: which addresses, in which order.
//
// Models the 1-D and 2-D walk of hardware.md 3.1: after each element except the last of a row
// X_MODIFY is added, after the last of a row Y_MODIFY instead; counts of 0 are 65536. Knows nothing
// of time or of what lies at an address.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <memory_model/memory_system.hpp>

namespace finback::dma {

struct TransferShape {
  Address start = 0;
  std::uint32_t element_bytes = 1;  // 1, 2 or 4
  std::uint32_t x_count = 1;        // elements of a row, 1 to 65536
  std::int32_t x_modify = 0;        // bytes
  std::uint32_t y_count = 1;        // rows, 1 to 65536
  std::int32_t y_modify = 0;        // bytes; of no effect for one row

  [[nodiscard]] std::uint64_t elements() const { return std::uint64_t{x_count} * y_count; }
};

class AddressGenerator {
 public:
  AddressGenerator() = default;
  explicit AddressGenerator(const TransferShape& shape);

  // Appends the runs of the next `count` elements (fewer at the end) and goes on behind them.
  void take(std::uint32_t count, std::vector<memory::DmaRun>& runs);

  [[nodiscard]] std::uint64_t elements_left() const {
    return rows_left_ == 0 ? 0 : std::uint64_t{rows_left_ - 1} * shape_.x_count + columns_left_;
  }
  [[nodiscard]] bool finished() const { return rows_left_ == 0; }
  // The address of the next element; one step past the last when finished.
  [[nodiscard]] Address address() const { return address_; }
  [[nodiscard]] std::uint32_t columns_left() const { return columns_left_; }
  [[nodiscard]] std::uint32_t rows_left() const { return rows_left_; }
  [[nodiscard]] std::uint32_t rows_done() const { return shape_.y_count - rows_left_; }

 private:
  TransferShape shape_;
  Address address_ = 0;
  std::uint32_t columns_left_ = 0;  // in the present row, x_count down to 1
  std::uint32_t rows_left_ = 0;
};

}  // namespace finback::dma
