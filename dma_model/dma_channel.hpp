// The front end of a DMA channel: its registers, its descriptors, and which work unit comes next.
//
// Models: FLOW 0 (stop), 1 (autobuffer), 4 (descriptor array), 6 and 7 (small and large lists) with
// every NDSIZE, 1-D and 2-D, 8, 16 and 32-bit elements, DONE by row or by work unit, IRQ_STATUS
// with write-1-to-clear, PERIPHERAL_MAP. Does not model: that a descriptor is loaded word by word
// (all of it takes effect when its last word has come). Knows nothing of time or of memory. Source:
// hardware.md 3.1; DMA chapter of the ADSP-BF537 Hardware Reference.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include <common/device.hpp>
#include <common/units.hpp>
#include <dma_model/address_generator.hpp>

namespace finback::dma {

// Offsets within a channel's 0x40 bytes.
enum ChannelRegister : std::uint32_t {
  kNextDescriptorPointer = 0x00,
  kStartAddress = 0x04,
  kConfig = 0x08,
  kXCount = 0x10,
  kXModify = 0x14,
  kYCount = 0x18,
  kYModify = 0x1C,
  kCurrentDescriptorPointer = 0x20,
  kCurrentAddress = 0x24,
  kIrqStatus = 0x28,
  kPeripheralMap = 0x2C,
  kCurrentXCount = 0x30,
  kCurrentYCount = 0x38,
};
inline constexpr std::uint32_t kChannelBytes = 0x40;

// The register at `offset` in a channel's block; nullptr when there is none.
[[nodiscard]] const DeviceRegister* find_channel_register(std::uint32_t offset);

enum ConfigBit : std::uint32_t {
  kEnable = 1U << 0,
  kWriteMemory = 1U << 1,  // WNR
  kTwoDimensional = 1U << 4,
  kRestart = 1U << 5,
  kInterruptPerRow = 1U << 6,  // DI_SEL
  kInterruptEnable = 1U << 7,  // DI_EN
};

enum class Flow : std::uint8_t {
  stop = 0,
  autobuffer = 1,
  array = 4,
  small_list = 6,
  large_list = 7
};

enum IrqStatusBit : std::uint32_t {
  kDone = 1U << 0,
  kError = 1U << 1,
  kDescriptorFetch = 1U << 2,
  kRun = 1U << 3,
};

// What the chip answers with DMA_ERR: a register, its value, and how to mend it.
class DmaError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class ChannelKind : std::uint8_t { source, destination, peripheral };

class DmaChannel {
 public:
  enum class Written : std::uint8_t { nothing, enabled, disabled, map };

  // `name` as registers are called: "MDMA1_D0". `peripheral`: what PERIPHERAL_MAP says at reset.
  DmaChannel(std::string name, ChannelKind kind, std::uint32_t peripheral = 0);

  // Accesses that fit the register's width. Write throws DmaError for a register that may not be
  // written while the channel runs. After `enabled` the channel is to be started.
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes) const;
  Written write(std::uint32_t offset, int bytes, std::uint32_t value);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint32_t peripheral() const { return peripheral_map_ >> 12U; }
  [[nodiscard]] bool running() const { return (irq_status_ & kRun) != 0; }
  [[nodiscard]] bool writes_memory() const { return (config_ & kWriteMemory) != 0; }
  [[nodiscard]] bool restarts() const { return (config_ & kRestart) != 0; }
  [[nodiscard]] Flow flow() const { return static_cast<Flow>(config_ >> 12U & 7U); }
  [[nodiscard]] bool by_descriptors() const { return flow() >= Flow::array; }
  [[nodiscard]] bool interrupts_per_row() const {
    return (config_ & kTwoDimensional) != 0 && (config_ & kInterruptPerRow) != 0;
  }
  [[nodiscard]] bool interrupt_pending() const { return interrupt_; }
  [[nodiscard]] bool error_pending() const { return (irq_status_ & kError) != 0; }

  // --- what the transfer does; all but the last two throw DmaError ---
  // Begins as CONFIG says: with a work unit from the registers, or with a descriptor.
  void start();
  // The descriptor to fetch next.
  [[nodiscard]] bool wants_descriptor() const { return (irq_status_ & kDescriptorFetch) != 0; }
  [[nodiscard]] memory::DmaRun descriptor() const;
  // Its words have come: they go into the registers, and the work unit begins, unless DMAEN is 0 in
  // what they loaded.
  void load_descriptor(std::span<const std::uint16_t> words);
  // The walk is at its end and everything is in memory (or read from it): DONE, and what comes
  // next. A channel that stops still runs until drained().
  void finish_unit();
  [[nodiscard]] bool finishing() const { return finishing_; }
  // Its FIFO is empty after the last unit.
  void drained();
  void row_done();
  void stop();
  void set_error();

  [[nodiscard]] AddressGenerator& walk() { return walk_; }
  [[nodiscard]] const AddressGenerator& walk() const { return walk_; }
  [[nodiscard]] const TransferShape& shape() const { return shape_; }
  // A DmaError with the register's name, value and `why`.
  [[nodiscard]] DmaError error(std::uint32_t offset, std::uint32_t value,
                               const std::string& why) const;

 private:
  [[nodiscard]] std::uint32_t descriptor_words() const { return config_ >> 8U & 0xFU; }
  [[nodiscard]] std::uint32_t word(std::uint32_t offset) const;
  void store(std::uint32_t offset, std::uint32_t value);
  void check_config() const;
  void check_shape() const;
  void want_descriptor();
  void load_unit();
  void set_done();

  std::string name_;
  ChannelKind kind_;
  std::uint32_t next_descriptor_ = 0;
  std::uint32_t current_descriptor_ = 0;
  std::uint32_t start_address_ = 0;
  std::uint32_t config_ = 0;
  std::uint32_t x_count_ = 0, x_modify_ = 0, y_count_ = 0, y_modify_ = 0;
  std::uint32_t irq_status_ = 0;
  std::uint32_t peripheral_map_;
  // CURR_ADDR, CURR_X_COUNT and CURR_Y_COUNT of a channel that does not run.
  std::uint32_t resting_address_ = 0, resting_x_ = 0, resting_y_ = 0;
  bool interrupt_ = false;  // DONE with DI_EN
  bool finishing_ = false;
  TransferShape shape_;
  AddressGenerator walk_;
};

}  // namespace finback::dma
