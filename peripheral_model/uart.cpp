#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <common/error.hpp>
#include <peripheral_model/uart.hpp>

namespace finback::peripheral {

namespace {

constexpr std::uint32_t kData = 0x00, kInterruptEnable = 0x04, kIdentification = 0x08,
                        kLineControl = 0x0C, kModemControl = 0x10, kLineStatus = 0x14,
                        kModemStatus = 0x18, kScratch = 0x1C, kGlobalControl = 0x24;

enum Bit : std::uint32_t {
  kReceiveEnable = 1U << 0,  // IER
  kTransmitEnable = 1U << 1,
  kErrorEnable = 1U << 2,
  kTwoStopBits = 1U << 2,  // LCR
  kParity = 1U << 3,
  kLatch = 1U << 7,
  kLoop = 1U << 4,    // MCR
  kClocks = 1U << 0,  // GCTL: UCEN
  kInfrared = 1U << 1,
  kReady = 1U << 0,  // LSR
  kOverrun = 1U << 1,
  kHoldingEmpty = 1U << 5,
  kAllSent = 1U << 6,
};
constexpr std::uint32_t kClocksOfABit = 16;

}  // namespace

Uart::Uart(const PeripheralParameters& parameters, clock::ClockRatio ratio, InterruptLine line)
    : ratio_(ratio),
      input_gap_(static_cast<Cycles>(parameters.uart_input_gap)),
      line_(std::move(line)) {}

const DeviceRegister* Uart::find_register(std::uint32_t offset) const {
  using enum RegisterWidth;
  static constexpr std::array<DeviceRegister, 9> kRegisters = {{{kData, "THR", half},
                                                                {kInterruptEnable, "IER", half},
                                                                {kIdentification, "IIR", half},
                                                                {kLineControl, "LCR", half},
                                                                {kModemControl, "MCR", half},
                                                                {kLineStatus, "LSR", half},
                                                                {kModemStatus, "MSR", half},
                                                                {kScratch, "SCR", half},
                                                                {kGlobalControl, "GCTL", half}}};
  return finback::find_register(kRegisters, offset);
}

bool Uart::latch_access() const { return (line_control_ & kLatch) != 0; }
bool Uart::loops() const { return (modem_control_ & kLoop) != 0; }

// Start bit, data, parity and stop bits; a second stop bit is half a one behind five data bits.
Cycles Uart::character_cycles() const {
  std::uint32_t half_bits = 2 * (1 + data_bits() + 1);
  half_bits += (line_control_ & kParity) != 0 ? 2 : 0;
  if ((line_control_ & kTwoStopBits) != 0) {
    half_bits += data_bits() == 5 ? 1 : 2;
  }
  const std::uint32_t divisor = divisor_ == 0 ? 65536 : divisor_;
  return ratio_.cycles(Cycles{half_bits} * (kClocksOfABit / 2) * divisor);
}

std::uint32_t Uart::line_status() const {
  return (ready_ ? kReady : 0U) | (overrun_ ? kOverrun : 0U) |
         (holding_full_ ? 0U : kHoldingEmpty) |
         (holding_full_ || sent_at_ != kNever ? 0U : kAllSent);
}

// Bit 0: nothing asks; bits 2..1: who does, the most urgent first.
std::uint32_t Uart::interrupt_identification() const {
  if (overrun_ && (interrupt_enable_ & kErrorEnable) != 0) {
    return 6;
  }
  if (ready_ && (interrupt_enable_ & kReceiveEnable) != 0) {
    return 4;
  }
  return transmit_asks_ && (interrupt_enable_ & kTransmitEnable) != 0 ? 2 : 1;
}

std::uint32_t Uart::read(std::uint32_t offset, int /*bytes*/, Cycles now) {
  std::uint32_t value = 0;
  switch (offset) {
    case kData:
      if (latch_access()) {
        return divisor_ & 0xFFU;
      }
      ready_ = false;
      value = received_;
      break;
    case kInterruptEnable:
      return latch_access() ? divisor_ >> 8U : interrupt_enable_;
    case kIdentification:
      value = interrupt_identification();
      transmit_asks_ = transmit_asks_ && value != 2;  // told
      break;
    case kLineControl:
      return line_control_;
    case kModemControl:
      return modem_control_;
    case kLineStatus:
      value = line_status();
      overrun_ = false;
      break;
    case kScratch:
      return scratch_;
    case kGlobalControl:
      return global_control_;
    default:  // MSR: no modem is there
      return 0;
  }
  update(now);
  return value;
}

void Uart::write(std::uint32_t offset, int /*bytes*/, std::uint32_t value, Cycles now) {
  value &= 0xFFU;
  switch (offset) {
    case kData:
      if (latch_access()) {
        divisor_ = (divisor_ & 0xFF00U) | value;
      } else {
        write_character(value, now);
      }
      break;
    case kInterruptEnable:
      if (latch_access()) {
        divisor_ = (divisor_ & 0xFFU) | value << 8U;
      } else {
        interrupt_enable_ = value;
      }
      break;
    case kLineControl:
      line_control_ = value;
      break;
    case kModemControl:
      modem_control_ = value;
      break;
    case kScratch:
      scratch_ = value;
      break;
    case kGlobalControl:
      write_control(value, now);
      break;
    default:
      throw GuestFault(
          fmt::format("UART_{} = {:#x}: it is read-only", find_register(offset)->name, value));
  }
  update(now);
}

void Uart::write_character(std::uint32_t value, Cycles now) {
  if ((global_control_ & kClocks) == 0) {
    throw GuestFault(fmt::format(
        "UART_THR = {:#x}: the UART has no clock; set UCEN, UART_GCTL = 1, first", value));
  }
  if (holding_full_) {
    throw GuestFault(
        fmt::format("UART_THR = {:#x}: the character before has not left THR and would "
                    "be lost; wait for THRE, bit 5 of UART_LSR",
                    value));
  }
  const auto character = static_cast<std::uint8_t>(value);
  transmit_asks_ = false;
  if (sent_at_ == kNever) {
    send(character, now);
  } else {
    holding_ = character;
    holding_full_ = true;
  }
}

void Uart::write_control(std::uint32_t value, Cycles now) {
  if ((value & kInfrared) != 0) {
    throw GuestFault(fmt::format("UART_GCTL = {:#x}: IREN, infrared, is not modelled", value));
  }
  const bool begins = (value & ~global_control_ & kClocks) != 0;
  global_control_ = value;
  if ((value & kClocks) == 0) {
    sent_at_ = receives_at_ = kNever;
    holding_full_ = false;
    transmit_asks_ = true;
  } else if (begins && input_next_ < input_.size()) {
    receives_at_ = now + character_cycles() + ratio_.cycles(input_gap_);
  }
}

// From THR, which is empty then, to the shift register.
void Uart::send(std::uint8_t character, Cycles now) {
  shifting_ = character & static_cast<std::uint8_t>((1U << data_bits()) - 1);
  sent_at_ = now + character_cycles();
  transmit_asks_ = true;
}

void Uart::sent(Cycles now) {
  sent_at_ = kNever;
  if (loops()) {
    receive(shifting_);
  } else if (output_) {
    output_(shifting_);
  }
  if (holding_full_) {
    holding_full_ = false;
    send(holding_, now);
  }
}

void Uart::receive(std::uint8_t character) {
  overrun_ = overrun_ || ready_;
  received_ = character;
  ready_ = true;
}

void Uart::advance(Cycles now) {
  while (next_event_ <= now) {
    const Cycles at = next_event_;
    if (sent_at_ == at) {
      sent(at);
    } else {
      if (!loops()) {
        receive(input_[input_next_++]);
      }
      receives_at_ = input_next_ < input_.size()
                         ? at + character_cycles() + ratio_.cycles(input_gap_)
                         : kNever;
    }
    update(at);
  }
}

void Uart::change_clock(const clock::ClockChange& change) {
  ratio_ = change.to;
  sent_at_ = change.system_time(sent_at_);
  receives_at_ = change.system_time(receives_at_);
  next_event_ = std::min(sent_at_, receives_at_);
}

void Uart::update(Cycles now) {
  next_event_ = std::min(sent_at_, receives_at_);
  const auto enabled = [this](std::uint32_t bit) { return (interrupt_enable_ & bit) != 0; };
  set_line(Line::received, ready_ && enabled(kReceiveEnable), now);
  set_line(Line::transmitted, transmit_asks_ && enabled(kTransmitEnable), now);
  set_line(Line::error, overrun_ && enabled(kErrorEnable), now);
}

void Uart::set_line(Line line, bool level, Cycles now) {
  const std::uint32_t bit = 1U << static_cast<unsigned>(line);
  if (((levels_ & bit) != 0) != level) {
    levels_ ^= bit;
    line_(line, level, now);
  }
}

}  // namespace finback::peripheral
