// What a core asks of the machine around it: device registers, the state of the peripheral bus, and
// what programs ask of their host.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <common/units.hpp>
#include <isa_sim/isa/operation.hpp>

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

  // The core enters the handler of an interrupt. Only told while memory is watched.
  virtual void interrupt_taken(int /*core*/) {}

  // The core's program prints.
  virtual void print(int core, std::string_view text) = 0;
  // The core's program ends with `status`. `why`: one line when something went wrong, else "".
  virtual void halt(int core, std::uint32_t status, const std::string& why, Cycles now) = 0;
  // EXCPT 0 with no handler: number and arguments are in the core's registers, the results go
  // there.
  enum class HostCall : std::uint8_t { none, done, ended };  // no host serves it; the program ended
  virtual HostCall host_call(int core, isa::ExecutionState& state, Cycles now) = 0;
};

}  // namespace finback::core
