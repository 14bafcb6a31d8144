// A camera of the OV7660's kind: which byte is on its data pins, and when.
//
// Models: a free-running sensor that sends YUV 4:2:2 as Y U Y V on eight pins, one byte a pixel
// clock, with HREF over the pixels of a line and VSYNC before a frame, or with ITU-656 codes; VGA,
// QVGA, QQVGA; offset, jitter, frames that are dropped or late. The chroma is grey (128). It costs
// nothing until a port asks. Does not model: its registers and SCCB (the machine file sets them),
// exposure, noise, colour, interlace. Source: OV7660 data sheet as remembered (M), hardware.md 3.3.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <common/units.hpp>
#include <peripheral_model/camera_parameters.hpp>

namespace finback::peripheral {

// What the sensor sees: luma, row by row.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> luma;
};

// What goes wrong with single frames, by number from 0.
struct FrameTrouble {
  std::uint32_t frame = 0;
  bool dropped = false;  // it is not sent at all
  double late_us = 0;    // it begins so much late; those behind it wait for its end
};

class Camera {
 public:
  // The picture of frame `number` (from 0), of the camera's size; asked once for a frame that
  // somebody reads.
  using Pictures = std::function<std::shared_ptr<const Picture>(std::uint32_t number)>;

  enum class Side : std::uint8_t { left, right };
  // Throws InputError for parameters that make no sense together.
  Camera(Side side, const CameraParameters& parameters, double cclk_mhz);

  void connect(Pictures pictures, const std::vector<FrameTrouble>& troubles);
  [[nodiscard]] bool connected() const { return static_cast<bool>(pictures_); }

  [[nodiscard]] const char* name() const { return side_ == Side::left ? "left" : "right"; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool sends_itu656() const { return itu656_; }
  [[nodiscard]] double pixel_clock_mhz() const;

  // Lines and clocks count from VSYNC: of a frame, and where in it the picture begins. A line of
  // ITU-656 begins with its code EAV, another one with HREF.
  [[nodiscard]] std::uint32_t line_clocks() const { return line_clocks_; }
  [[nodiscard]] std::uint32_t frame_lines() const { return frame_clocks_ / line_clocks_; }
  [[nodiscard]] std::uint32_t picture_line() const { return picture_line_; }
  [[nodiscard]] std::uint32_t picture_clock() const;
  // Clocks of a line that carry its pixels.
  [[nodiscard]] std::uint32_t picture_clocks() const {
    return 2 * static_cast<std::uint32_t>(width_);
  }

  struct Frame {
    std::uint32_t number = 0;
    Cycles start = kNever;  // VSYNC rises
  };
  // The first frame whose VSYNC rises at or after `from`, which does not go back.
  Frame next_frame(Cycles from);
  // When the byte of a clock can be taken: its clock is over.
  [[nodiscard]] Cycles time_of(const Frame& frame, std::uint32_t line, std::uint32_t clock) const;
  // The bytes of one line from `clock` on. Throws InputError when the picture has another size.
  void fill(const Frame& frame, std::uint32_t line, std::uint32_t clock,
            std::span<std::uint8_t> bytes);

 private:
  void load(std::uint32_t number);
  [[nodiscard]] Cycles delay_of(std::uint32_t number) const;
  [[nodiscard]] bool drops(std::uint32_t number) const;
  [[nodiscard]] std::uint32_t chance(std::uint32_t number, std::uint32_t what) const;
  [[nodiscard]] std::uint8_t code_byte(std::uint32_t line, std::uint32_t clock) const;

  Side side_;
  double cclk_mhz_;
  int width_;
  int height_;
  bool itu656_;
  std::uint32_t line_clocks_;
  std::uint32_t frame_clocks_;
  std::uint32_t picture_line_;
  Cycles frame_cycles_;
  Cycles offset_;
  Cycles jitter_;
  Cycles late_;
  std::uint64_t late_below_;  // of 2^32 chances
  std::uint64_t dropped_below_;
  std::uint32_t seed_;
  Pictures pictures_;
  std::map<std::uint32_t, FrameTrouble> troubles_;

  std::uint32_t next_number_ = 0;
  Cycles free_at_ = 0;  // the pixels of the frame before have been sent
  Frame next_;          // the frame found last
  std::shared_ptr<const Picture> picture_;
  std::uint32_t picture_number_ = 0;
};

}  // namespace finback::peripheral
