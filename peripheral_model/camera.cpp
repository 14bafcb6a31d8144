#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include <common/error.hpp>
#include <peripheral_model/camera.hpp>

namespace finback::peripheral {

namespace {

constexpr int kVgaWidth = 640;
constexpr int kVgaHeight = 480;
constexpr std::uint8_t kGreyChroma = 128;
constexpr std::uint8_t kBlankLuma = 16;
constexpr std::uint32_t kCodeClocks = 4;  // of EAV and of SAV

// What a chance decides; they must not depend on each other.
enum Chance : std::uint32_t { kJitter, kLate, kDropped };

Cycles cycles_of(double microseconds, double cclk_mhz) {
  return static_cast<Cycles>(std::llround(microseconds * cclk_mhz));
}

std::uint64_t share_of_chances(double share) {
  return static_cast<std::uint64_t>(std::llround(share * 4294967296.0));
}

}  // namespace

Camera::Camera(Side side, const CameraParameters& parameters, double cclk_mhz)
    : side_(side),
      cclk_mhz_(cclk_mhz),
      width_(kVgaWidth >> static_cast<std::int64_t>(parameters.halvings)),
      height_(kVgaHeight >> static_cast<std::int64_t>(parameters.halvings)),
      itu656_(static_cast<std::int64_t>(parameters.itu656) != 0),
      line_clocks_(2 * static_cast<std::uint32_t>(parameters.line_pixels)),
      frame_clocks_(line_clocks_ * static_cast<std::uint32_t>(parameters.frame_lines) >>
                    static_cast<std::int64_t>(parameters.halvings)),
      picture_line_(static_cast<std::uint32_t>(parameters.top_lines) >>
                    static_cast<std::int64_t>(parameters.halvings)),
      frame_cycles_(cycles_of(1e6 / parameters.frame_rate, cclk_mhz)),
      offset_(cycles_of(side == Side::left ? parameters.left_offset : parameters.right_offset,
                        cclk_mhz)),
      jitter_(cycles_of(parameters.jitter, cclk_mhz)),
      late_(cycles_of(parameters.late, cclk_mhz)),
      late_below_(share_of_chances(parameters.late_share)),
      dropped_below_(share_of_chances(parameters.dropped_share)),
      seed_(static_cast<std::uint32_t>(static_cast<std::int64_t>(parameters.seed))) {
  if (std::uint32_t needed = picture_line_ + static_cast<std::uint32_t>(height_);
      needed >= frame_lines()) {
    throw InputError(fmt::format(
        "camera.top_lines and the {} lines of the picture do not fit into a frame of {} lines; "
        "raise camera.frame_lines",
        height_, frame_lines()));
  }
}

void Camera::connect(Pictures pictures, const std::vector<FrameTrouble>& troubles) {
  pictures_ = std::move(pictures);
  for (const FrameTrouble& trouble : troubles) {
    troubles_.insert_or_assign(trouble.frame, trouble);
  }
}

double Camera::pixel_clock_mhz() const {
  return frame_clocks_ * cclk_mhz_ / static_cast<double>(frame_cycles_);
}

std::uint32_t Camera::picture_clock() const {
  return itu656_ ? line_clocks_ - picture_clocks() : 0;
}

// 32 bits from a well mixed hash (the finaliser of MurmurHash3).
std::uint32_t Camera::chance(std::uint32_t number, std::uint32_t what) const {
  std::uint64_t value =
      (std::uint64_t{seed_} << 32U) ^
      (std::uint64_t{number} * 8 + std::uint64_t{what} * 2 + (side_ == Side::right ? 1 : 0));
  value ^= value >> 33U;
  value *= 0xFF51AFD7ED558CCDU;
  value ^= value >> 33U;
  value *= 0xC4CEB9FE1A85EC53U;
  return static_cast<std::uint32_t>(value >> 32U);
}

bool Camera::drops(std::uint32_t number) const {
  const auto trouble = troubles_.find(number);
  return (trouble != troubles_.end() && trouble->second.dropped) ||
         chance(number, kDropped) < dropped_below_;
}

Cycles Camera::delay_of(std::uint32_t number) const {
  const auto trouble = troubles_.find(number);
  const Cycles injected =
      trouble == troubles_.end() ? 0 : cycles_of(trouble->second.late_us, cclk_mhz_);
  const Cycles late = chance(number, kLate) < late_below_ ? late_ : 0;
  return injected + late + (chance(number, kJitter) * (jitter_ + 1) >> 32U);
}

Camera::Frame Camera::next_frame(Cycles from) {
  while (next_.start == kNever || next_.start < from) {
    const std::uint32_t number = next_number_++;
    if (drops(number)) {
      continue;
    }
    const Cycles planned = offset_ + number * frame_cycles_ + delay_of(number);
    next_ = {number, std::max(planned, free_at_)};
    free_at_ = time_of(next_, picture_line_ + static_cast<std::uint32_t>(height_), 0);
  }
  return next_;
}

Cycles Camera::time_of(const Frame& frame, std::uint32_t line, std::uint32_t clock) const {
  const std::uint64_t clocks = std::uint64_t{line} * line_clocks_ + clock + 1;
  return frame.start + (clocks * frame_cycles_ + frame_clocks_ - 1) / frame_clocks_;
}

void Camera::load(std::uint32_t number) {
  if (picture_ != nullptr && picture_number_ == number) {
    return;
  }
  picture_ = pictures_(number);
  picture_number_ = number;
  if (picture_->width != width_ || picture_->height != height_) {
    throw InputError(fmt::format("the {} camera got a picture of {}x{} and sends {}x{}", name(),
                                 picture_->width, picture_->height, width_, height_));
  }
}

void Camera::fill(const Frame& frame, std::uint32_t line, std::uint32_t clock,
                  std::span<std::uint8_t> bytes) {
  load(frame.number);
  const bool shows = line - picture_line_ < static_cast<std::uint32_t>(height_);
  const std::uint8_t* luma =
      shows ? &picture_->luma[std::size_t{line - picture_line_} * static_cast<std::size_t>(width_)]
            : nullptr;
  for (std::uint8_t& byte : bytes) {
    const std::uint32_t pixel_clock = clock - picture_clock();
    if (pixel_clock < picture_clocks() && shows) {
      byte = pixel_clock % 2 == 0 ? luma[pixel_clock / 2] : kGreyChroma;
    } else {
      byte = code_byte(line, clock);
    }
    ++clock;
  }
}

// What is sent beside pixels: codes in ITU-656, and black.
std::uint8_t Camera::code_byte(std::uint32_t line, std::uint32_t clock) const {
  const std::uint32_t from_sav = clock - (picture_clock() - kCodeClocks);
  const bool eav = clock < kCodeClocks;
  if (itu656_ && (eav || from_sav < kCodeClocks)) {
    // 1 F V H, then the parity of V H, F H, F V and F V H; F is 0.
    const bool blank = line - picture_line_ >= static_cast<std::uint32_t>(height_);
    const unsigned v = blank ? 1 : 0;
    const unsigned h = eav ? 1 : 0;
    const std::array<unsigned, kCodeClocks> code = {
        0xFF, 0, 0, 0x80U | v << 5U | h << 4U | (v ^ h) << 3U | h << 2U | v << 1U | (v ^ h)};
    return static_cast<std::uint8_t>(code[eav ? clock : from_sav]);
  }
  return clock % 2 == 0 ? kBlankLuma : kGreyChroma;
}

}  // namespace finback::peripheral
