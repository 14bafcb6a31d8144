#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <common/error.hpp>
#include <dma_model/dma_channel.hpp>

namespace finback::dma {

namespace {

constexpr std::uint32_t kMaximumCount = 65536;
constexpr std::uint32_t kMemoryDma = 0x40;  // PERIPHERAL_MAP.CTYPE
constexpr std::uint32_t kPeripheralCount = 12;

std::uint32_t merge_half(std::uint32_t old, std::uint32_t offset, std::uint32_t value) {
  return offset % 4 == 0 ? (old & 0xFFFF0000U) | (value & 0xFFFFU) : (old & 0xFFFFU) | value << 16U;
}

std::int32_t sign_extended(std::uint32_t modify) { return static_cast<std::int16_t>(modify); }

// The most words that a descriptor of this flow has; 0: the flow has none. Its last words are
// START_ ADDR (2), CONFIG, X_COUNT, X_MODIFY, Y_COUNT, Y_MODIFY; a list has NEXT_DESC_PTR in front,
// whole or its lower half.
std::uint32_t most_descriptor_words(Flow flow) {
  switch (flow) {
    case Flow::array:
      return 7;
    case Flow::small_list:
      return 8;
    case Flow::large_list:
      return 9;
    default:
      return 0;
  }
}

bool is_flow(Flow flow) {
  return flow == Flow::stop || flow == Flow::autobuffer || most_descriptor_words(flow) != 0;
}

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
  return finback::find_register(kRegisters, offset);
}

DmaChannel::DmaChannel(std::string name, ChannelKind kind, std::uint32_t peripheral)
    : name_(std::move(name)),
      kind_(kind),
      peripheral_map_(kind == ChannelKind::peripheral ? peripheral << 12U : kMemoryDma) {}

std::uint32_t DmaChannel::word(std::uint32_t offset) const {
  switch (offset) {
    case kNextDescriptorPointer:
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
    case kCurrentDescriptorPointer:
      return current_descriptor_;
    case kCurrentAddress:
      return running() ? walk_.address() : resting_address_;
    case kIrqStatus:
      return irq_status_;
    case kPeripheralMap:
      return peripheral_map_;
    case kCurrentXCount:
      return (running() ? walk_.columns_left() : resting_x_) & 0xFFFFU;
    default:
      return (running() ? walk_.rows_left() : resting_y_) & 0xFFFFU;
  }
}

std::uint32_t DmaChannel::read(std::uint32_t offset, int bytes) const {
  const std::uint32_t value = word(offset & ~3U);
  return bytes == 2 ? value >> (offset % 4 * 8) & 0xFFFFU : value;
}

void DmaChannel::store(std::uint32_t offset, std::uint32_t value) {
  const std::uint32_t half = value & 0xFFFFU;
  switch (offset) {
    case kNextDescriptorPointer:
      next_descriptor_ = value;
      break;
    case kStartAddress:
      start_address_ = value;
      break;
    case kXCount:
      x_count_ = half;
      break;
    case kXModify:
      x_modify_ = half;
      break;
    case kYCount:
      y_count_ = half;
      break;
    case kYModify:
      y_modify_ = half;
      break;
    case kCurrentDescriptorPointer:
      current_descriptor_ = value;
      break;
    case kCurrentAddress:
      resting_address_ = value;
      break;
    case kCurrentXCount:
      resting_x_ = half;
      break;
    case kCurrentYCount:
      resting_y_ = half;
      break;
    default:
      break;
  }
}

DmaChannel::Written DmaChannel::write(std::uint32_t offset, int bytes, std::uint32_t value) {
  const std::uint32_t base = offset & ~3U;
  if (bytes == 2 && find_channel_register(base)->width == RegisterWidth::word_or_halves) {
    value = merge_half(word(base), offset, value);
  }
  if (base == kIrqStatus) {
    irq_status_ &= ~(value & (kDone | kError));
    interrupt_ = interrupt_ && (irq_status_ & kDone) != 0;
    return Written::nothing;
  }
  if (running() && (base != kConfig || (value & kEnable) != 0)) {
    throw error(base, value,
                "it was written while the channel runs; wait for RUN = 0 in IRQ_STATUS, or write "
                "CONFIG = 0 first");
  }
  if (base == kConfig) {
    config_ = value & 0xFFFFU;
    return (config_ & kEnable) != 0 ? Written::enabled : Written::disabled;
  }
  if (base != kPeripheralMap) {
    store(base, value);
    return Written::nothing;
  }
  if (kind_ == ChannelKind::peripheral) {  // memory DMA has nothing to choose from
    if ((value >> 12U & 0xFU) >= kPeripheralCount) {
      throw error(base, value, fmt::format("PMAP must be below {}", kPeripheralCount));
    }
    peripheral_map_ = value & 0xF000U;
  }
  return Written::map;
}

DmaError DmaChannel::error(std::uint32_t offset, std::uint32_t value,
                           const std::string& why) const {
  return DmaError(fmt::format("DMA: {}_{} = {:#x}: {}", name_, find_channel_register(offset)->name,
                              value, why));
}

void DmaChannel::check_config() const {
  const auto refuse = [this](const std::string& why) { return error(kConfig, config_, why); };
  if (!is_flow(flow()) || (config_ & 0x8000U) != 0) {
    throw refuse(
        fmt::format("FLOW {} is reserved; use 0 (stop), 1 (autobuffer), 4 (descriptor array), 6 "
                    "(small list) or "
                    "7 (large list), and 0 for bit 15",
                    config_ >> 12U & 7U));
  }
  const std::uint32_t most = most_descriptor_words(flow());
  if (most == 0 && descriptor_words() != 0) {
    throw refuse(fmt::format("NDSIZE {} with FLOW {}, which has no descriptors; it must be 0",
                             descriptor_words(), config_ >> 12U));
  }
  if (most != 0 && (descriptor_words() == 0 || descriptor_words() > most)) {
    throw refuse(fmt::format("NDSIZE {} does not fit FLOW {}; use 1 to {}", descriptor_words(),
                             config_ >> 12U, most));
  }
  if ((config_ >> 2U & 3U) == 3) {
    throw refuse("WDSIZE 3 is reserved; use 0, 1 or 2 for 8, 16 or 32 bits");
  }
  if (kind_ == ChannelKind::destination && !writes_memory()) {
    throw refuse("a destination channel needs WNR = 1");
  }
  if (kind_ == ChannelKind::source && writes_memory()) {
    throw refuse("a source channel needs WNR = 0");
  }
}

void DmaChannel::check_shape() const {
  const std::uint32_t mask = shape_.element_bytes - 1;
  const std::string misaligned =
      fmt::format("must be a multiple of the element size, {} bytes", shape_.element_bytes);
  if ((shape_.start & mask) != 0) {
    throw error(kStartAddress, start_address_, misaligned);
  }
  if ((x_modify_ & mask) != 0) {
    throw error(kXModify, x_modify_, misaligned);
  }
  if ((config_ & kTwoDimensional) != 0 && (y_modify_ & mask) != 0) {
    throw error(kYModify, y_modify_, misaligned);
  }
}

void DmaChannel::start() {
  check_config();
  irq_status_ |= kRun;
  finishing_ = false;
  if (by_descriptors()) {
    want_descriptor();
  } else {
    load_unit();
  }
}

void DmaChannel::want_descriptor() {
  if (flow() != Flow::array) {
    current_descriptor_ = next_descriptor_;
  }
  if (current_descriptor_ % 2 != 0) {
    throw error(flow() == Flow::array ? kCurrentDescriptorPointer : kNextDescriptorPointer,
                current_descriptor_, "a descriptor must lie at an even address");
  }
  irq_status_ |= kDescriptorFetch;
}

memory::DmaRun DmaChannel::descriptor() const {
  return {.address = current_descriptor_, .stride = 2, .count = descriptor_words()};
}

void DmaChannel::load_descriptor(std::span<const std::uint16_t> words) {
  current_descriptor_ += 2 * static_cast<std::uint32_t>(words.size());
  std::uint32_t element = 9 - most_descriptor_words(flow());  // of the longest layout
  if (flow() == Flow::small_list) {
    next_descriptor_ = (next_descriptor_ & 0xFFFF0000U) | words.front();
    words = words.subspan(1);
    element = 2;
  }
  for (const std::uint16_t value : words) {
    switch (element++) {
      case 0:
        next_descriptor_ = (next_descriptor_ & 0xFFFF0000U) | value;
        break;
      case 1:
        next_descriptor_ = (next_descriptor_ & 0xFFFFU) | std::uint32_t{value} << 16U;
        break;
      case 2:
        start_address_ = (start_address_ & 0xFFFF0000U) | value;
        break;
      case 3:
        start_address_ = (start_address_ & 0xFFFFU) | std::uint32_t{value} << 16U;
        break;
      case 4:
        config_ = value;
        break;
      case 5:
        x_count_ = value;
        break;
      case 6:
        x_modify_ = value;
        break;
      case 7:
        y_count_ = value;
        break;
      default:
        y_modify_ = value;
        break;
    }
  }
  irq_status_ &= ~std::uint32_t{kDescriptorFetch};
  if ((config_ & kEnable) == 0) {
    stop();
    return;
  }
  check_config();
  load_unit();
}

void DmaChannel::load_unit() {
  const auto count = [](std::uint32_t value) { return value == 0 ? kMaximumCount : value; };
  shape_ = {.start = start_address_,
            .element_bytes = 1U << (config_ >> 2U & 3U),
            .x_count = count(x_count_),
            .x_modify = sign_extended(x_modify_)};
  if ((config_ & kTwoDimensional) != 0) {
    shape_.y_count = count(y_count_);
    shape_.y_modify = sign_extended(y_modify_);
  }
  check_shape();
  walk_ = AddressGenerator(shape_);
}

void DmaChannel::set_done() {
  irq_status_ |= kDone;
  interrupt_ = interrupt_ || (config_ & kInterruptEnable) != 0;
}

void DmaChannel::row_done() {
  if (interrupts_per_row()) {
    set_done();
  }
}

void DmaChannel::finish_unit() {
  set_done();
  switch (flow()) {
    case Flow::stop:
      finishing_ = true;
      break;
    case Flow::autobuffer:
      load_unit();
      break;
    default:
      want_descriptor();
      break;
  }
}

void DmaChannel::drained() {
  if (finishing_) {
    stop();
  }
}

void DmaChannel::stop() {
  if (running()) {
    resting_address_ = walk_.address();
    resting_x_ = walk_.finished() ? 0 : walk_.columns_left();
    resting_y_ = walk_.finished() ? 0 : walk_.rows_left();
  }
  irq_status_ &= ~std::uint32_t{kRun | kDescriptorFetch};
  finishing_ = false;
}

void DmaChannel::set_error() {
  stop();
  irq_status_ |= kError;
}

}  // namespace finback::dma
