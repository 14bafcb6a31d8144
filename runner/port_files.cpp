#include <charconv>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <iterator>
#include <sstream>

#include <common/error.hpp>
#include <common/file.hpp>
#include <isa_sim/machine/peripherals.hpp>
#include <runner/port_files.hpp>

namespace finback::runner {

using peripheral::PinChange;

namespace {

constexpr int kPins = 3 * peripheral::kFlagsOfAPort;
constexpr double kLatest = 1e12;  // us

// "PF12" is 12; -1 for what is no flag.
int pin_of(std::string_view name) {
  int pin = -1;
  if (!name.starts_with("PF")) {
    return -1;
  }
  name.remove_prefix(2);
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), pin);
  const bool whole = error == std::errc() && end == name.data() + name.size();
  return whole && pin >= 0 && pin < kPins ? pin : -1;
}

PinChange parse_change(const std::string& line, const SourcePlace& place, double cclk_mhz) {
  std::istringstream words(line);
  std::string time;
  std::string pin;
  std::string level;
  std::string more;
  words >> time >> pin >> level;
  if (level.empty() || words >> more || (level != "0" && level != "1")) {
    throw InputError(place, "wants TIME PIN LEVEL, such as 12.5 PF3 1");
  }
  double microseconds = -1;
  const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), microseconds);
  if (error != std::errc() || end != time.data() + time.size() || !(microseconds >= 0) ||
      microseconds > kLatest) {
    throw InputError(place, fmt::format("{} is no time in microseconds", time));
  }
  const int number = pin_of(pin);
  if (number < 0) {
    throw InputError(place, fmt::format("{} is no flag: they are PF0 to PF{}", pin, kPins - 1));
  }
  return {static_cast<Cycles>(std::llround(microseconds * cclk_mhz)), number, level == "1"};
}

}  // namespace

std::vector<PinChange> parse_pin_changes(std::string_view text, const std::string& file,
                                         double cclk_mhz) {
  std::vector<PinChange> changes;
  std::istringstream lines{std::string(text)};
  SourcePlace place{file};
  for (std::string line; std::getline(lines, line);) {
    ++place.line;
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos) {
      continue;
    }
    changes.push_back(parse_change(line, place, cclk_mhz));
    if (changes.size() > 1 && changes.back().at < changes[changes.size() - 2].at) {
      throw InputError(place, "is earlier than the line before; order the lines by their times");
    }
  }
  return changes;
}

std::string to_text(const std::vector<PinChange>& changes, double cclk_mhz) {
  std::string text;
  for (const PinChange& change : changes) {
    fmt::format_to(std::back_inserter(text), "{:.4f} PF{} {}\n",
                   static_cast<double>(change.at) / cclk_mhz, change.pin, change.level ? 1 : 0);
  }
  return text;
}

PortFiles::PortFiles(const PortRequest& request, double cclk_mhz)
    : request_(request), cclk_mhz_(cclk_mhz) {
  if (!request.uart_input.empty()) {
    const std::string text = read_text_file(request.uart_input);
    uart_input_.assign(text.begin(), text.end());
  }
  if (!request.flags_input.empty()) {
    flags_input_ =
        parse_pin_changes(read_text_file(request.flags_input), request.flags_input, cclk_mhz);
  }
}

void PortFiles::attach(machine::Machine& machine) {
  machine::Peripherals& peripherals = machine.peripherals();
  peripherals.uart().set_input(uart_input_);
  peripherals.drive_flags(flags_input_);
  if (request_.uart == "-") {
    peripherals.uart().set_output([](std::uint8_t character) {
      std::putchar(character);
      if (character == '\n') {
        std::fflush(stdout);
      }
    });
  } else if (!request_.uart.empty()) {
    peripherals.uart().set_output(
        [this](std::uint8_t character) { uart_output_ += static_cast<char>(character); });
  }
  if (!request_.flags.empty()) {
    peripherals.set_flag_listener([this, &machine](const PinChange& change) {
      flags_output_.push_back({machine.reference_time(change.at), change.pin, change.level});
    });
  }
}

void PortFiles::write() const {
  std::fflush(stdout);
  if (!request_.uart.empty() && request_.uart != "-") {
    write_file_whole(request_.uart, uart_output_);
  }
  if (!request_.flags.empty()) {
    write_file_whole(request_.flags, to_text(flags_output_, cclk_mhz_));
  }
}

machine::StopInfo run_with_ports(machine::Machine& machine, const machine::RunLimits& limits,
                                 const PortFiles& ports) {
  try {
    machine::StopInfo stop = machine.run(limits);
    ports.write();
    return stop;
  } catch (const GuestFault&) {
    ports.write();
    throw;
  }
}

}  // namespace finback::runner
