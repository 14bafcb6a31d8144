#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <common/error.hpp>
#include <peripheral_model/parallel_port.hpp>

namespace finback::peripheral {

namespace {

constexpr std::uint32_t kControl = 0x00, kStatus = 0x04, kCount = 0x08, kDelay = 0x0C,
                        kFrame = 0x10;

enum ControlBit : std::uint32_t {
  kEnable = 1U << 0,
  kOutput = 1U << 1,
  kPack = 1U << 7,
  kDma32 = 1U << 8,
  kSkip = 1U << 9,
  kSkipEven = 1U << 10,
  kInvertSyncs = 1U << 15,
};
constexpr std::uint32_t transfer_type(std::uint32_t control) { return control >> 2U & 3U; }
constexpr std::uint32_t port_configuration(std::uint32_t control) { return control >> 4U & 3U; }
constexpr std::uint32_t kItuAll = 1, kItuBlanking = 2, kSyncs = 3;
constexpr std::uint32_t kOneSync = 0, kTwoSyncs = 2;
bool wide_samples(std::uint32_t control) { return (control >> 11U & 7U) != 0; }  // DLEN above 8

enum StatusBit : std::uint32_t {
  kFrameTrackError = 1U << 11,
  kOverflow = 1U << 12,
  kSticky = 0xF800,  // all but FLD
};

}  // namespace

ParallelPort::ParallelPort(std::string name, Camera& camera, const PeripheralParameters& parameters,
                           double sclk_mhz, Outputs outputs)
    : name_(std::move(name)),
      camera_(camera),
      outputs_(std::move(outputs)),
      clock_share_(parameters.ppi_clock_share),
      clock_limit_mhz_(clock_share_ * sclk_mhz),
      burst_bytes_(static_cast<std::uint32_t>(parameters.ppi_burst_bytes) & ~3U) {}

const DeviceRegister* ParallelPort::find_register(std::uint32_t offset) const {
  using enum RegisterWidth;
  static constexpr std::array<DeviceRegister, 5> kRegisters = {{{kControl, "CONTROL", half},
                                                                {kStatus, "STATUS", half},
                                                                {kCount, "COUNT", half},
                                                                {kDelay, "DELAY", half},
                                                                {kFrame, "FRAME", half}}};
  return finback::find_register(kRegisters, offset);
}

void ParallelPort::fault(const char* register_name, std::uint32_t value,
                         const std::string& why) const {
  throw GuestFault(fmt::format("{}_{} = {:#06x}: {}", name_, register_name, value, why));
}

std::uint32_t ParallelPort::read(std::uint32_t offset, int, Cycles) {
  switch (offset) {
    case kControl:
      return control_;
    case kStatus:
      return status_;
    case kCount:
      return count_;
    case kDelay:
      return delay_;
    default:
      return frame_length_;
  }
}

void ParallelPort::write(std::uint32_t offset, int, std::uint32_t value, Cycles now) {
  value &= 0xFFFFU;
  switch (offset) {
    case kControl:
      stop();
      control_ = value;
      if ((value & kEnable) != 0) {
        start(now);
      }
      return;
    case kStatus:
      status_ &= ~(value & kSticky);
      update_error_line(now);
      return;
    case kCount:
      count_ = value;
      return;
    case kDelay:
      delay_ = value;
      return;
    default:
      frame_length_ = value;
      return;
  }
}

void ParallelPort::check_settings(std::uint32_t value) const {
  if (!camera_.connected()) {
    fault("CONTROL", value, "no camera is connected to this port");
  }
  if ((value & kOutput) != 0) {
    fault("CONTROL", value, "PORT_DIR = 1, output, is not modelled: a camera drives the pins");
  }
  const std::uint32_t type = transfer_type(value);
  if (type == kItuBlanking) {
    fault("CONTROL", value, "XFR_TYPE 2, vertical blanking alone, is not modelled; use 0, 1 or 3");
  }
  if (type == kSyncs && port_configuration(value) != kOneSync &&
      port_configuration(value) != kTwoSyncs) {
    fault("CONTROL", value,
          "the cameras give the frame syncs: PORT_CFG wants 0 (HREF) or 2 (HREF and VSYNC)");
  }
  if (type == kSyncs && (value & kInvertSyncs) != 0) {
    fault("CONTROL", value, "POLS = 1, but HREF and VSYNC of the cameras are high when active");
  }
  if ((type != kSyncs) != camera_.sends_itu656()) {
    fault("CONTROL", value,
          type == kSyncs
              ? "XFR_TYPE 3 wants frame syncs, but the camera sends ITU-656: set camera.itu656=0"
              : "XFR_TYPE wants ITU-656, but the camera sends none: set camera.itu656=1");
  }
  if (camera_.pixel_clock_mhz() > clock_limit_mhz_) {
    fault(
        "CONTROL", value,
        fmt::format("the camera's pixel clock of {:.3f} MHz is above {:.3f} MHz, the port's limit "
                    "at this SCLK; lower camera.frame_rate",
                    camera_.pixel_clock_mhz(), clock_limit_mhz_));
  }
}

void ParallelPort::start(Cycles now) {
  check_settings(control_);
  const std::uint32_t type = transfer_type(control_);
  const auto height = static_cast<std::uint32_t>(camera_.height());
  const bool all = type == kItuAll;
  first_line_ = all ? 0 : camera_.picture_line();
  lines_ = all ? camera_.frame_lines() : height;
  first_clock_ = all ? 0 : camera_.picture_clock();
  clocks_ = all ? camera_.line_clocks() : camera_.picture_clocks();
  extra_line_ = short_frame_ = false;
  if (type == kSyncs) {
    if (delay_ + count_ + 1 > clocks_) {
      fault("COUNT", count_,
            fmt::format("with DELAY = {} that is {} clocks; a line of the camera has {}", delay_,
                        delay_ + count_ + 1, clocks_));
    }
    first_clock_ += delay_;
    clocks_ = count_ + 1;
  }
  // FRAME counts the lines that a sync announces; in ITU-656 all, blank ones too.
  if (type != kSyncs || port_configuration(control_) == kTwoSyncs) {
    const std::uint32_t sent = type == kSyncs ? lines_ : camera_.frame_lines();
    extra_line_ = sent > frame_length_;
    short_frame_ = sent < frame_length_;
    lines_ = extra_line_ && type == kSyncs ? frame_length_ : lines_;
  }
  frame_before_ = false;
  words_.clear();
  plan_frame(now);
}

void ParallelPort::stop() { plan(Next::nothing, kNever); }

void ParallelPort::plan(Next next, Cycles reference) {
  next_ = next;
  next_reference_ = reference;
  next_event_ = time_.from_reference(reference);
}

void ParallelPort::change_clock(const clock::ClockChange& change) {
  clock_limit_mhz_ = clock_share_ * change.system_mhz;
  time_.change(change);
  next_event_ = time_.from_reference(next_reference_);
}

void ParallelPort::plan_frame(Cycles from) {
  camera_frame_ = camera_.next_frame(time_.to_reference(from));
  plan(Next::frame, camera_frame_.start);
}

void ParallelPort::plan_burst() {
  const std::uint32_t bytes_a_clock = word_bytes() == 1 || (control_ & kPack) != 0 ? 1 : 2;
  const std::uint32_t skipping = (control_ & kSkip) != 0 ? 2 : 1;
  taking_ = std::min(burst_bytes_ / bytes_a_clock * skipping, clocks_ - clock_);
  plan(Next::burst,
       camera_.time_of(camera_frame_, first_line_ + line_, first_clock_ + clock_ + taking_ - 1));
}

void ParallelPort::advance(Cycles now) {
  while (next_event_ <= now) {
    const Cycles at = next_event_;
    switch (next_) {
      case Next::frame:
        begin_frame(at);
        break;
      case Next::burst:
        take_burst(at);
        break;
      default:
        raise(kFrameTrackError, at);
        plan_frame(at);
        break;
    }
  }
}

void ParallelPort::begin_frame(Cycles now) {
  if (frame_before_ && short_frame_) {
    raise(kFrameTrackError, now);
  }
  frame_before_ = true;
  line_ = clock_ = 0;
  if (lines_ == 0) {
    end_frame(now);
  } else {
    plan_burst();
  }
}

void ParallelPort::take_burst(Cycles now) {
  samples_.resize(taking_);
  camera_.fill(camera_frame_, first_line_ + line_, first_clock_ + clock_, samples_);
  gather(samples_);
  hand_over(now);
  clock_ += taking_;
  if (clock_ == clocks_) {
    clock_ = 0;
    ++line_;
  }
  if (line_ == lines_) {
    ++frames_;
    outputs_.captured(camera_frame_.number, now);
    end_frame(now);
  } else {
    plan_burst();
  }
}

void ParallelPort::end_frame(Cycles now) {
  if (extra_line_) {
    // Seen when the line that is too much begins; in ITU-656 it is among the frame's last.
    const std::uint32_t line = transfer_type(control_) == kSyncs ? first_line_ + lines_ : 0;
    plan(Next::extra_line,
         std::max(time_.to_reference(now), camera_.time_of(camera_frame_, line, 0)));
  } else {
    plan_frame(now);
  }
}

std::uint32_t ParallelPort::word_bytes() const {
  if ((control_ & kDma32) != 0) {
    return 4;
  }
  const bool bytes_alone = !wide_samples(control_) && (control_ & kPack) == 0;
  return bytes_alone && outputs_.element_bytes() == 1 ? 1 : 2;
}

void ParallelPort::gather(std::span<const std::uint8_t> samples) {
  const std::uint32_t step = (control_ & kSkip) != 0 ? 2 : 1;
  const std::uint32_t kept = (control_ & kSkipEven) != 0 ? 1 : 0;  // of two
  const bool zero_extended =
      wide_samples(control_) || ((control_ & kPack) == 0 && word_bytes() != 1);
  // Bursts before the last of a line are even: the parity of a clock in a burst is its own.
  for (std::uint32_t i = step == 1 ? 0 : kept; i < samples.size(); i += step) {
    words_.push_back(samples[i]);
    if (zero_extended) {
      words_.push_back(0);
    }
  }
}

void ParallelPort::hand_over(Cycles now) {
  const std::uint32_t word = word_bytes();
  const std::uint32_t element = outputs_.element_bytes();
  if (element != 0 && element != word) {
    fault("CONTROL", control_,
          fmt::format("the port makes words of {} bits, its DMA channel takes {}: set WDSIZE, "
                      "PACK_EN or DMA32 to match",
                      word * 8, element * 8));
  }
  const std::size_t whole = words_.size() / word * word;
  const bool in_time = camera_.pixel_clock_mhz() <= clock_limit_mhz_;
  if (in_time && outputs_.push({words_.data(), whole}, now)) {
    bytes_ += whole;
  } else {
    lost_bytes_ += whole;
    raise(kOverflow, now);
  }
  words_.erase(words_.begin(), words_.begin() + static_cast<std::ptrdiff_t>(whole));
}

void ParallelPort::raise(std::uint32_t status, Cycles now) {
  frame_errors_ += status == kFrameTrackError ? 1 : 0;
  status_ |= status;
  update_error_line(now);
}

void ParallelPort::update_error_line(Cycles now) {
  const bool level = (status_ & kSticky) != 0;
  if (level != error_line_) {
    error_line_ = level;
    outputs_.error_line(level, now);
  }
}

void ParallelPort::register_counters(CounterRegistry& registry) const {
  std::string prefix = name_ + ".";
  std::ranges::transform(prefix, prefix.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  registry.add(prefix + "frames.events", "events", "frames of the camera that the port read whole",
               &frames_);
  registry.add(prefix + "captured.bytes", "bytes", "bytes that the port handed to its DMA channel",
               &bytes_);
  registry.add(prefix + "lost.bytes", "bytes", "bytes that were lost: the DMA's FIFO was full",
               &lost_bytes_);
  registry.add(prefix + "frame_errors.events", "events", "frame track errors: not FRAME lines",
               &frame_errors_);
}

}  // namespace finback::peripheral
