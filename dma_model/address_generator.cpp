#include <algorithm>

#include <dma_model/address_generator.hpp>

namespace finback::dma {

AddressGenerator::AddressGenerator(const TransferShape& shape)
    : shape_(shape),
      address_(shape.start),
      columns_left_(shape.x_count),
      rows_left_(shape.y_count) {}

void AddressGenerator::take(std::uint32_t count, std::vector<memory::DmaRun>& runs) {
  while (count > 0 && rows_left_ > 0) {
    const std::uint32_t here = std::min(count, columns_left_);
    // A row that goes on evenly into the next one (contiguous blocks) stays one run.
    const bool goes_on =
        !runs.empty() && runs.back().stride == shape_.x_modify &&
        runs.back().address + runs.back().count * static_cast<std::uint32_t>(shape_.x_modify) ==
            address_;
    if (goes_on) {
      runs.back().count += here;
    } else {
      runs.push_back({.address = address_, .stride = shape_.x_modify, .count = here});
    }
    count -= here;
    columns_left_ -= here;
    address_ += (here - 1) * static_cast<std::uint32_t>(shape_.x_modify);
    if (columns_left_ == 0) {
      --rows_left_;
      columns_left_ = shape_.x_count;
      const bool one_dimensional = shape_.y_count == 1;
      address_ += static_cast<std::uint32_t>(one_dimensional ? shape_.x_modify : shape_.y_modify);
    } else {
      address_ += static_cast<std::uint32_t>(shape_.x_modify);
    }
  }
}

}  // namespace finback::dma
