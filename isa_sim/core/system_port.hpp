// What a core asks of the machine around it: device registers and the state of the peripheral bus.
#pragma once

#include <common/units.hpp>

namespace finback::core {

class SystemPort {
 public:
  struct Read {
    std::uint32_t value = 0;
    Cycles stall = 0;  // beyond the issue cycle
  };

  virtual ~SystemPort() = default;

  // System registers, 0xFFC00000 to 0xFFDFFFFF. Throw GuestFault for what is none.
  virtual Read device_read(int core, Address address, int bytes, Cycles now) = 0;
  // Returns the stall beyond the issue cycle.
  virtual Cycles device_write(int core, Address address, int bytes, std::uint32_t value,
                              Cycles now) = 0;
  // When the core's posted register writes have all arrived.
  [[nodiscard]] virtual Cycles device_writes_drained_at(int core) const = 0;
};

}  // namespace finback::core
