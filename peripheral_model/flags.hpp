// A port of 16 programmable flags: FIO0 (PF0 to 15), FIO1 (16 to 31) or FIO2 (32 to 47).
//
// Models: direction, data with clear, set and toggle, polarity, edges (one or both), input enable,
// two interrupt masks, each with its line; inputs that change at given times; a listener to the
// outputs. An input that nothing drives is low. A flag's bit: an output's latch; an enabled input's
// level, turned by POLAR; of one that is sensitive to edges whether one came since it was cleared.
// Does not model: synchronisation of inputs, open drain, pins shared with other ports. Source:
// defBF561.h for addresses (V), flags chapter of the ADSP-BF533 Hardware Reference as remembered
// (M).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <clock_model/real_time.hpp>
#include <common/device.hpp>

namespace finback::peripheral {

inline constexpr int kFlagsOfAPort = 16;

// A pin at a time: what drives an input, or what an output did.
struct PinChange {
  Cycles at = 0;
  int pin = 0;  // 0 to 47: PF0 to PF47
  bool level = false;
};

class Flags final : public Device {
 public:
  static constexpr std::uint32_t kRegisterBytes = 0x44;

  struct Outputs {
    std::function<void(int mask, bool level, Cycles at)> line;  // mask 0: A, 1: B
    std::function<void(const PinChange& change)> changed;       // an output; may be empty
  };

  // `port` 0 to 2.
  Flags(int port, Outputs outputs);

  // Inputs of this port, in the order of time, which is in reference cycles; before the run.
  void drive(std::vector<PinChange> changes);

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;
  void advance(Cycles now) override;
  void change_clock(const clock::ClockChange& change) {
    time_.change(change);
    plan_next_event();
  }

 private:
  // Data and masks: each with clear, set and toggle beside it.
  enum Group : std::uint32_t { kData, kMaskA, kMaskB };
  enum Setting : std::uint32_t { kDirection, kPolarity, kEdge, kBoth, kInputEnable };

  void write_group(std::uint32_t group, std::uint32_t action, std::uint32_t value);
  [[nodiscard]] std::uint32_t data() const;
  void note_edges(std::uint32_t before, std::uint32_t after);
  void update(Cycles now);
  void plan_next_event();

  int port_;
  Outputs outputs_;
  std::array<std::uint32_t, 5> settings_{};
  std::array<std::uint32_t, 3> groups_{};  // kData: latches of outputs, edges seen of inputs
  std::uint32_t inputs_ = 0;               // levels that are driven from outside
  std::uint32_t driven_ = 0;               // levels of outputs, 0 for inputs
  std::array<bool, 2> lines_{};
  clock::RealTime time_;
  std::vector<PinChange> changes_;
  std::size_t next_change_ = 0;
};

}  // namespace finback::peripheral
