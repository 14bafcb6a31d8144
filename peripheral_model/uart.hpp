// The UART: one character out and one in at a time, in the time that they take.
//
// Models: THR and the shift register behind it, RBR with overrun, the divisor latch, word length,
// parity and stop bits as time, loop back, IER, IIR and the three interrupt lines (received,
// transmitted, error), received characters one behind the other from when UCEN is set. A write to a
// full THR is a GuestFault: the character before it would be lost. Does not model: DMA, IrDA,
// breaks, framing and parity errors, modem lines. Source: defBF561.h for addresses and bits (V),
// UART chapter of the ADSP-BF533 Hardware Reference as remembered (M).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <clock_model/clock_ratio.hpp>
#include <common/device.hpp>
#include <peripheral_model/peripheral_parameters.hpp>

namespace finback::peripheral {

class Uart final : public Device {
 public:
  static constexpr std::uint32_t kRegisterBytes = 0x28;

  enum class Line : std::uint8_t { received, transmitted, error };
  using InterruptLine = std::function<void(Line line, bool level, Cycles at)>;

  // `ratio`: CCLK cycles of an SCLK.
  Uart(const PeripheralParameters& parameters, clock::ClockRatio ratio, InterruptLine line);

  // Gets each character when its stop bits are over.
  void set_output(std::function<void(std::uint8_t character)> output) {
    output_ = std::move(output);
  }
  // What comes in.
  void set_input(std::vector<std::uint8_t> input) { input_ = std::move(input); }

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;
  void advance(Cycles now) override;
  // Characters that are under way become longer or shorter, too, also those that come in.
  void change_clock(const clock::ClockChange& change);

 private:
  void write_character(std::uint32_t value, Cycles now);
  void write_control(std::uint32_t value, Cycles now);
  void send(std::uint8_t character, Cycles now);
  void sent(Cycles now);
  void receive(std::uint8_t character);
  [[nodiscard]] std::uint32_t interrupt_identification() const;
  [[nodiscard]] std::uint32_t line_status() const;
  [[nodiscard]] std::uint32_t data_bits() const { return 5 + (line_control_ & 3U); }
  [[nodiscard]] Cycles character_cycles() const;
  [[nodiscard]] bool latch_access() const;
  [[nodiscard]] bool loops() const;
  void update(Cycles now);
  void set_line(Line line, bool level, Cycles now);

  clock::ClockRatio ratio_;
  Cycles input_gap_;  // in SCLK
  InterruptLine line_;
  std::function<void(std::uint8_t)> output_;
  std::vector<std::uint8_t> input_;
  std::size_t input_next_ = 0;

  std::uint32_t interrupt_enable_ = 0;
  std::uint32_t line_control_ = 0;
  std::uint32_t modem_control_ = 0;
  std::uint32_t scratch_ = 0;
  std::uint32_t divisor_ = 1;
  std::uint32_t global_control_ = 0;

  std::uint8_t holding_ = 0;  // THR
  bool holding_full_ = false;
  bool transmit_asks_ = true;  // THR became empty and nobody has been told
  std::uint8_t shifting_ = 0;
  Cycles sent_at_ = kNever;
  std::uint8_t received_ = 0;  // RBR
  bool ready_ = false;
  bool overrun_ = false;
  Cycles receives_at_ = kNever;
  std::uint32_t levels_ = 0;  // of the lines, by Line
};

}  // namespace finback::peripheral
