// The registers of the external port (EBIU): what the SDRAM is, and how fast.
//
// Models: SDGCTL (CL, tRAS, tRP, tRCD, tWR, which change the time of accesses from the write on),
// SDRRC (the refresh period), SDBCTL (size, columns), SDSTAT (idle; self-refresh, which
// keeps all contents); AMGCTL and AMBCTL0/1 (which banks of asynchronous memory there are, how wide
// and how slow; CDPRIO). After reset the SDRAM's tell what the machine's parameters say. Does not
// model: the power-up sequence, what leaving self-refresh costs, the clock output. Source:
// hardware.md 2.4, 2.5; addresses and bits as in the EBIU registers of defBF561.h.
#pragma once

#include <cstdint>

#include <common/device.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::machine {

class ExternalPort final : public Device {
 public:
  static constexpr std::uint32_t kRegisterBytes = 0x20;

  explicit ExternalPort(memory::MemorySystem& memory) : memory_(memory) {}

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;

 private:
  [[nodiscard]] std::uint32_t global_control() const;
  [[nodiscard]] std::uint32_t bank_control() const;
  [[nodiscard]] std::uint32_t refresh_rate() const;
  void set_global_control(std::uint32_t value);
  void set_bank_control(std::uint32_t value) const;

  memory::MemorySystem& memory_;
  std::uint32_t other_control_ = 0x00800001;  // SDGCTL's bits without time: PSS, SCTLE
};

}  // namespace finback::machine
