// The front end of a DMA channel: its registers.
//
// Models: register mode, FLOW 0 (stop) and 1 (autobuffer), 1-D and 2-D, 8, 16 and 32-bit elements,
// IRQ_STATUS with write-1-to-clear. Does not model: descriptors (FLOW 4, 6, 7 are refused with a
// clear fault), RESTART, error flags (what hardware flags is a GuestFault here). Source:
// hardware.md 3.1; DMA chapter of the ADSP-BF537 Hardware Reference.
#pragma once

#include <cstdint>
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

// The register at `offset` in a channel's block; nullptr when there is none.
[[nodiscard]] const DeviceRegister* find_channel_register(std::uint32_t offset);

enum ConfigBit : std::uint32_t {
  kEnable = 1U << 0,
  kWriteMemory = 1U << 1,  // WNR
  kTwoDimensional = 1U << 4,
  kInterruptPerRow = 1U << 6,  // DI_SEL
  kInterruptEnable = 1U << 7,  // DI_EN
};

enum IrqStatusBit : std::uint32_t {
  kDone = 1U << 0,
  kError = 1U << 1,
  kDescriptorFetch = 1U << 2,
  kRun = 1U << 3,
};

class DmaChannel {
 public:
  // `name` as registers are called: "MDMA1_D0".
  DmaChannel(std::string name, bool writes_memory);

  // Accesses that fit the register's width. Write returns true when CONFIG was written; throws
  // GuestFault where the register is read-only.
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes) const;
  bool write(std::uint32_t offset, int bytes, std::uint32_t value);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool enabled() const { return (config_ & kEnable) != 0; }
  [[nodiscard]] bool running() const { return (irq_status_ & kRun) != 0; }
  [[nodiscard]] bool autobuffer() const { return flow() == 1; }
  [[nodiscard]] bool interrupts_per_row() const {
    return (config_ & kTwoDimensional) != 0 && (config_ & kInterruptPerRow) != 0;
  }
  [[nodiscard]] bool interrupt_pending() const {
    return (irq_status_ & kDone) != 0 && (config_ & kInterruptEnable) != 0;
  }

  // Loads the walk from the registers and sets RUN. Throws GuestFault for what is not modelled or
  // makes no sense (direction, WDSIZE 3, misalignment).
  void start();
  // Goes back to the first element of the walk that start() loaded.
  void rewind() { walk_ = AddressGenerator(shape_); }
  void stop() { irq_status_ &= ~std::uint32_t{kRun}; }
  void set_done() { irq_status_ |= kDone; }

  [[nodiscard]] AddressGenerator& walk() { return walk_; }
  [[nodiscard]] const TransferShape& shape() const { return shape_; }

 private:
  [[nodiscard]] std::uint32_t flow() const { return config_ >> 12U & 7U; }
  [[nodiscard]] TransferShape shape_from_registers() const;
  [[nodiscard]] std::uint32_t word(std::uint32_t offset) const;
  [[noreturn]] void fault(std::uint32_t offset, std::uint32_t value, const std::string& why) const;

  std::string name_;
  bool writes_memory_;
  std::uint32_t next_descriptor_ = 0;
  std::uint32_t start_address_ = 0;
  std::uint32_t config_ = 0;
  std::uint32_t x_count_ = 0, x_modify_ = 0, y_count_ = 0, y_modify_ = 0;
  std::uint32_t irq_status_ = 0;
  TransferShape shape_;
  AddressGenerator walk_;
};

}  // namespace finback::dma
