// What is at the machine's pins: files, and the terminal, for its UART and its flags.
//
// A file of flags has one change a line: `TIME PIN LEVEL`, the time in microseconds, in order:
// `12.5 PF3 1`. What drives inputs and what is logged of outputs have the same form. `#` begins a
// comment. Models nothing: the devices are peripheral_model's.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <isa_sim/machine/machine.hpp>
#include <peripheral_model/flags.hpp>

namespace finback::runner {

struct PortRequest {
  std::string uart;        // a file, "-": standard output, "": nothing
  std::string uart_input;  // files
  std::string flags;
  std::string flags_input;
};

// Throws InputError "file:line: what".
[[nodiscard]] std::vector<peripheral::PinChange> parse_pin_changes(std::string_view text,
                                                                   const std::string& file,
                                                                   double cclk_mhz);
[[nodiscard]] std::string to_text(const std::vector<peripheral::PinChange>& changes,
                                  double cclk_mhz);

class PortFiles {
 public:
  // Loads what comes in. Throws InputError.
  PortFiles(const PortRequest& request, double cclk_mhz);
  PortFiles(const PortFiles&) = delete;
  PortFiles& operator=(const PortFiles&) = delete;

  // Before the run; this object must outlive it.
  void attach(machine::Machine& machine);
  // Writes what came out, whole files, when the run is over, in whatever way. Throws InputError.
  void write() const;

 private:
  PortRequest request_;
  double cclk_mhz_;
  std::vector<std::uint8_t> uart_input_;
  std::vector<peripheral::PinChange> flags_input_;
  std::string uart_output_;
  std::vector<peripheral::PinChange> flags_output_;  // in cycles of the clock at the start
};

// Runs the machine; what came out of its ports is written also when the program faults.
machine::StopInfo run_with_ports(machine::Machine& machine, const machine::RunLimits& limits,
                                 const PortFiles& ports);

}  // namespace finback::runner
