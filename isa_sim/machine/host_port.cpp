#include <array>
#include <cstring>
#include <fmt/format.h>

#include <common/error.hpp>
#include <isa_sim/machine/host_port.hpp>

namespace finback::machine {

namespace {

constexpr std::uint32_t kFrameBytes = kFrameWidth * kFrameHeight;

void check_size(const StereoFrame& frame, std::size_t number) {
  if (frame.left.size() != kFrameBytes || frame.right.size() != kFrameBytes) {
    throw InputError(fmt::format(
        "host port: frame {} has {} and {} bytes instead of {}x{} luma, {} each", number,
        frame.left.size(), frame.right.size(), kFrameWidth, kFrameHeight, kFrameBytes));
  }
}

}  // namespace

const DeviceRegister* HostPort::find_register(std::uint32_t offset) const {
  static constexpr std::array<DeviceRegister, 10> kRegisters = {
      {{kFramesLeft, "FRAMES_LEFT"},
       {kFrameLeftAddress, "FRAME_LEFT_ADDRESS"},
       {kFrameRightAddress, "FRAME_RIGHT_ADDRESS"},
       {kFrameGrab, "FRAME_GRAB"},
       {kMapAddress, "MAP_ADDRESS"},
       {kMapSize, "MAP_SIZE"},
       {kMapPublish, "MAP_PUBLISH"},
       {kConsole, "CONSOLE"},
       {kExit, "EXIT"},
       {kFrameNumber, "FRAME_NUMBER"}}};
  return finback::find_register(kRegisters, offset);
}

void HostPort::set_frame_source(Frames frames, std::uint32_t count) {
  frames_ = std::move(frames);
  frame_count_ = count;
}

void HostPort::set_frames(std::vector<StereoFrame> frames, std::uint32_t count) {
  if (frames.empty() && count > 0) {
    throw InputError("host port: there are no frames to grab");
  }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    check_size(frames[i], i);
  }
  set_frame_source(
      [all = std::move(frames)](std::uint32_t number) { return all[number % all.size()]; }, count);
}

std::uint32_t HostPort::read(std::uint32_t offset, int /*bytes*/, Cycles /*now*/) {
  switch (offset) {
    case kFramesLeft:
      return frame_count_ - frames_grabbed();
    case kFrameLeftAddress:
      return left_address_;
    case kFrameRightAddress:
      return right_address_;
    case kMapAddress:
      return map_address_;
    case kMapSize:
      return map_size_;
    case kFrameNumber:
      if (grabbed_.empty()) {
        throw GuestFault("HOST_FRAME_NUMBER was read before the first FRAME_GRAB");
      }
      return frames_grabbed() - 1;
    default:
      break;
  }
  throw GuestFault(fmt::format("HOST_{} is write-only", register_name(offset)));
}

void HostPort::write(std::uint32_t offset, int /*bytes*/, std::uint32_t value, Cycles now) {
  switch (offset) {
    case kFrameLeftAddress:
      left_address_ = value;
      return;
    case kFrameRightAddress:
      right_address_ = value;
      return;
    case kFrameGrab:
      grab(value, now);
      return;
    case kMapAddress:
      map_address_ = value;
      return;
    case kMapSize:
      map_size_ = value;
      return;
    case kMapPublish:
      publish(value, now);
      return;
    case kConsole:
      print(static_cast<char>(value & 0xFFU));
      return;
    case kExit:
      flush_line();
      if (exit_) {
        exit_(value, now);
      }
      return;
    default:
      break;
  }
  throw GuestFault(fmt::format("HOST_{} is read-only", register_name(offset)));
}

void HostPort::grab(std::uint32_t value, Cycles now) {
  if (value != 1) {
    throw GuestFault(fmt::format("HOST_FRAME_GRAB = {}: write 1 to grab a frame", value));
  }
  if (frames_grabbed() >= frame_count_) {
    throw GuestFault(fmt::format(
        "HOST_FRAME_GRAB: all {} frames were grabbed; firmware must look at HOST_FRAMES_LEFT first",
        frame_count_));
  }
  const StereoFrame frame = frames_(frames_grabbed());
  check_size(frame, frames_grabbed());
  fill(left_address_, frame.left, "FRAME_LEFT_ADDRESS");
  fill(right_address_, frame.right, "FRAME_RIGHT_ADDRESS");
  grabbed_.push_back({frames_grabbed(), now});
}

std::uint8_t* HostPort::buffer(Address address, std::uint32_t size, memory::Direction direction,
                               const char* register_name) {
  try {
    return memory_.host_access(address, size, direction);
  } catch (const InputError& error) {
    throw GuestFault(fmt::format("HOST_{} = {:#010x}: {}", register_name, address, error.what()));
  }
}

void HostPort::fill(Address address, const std::vector<std::uint8_t>& image,
                    const char* register_name) {
  std::memcpy(buffer(address, kFrameBytes, memory::Direction::write, register_name), image.data(),
              image.size());
}

void HostPort::publish(std::uint32_t frame_number, Cycles now) {
  const std::uint32_t width = map_size_ & 0xFFFFU;
  const std::uint32_t height = map_size_ >> 16U;
  if (width == 0 || height == 0) {
    throw GuestFault(
        fmt::format("HOST_MAP_SIZE = {:#x}: a map of {} x {} is empty; write width | "
                    "height << 16",
                    map_size_, width, height));
  }
  const bool grabs = !grabbed_.empty() || captured_.empty();
  const std::vector<Seen>& seen = grabs ? grabbed_ : captured_;
  if (frame_number >= seen.size()) {
    throw GuestFault(fmt::format("HOST_MAP_PUBLISH = {}: {} frames were {} so far", frame_number,
                                 seen.size(), grabs ? "grabbed" : "captured"));
  }
  const std::uint8_t* bytes =
      buffer(map_address_, width * height, memory::Direction::read, "MAP_ADDRESS");
  maps_.push_back({.frame_number = frame_number,
                   .picture = seen[frame_number].picture,
                   .width = width,
                   .height = height,
                   .bytes = std::vector<std::uint8_t>(bytes, bytes + std::size_t{width} * height),
                   .grabbed_at = seen[frame_number].at,
                   .published_at = now});
  if (map_listener_) {
    map_listener_(maps_.back());
  }
}

void HostPort::print(std::string_view text) {
  for (const char character : text) {
    print(character);
  }
}

void HostPort::print(char character) {
  if (character == '\n') {
    if (console_) {
      console_(line_);
    }
    line_.clear();
  } else {
    line_ += character;
  }
}

void HostPort::flush_line() {
  if (!line_.empty()) {
    print('\n');
  }
}

}  // namespace finback::machine
