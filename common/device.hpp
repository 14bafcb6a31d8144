// What the peripheral bus knows of a device: its registers, and when it acts by itself.
//
// A device tells which registers it has, with their names and sizes, in one table; the bus checks
// every access against it before the device sees it. Offsets count from the device's base, which
// only the bus knows. Does not say what a register means: that is the device's.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <common/units.hpp>

namespace finback {

// How a register may be accessed.
enum class RegisterWidth : std::uint8_t {
  word,            // 4 bytes
  half,            // a 16-bit register: 2 bytes, or 4 of which the upper half is 0
  word_or_halves,  // 4 bytes, or either half of them
};

struct DeviceRegister {
  std::uint32_t offset = 0;  // a multiple of 4
  std::string_view name;     // as in the hardware reference, without the device's
  RegisterWidth width = RegisterWidth::word;
};

// The one at `offset` in a table; nullptr when there is none.
[[nodiscard]] inline const DeviceRegister* find_register(std::span<const DeviceRegister> table,
                                                         std::uint32_t offset) {
  const auto found = std::ranges::find(table, offset, &DeviceRegister::offset);
  return found == table.end() ? nullptr : &*found;
}

class Device {
 public:
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device() = default;

  // The register at `offset`, a multiple of 4; nullptr when there is none.
  [[nodiscard]] virtual const DeviceRegister* find_register(std::uint32_t offset) const = 0;
  // Its name within the device; differs from the table's where the device repeats a block of them.
  [[nodiscard]] virtual std::string register_name(std::uint32_t offset) const {
    const DeviceRegister* found = find_register(offset);
    return found == nullptr ? "" : std::string(found->name);
  }

  // Accesses that fit the register's width; the device has been advanced to `now`. Throw GuestFault
  // for what the register refuses: read-only, write-only, an illegal value.
  [[nodiscard]] virtual std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) = 0;
  virtual void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) = 0;

  // An actor: at next_event_time() it acts by itself, when advanced to that time or beyond.
  [[nodiscard]] Cycles next_event_time() const { return next_event_; }
  virtual void advance(Cycles /*now*/) {}

 protected:
  Cycles next_event_ = kNever;
};

}  // namespace finback
