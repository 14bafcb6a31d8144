// A parallel peripheral interface: PPI0 or PPI1, which takes a camera's bytes to its DMA channel.
//
// Models: input with external frame syncs (XFR_TYPE 3: PORT_CFG 0 takes every line, 2 waits for
// VSYNC) and of ITU-656 (XFR_TYPE 0 the pixels, 1 all), COUNT, DELAY, FRAME, packing, skipping,
// sample widths, frame track errors, overrun, the error interrupt. Elements of a line count from 0:
// SKIP_EO = 0 drops the odd ones, the chroma. Lines beyond FRAME are not read; capture begins with
// a whole frame. While SCLK is too slow for the camera's clock, what
// comes is lost, as in an overrun. An event is a burst of bytes, at the time of its last one. Does
// not model: output, syncs that the port makes, vertical blanking alone, FS3, polarities. Source:
// hardware.md 3.3; PPI chapter of the ADSP-BF533 Hardware Reference as remembered (M).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <clock_model/real_time.hpp>
#include <common/counters.hpp>
#include <common/device.hpp>
#include <peripheral_model/camera.hpp>
#include <peripheral_model/peripheral_parameters.hpp>

namespace finback::peripheral {

class ParallelPort final : public Device {
 public:
  static constexpr std::uint32_t kRegisterBytes = 0x14;

  struct Outputs {
    // Hands bytes to the DMA channel; false: its FIFO is full and they are lost.
    std::function<bool(std::span<const std::uint8_t> bytes, Cycles now)> push;
    // The channel's element in bytes, 0 while it is off.
    std::function<std::uint32_t()> element_bytes;
    std::function<void(bool level, Cycles at)> error_line;
    // The last byte of a whole frame was taken.
    std::function<void(std::uint32_t frame, Cycles at)> captured;
  };

  // `name` as its registers are called: "PPI0". `camera` must outlive the port.
  ParallelPort(std::string name, Camera& camera, const PeripheralParameters& parameters,
               double sclk_mhz, Outputs outputs);

  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;
  void advance(Cycles now) override;
  // The camera's clock is its own: it goes on in real time.
  void change_clock(const clock::ClockChange& change);

  // NAME.frames.events, .captured.bytes, .lost.bytes, .frame_errors.events, in lower case.
  void register_counters(CounterRegistry& registry) const;

 private:
  enum class Next : std::uint8_t { nothing, frame, burst, extra_line };

  void start(Cycles now);
  void stop();
  void plan(Next next, Cycles reference);
  void check_settings(std::uint32_t value) const;
  void plan_frame(Cycles from);
  void plan_burst();
  void begin_frame(Cycles now);
  void take_burst(Cycles now);
  void end_frame(Cycles now);
  void gather(std::span<const std::uint8_t> samples);
  void hand_over(Cycles now);
  void raise(std::uint32_t status, Cycles now);
  void update_error_line(Cycles now);
  [[nodiscard]] std::uint32_t word_bytes() const;
  [[noreturn]] void fault(const char* register_name, std::uint32_t value,
                          const std::string& why) const;

  std::string name_;
  Camera& camera_;
  Outputs outputs_;
  double clock_share_;
  double clock_limit_mhz_;
  std::uint32_t burst_bytes_;

  std::uint32_t control_ = 0;
  std::uint32_t status_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t delay_ = 0;
  std::uint32_t frame_length_ = 0;
  bool error_line_ = false;

  // What is read of a frame, as the settings had it when the port was enabled.
  std::uint32_t first_line_ = 0;
  std::uint32_t lines_ = 0;
  std::uint32_t first_clock_ = 0;
  std::uint32_t clocks_ = 0;
  bool extra_line_ = false;   // the camera sends more lines than FRAME
  bool short_frame_ = false;  // ... or fewer

  clock::RealTime time_;
  Next next_ = Next::nothing;
  Cycles next_reference_ = kNever;  // when, in reference cycles, as the camera counts
  Camera::Frame camera_frame_;
  std::uint32_t line_ = 0;
  std::uint32_t clock_ = 0;   // the next to be taken, of clocks_
  std::uint32_t taking_ = 0;  // clocks of the burst under way
  bool frame_before_ = false;
  std::vector<std::uint8_t> samples_;
  std::vector<std::uint8_t> words_;  // gathered; whole words are handed over

  std::uint64_t frames_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t lost_bytes_ = 0;
  std::uint64_t frame_errors_ = 0;
};

}  // namespace finback::peripheral
