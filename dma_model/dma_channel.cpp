#include <array>
#include <fmt/format.h>

#include <common/error.hpp>
#include <dma_model/dma_channel.hpp>

namespace finback::dma {

namespace {

constexpr std::uint32_t kMaximumCount = 65536;
constexpr std::uint32_t kPeripheralMapMemoryDma = 0x40;  // CTYPE: a memory DMA channel

std::uint32_t merge_half(std::uint32_t old, std::uint32_t offset, std::uint32_t value) {
  return offset % 4 == 0 ? (old & 0xFFFF0000U) | (value & 0xFFFFU) : (old & 0xFFFFU) | value << 16U;
}

std::int32_t sign_extended(std::uint32_t modify) { return static_cast<std::int16_t>(modify); }

}  // namespace

const DeviceRegister* find_channel_register(std::uint32_t offset) {
  using enum RegisterWidth;
  static constexpr std::array<DeviceRegister, 13> kRegisters = {
      {{kNextDescriptorPointer, "NEXT_DESC_PTR", word_or_halves},
       {kStartAddress, "START_ADDR", word_or_halves},
       {kConfig, "CONFIG", half},
       {kXCount, "X_COUNT", half},
       {kXModify, "X_MODIFY", half},
       {kYCount, "Y_COUNT", half},
       {kYModify, "Y_MODIFY", half},
       {kCurrentDescriptorPointer, "CURR_DESC_PTR", word_or_halves},
       {kCurrentAddress, "CURR_ADDR", word_or_halves},
       {kIrqStatus, "IRQ_STATUS", half},
       {kPeripheralMap, "PERIPHERAL_MAP", half},
       {kCurrentXCount, "CURR_X_COUNT", half},
       {kCurrentYCount, "CURR_Y_COUNT", half}}};
  return find_register(kRegisters, offset);
}

DmaChannel::DmaChannel(std::string name, bool writes_memory)
    : name_(std::move(name)), writes_memory_(writes_memory) {}

std::uint32_t DmaChannel::word(std::uint32_t offset) const {
  switch (offset) {
    case kNextDescriptorPointer:
    case kCurrentDescriptorPointer:
      return next_descriptor_;
    case kStartAddress:
      return start_address_;
    case kConfig:
      return config_;
    case kXCount:
      return x_count_;
    case kXModify:
      return x_modify_;
    case kYCount:
      return y_count_;
    case kYModify:
      return y_modify_;
    case kCurrentAddress:
      return walk_.address();
    case kIrqStatus:
      return irq_status_;
    case kPeripheralMap:
      return kPeripheralMapMemoryDma;
    case kCurrentXCount:
      return walk_.columns_left() & 0xFFFFU;
    case kCurrentYCount:
      return walk_.rows_left() & 0xFFFFU;
    default:
      throw GuestFault(fmt::format("{} has no register at offset {:#x}", name_, offset));
  }
}

std::uint32_t DmaChannel::read(std::uint32_t offset, int bytes) const {
  const std::uint32_t value = word(offset & ~3U) >> (offset % 4 * 8);
  return bytes == 2 ? value & 0xFFFFU : value;
}

bool DmaChannel::write(std::uint32_t offset, int bytes, std::uint32_t value) {
  if (bytes == 2 && find_channel_register(offset & ~3U)->width == RegisterWidth::word_or_halves) {
    value = merge_half(word(offset & ~3U), offset, value);
    offset &= ~3U;
  }
  const std::uint32_t half = value & 0xFFFFU;
  switch (offset) {
    case kNextDescriptorPointer:
      next_descriptor_ = value;
      return false;
    case kStartAddress:
      start_address_ = value;
      return false;
    case kConfig:
      config_ = half;
      return true;
    case kXCount:
      x_count_ = half;
      return false;
    case kXModify:
      x_modify_ = half;
      return false;
    case kYCount:
      y_count_ = half;
      return false;
    case kYModify:
      y_modify_ = half;
      return false;
    case kIrqStatus:
      irq_status_ &= ~(half & (kDone | kError));
      return false;
    default:
      break;
  }
  fault(offset, value, "it is read-only");
}

void DmaChannel::fault(std::uint32_t offset, std::uint32_t value, const std::string& why) const {
  throw GuestFault(fmt::format("DMA: {}_{} = {:#x}: {}", name_, find_channel_register(offset)->name,
                               value, why));
}

TransferShape DmaChannel::shape_from_registers() const {
  const auto count = [](std::uint32_t value) { return value == 0 ? kMaximumCount : value; };
  TransferShape shape;
  shape.start = start_address_;
  shape.element_bytes = 1U << (config_ >> 2U & 3U);
  shape.x_count = count(x_count_);
  shape.x_modify = sign_extended(x_modify_);
  if ((config_ & kTwoDimensional) != 0) {
    shape.y_count = count(y_count_);
    shape.y_modify = sign_extended(y_modify_);
  }
  return shape;
}

void DmaChannel::start() {
  if (flow() > 1) {
    fault(kConfig, config_,
          fmt::format("FLOW {} (descriptors) is not modelled; use 0 (stop) or 1 (autobuffer)",
                      flow()));
  }
  if ((config_ >> 2U & 3U) == 3) {
    fault(kConfig, config_, "WDSIZE 3 is reserved; use 0, 1 or 2 for 8, 16 or 32 bits");
  }
  if (((config_ & kWriteMemory) != 0) != writes_memory_) {
    fault(
        kConfig, config_,
        writes_memory_ ? "a destination channel needs WNR = 1" : "a source channel needs WNR = 0");
  }
  shape_ = shape_from_registers();
  const std::uint32_t mask = shape_.element_bytes - 1;
  const std::string misaligned =
      fmt::format("must be a multiple of the element size, {} bytes", shape_.element_bytes);
  if ((shape_.start & mask) != 0) {
    fault(kStartAddress, start_address_, misaligned);
  }
  if ((x_modify_ & mask) != 0) {
    fault(kXModify, x_modify_, misaligned);
  }
  if ((config_ & kTwoDimensional) != 0 && (y_modify_ & mask) != 0) {
    fault(kYModify, y_modify_, misaligned);
  }
  walk_ = AddressGenerator(shape_);
  irq_status_ |= kRun;
}

}  // namespace finback::dma
