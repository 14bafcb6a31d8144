// The host port: frames in, maps, console and exit out. Ours, not the BF561's.
//
// Models: 32-bit registers at 0xFFC0F000 (HostRegister) through which firmware asks the host for
// the next pair of 640x480 luma images, publishes result maps, prints and stops. Grabbing takes no
// time: it stands for cameras and a driver of them; its bytes are counted as initiator `host`. Maps
// may also belong to frames that a firmware captures by the parallel port of the left camera.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <common/device.hpp>
#include <common/units.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::machine {

inline constexpr std::uint32_t kFrameWidth = 640;
inline constexpr std::uint32_t kFrameHeight = 480;

enum HostRegister : std::uint32_t {
  kFramesLeft = 0x00,         // read: pairs that can still be grabbed
  kFrameLeftAddress = 0x04,   // buffers that FRAME_GRAB fills, 640 * 480 bytes each
  kFrameRightAddress = 0x08,  //
  kFrameGrab = 0x0C,          // write 1: fill both buffers
  kMapAddress = 0x10,         //
  kMapSize = 0x14,            // width | height << 16
  kMapPublish = 0x18,         // write the number of the frame that the map belongs to
  kConsole = 0x1C,            // write one character
  kExit = 0x20,               // write the status: the machine stops
  kFrameNumber = 0x24,        // read: number of the frame grabbed last, from 0
};

struct StereoFrame {
  std::vector<std::uint8_t> left;  // kFrameWidth * kFrameHeight, row by row
  std::vector<std::uint8_t> right;
};

struct PublishedMap {
  std::uint32_t frame_number = 0;
  std::uint32_t picture = 0;  // number of the pair that the cameras saw
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> bytes;  // width * height
  Cycles grabbed_at = 0;            // when the frame of that number was grabbed or captured
  Cycles published_at = 0;
};

class HostPort final : public Device {
 public:
  static constexpr std::uint32_t kRegisterBytes = 0x28;

  explicit HostPort(memory::MemorySystem& memory) : memory_(memory) {}

  // --- the host's side ---
  // The pair of a number, from 0. Called once a grab.
  using Frames = std::function<StereoFrame(std::uint32_t number)>;
  // The firmware can grab `count` pairs.
  void set_frame_source(Frames frames, std::uint32_t count);
  // The same from `frames` in turn, again from the first when `count` is larger. Throws InputError
  // when `frames` is empty or an image has another size.
  void set_frames(std::vector<StereoFrame> frames, std::uint32_t count);
  [[nodiscard]] const std::vector<PublishedMap>& maps() const { return maps_; }
  // The left camera's port has read a whole frame: the next that maps can belong to, where nothing
  // was grabbed.
  void frame_captured(std::uint32_t picture, Cycles at) { captured_.push_back({picture, at}); }
  [[nodiscard]] std::uint32_t frames_grabbed() const {
    return static_cast<std::uint32_t>(grabbed_.size());
  }
  // Called with each line that the firmware prints, without its end; lines keep their order.
  void set_console(std::function<void(const std::string& line)> console) {
    console_ = std::move(console);
  }
  // Called for each map at the time of its publication, after it was added to maps().
  void set_map_listener(std::function<void(const PublishedMap&)> listener) {
    map_listener_ = std::move(listener);
  }
  // Called when EXIT is written. An unfinished console line is delivered first.
  void set_exit(std::function<void(std::uint32_t status, Cycles at)> exit) {
    exit_ = std::move(exit);
  }

  // Prints as if by CONSOLE, character by character.
  void print(std::string_view text);
  // Delivers a console line that has no end yet; for who stops the machine otherwise.
  void flush_line();

  // --- the machine's side: registers, by offset (one of HostRegister) ---
  [[nodiscard]] const DeviceRegister* find_register(std::uint32_t offset) const override;
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, int bytes, Cycles now) override;
  void write(std::uint32_t offset, int bytes, std::uint32_t value, Cycles now) override;

 private:
  void grab(std::uint32_t value, Cycles now);
  void fill(Address address, const std::vector<std::uint8_t>& image, const char* register_name);
  void publish(std::uint32_t frame_number, Cycles now);
  std::uint8_t* buffer(Address address, std::uint32_t size, memory::Direction direction,
                       const char* register_name);
  void print(char character);

  memory::MemorySystem& memory_;
  Frames frames_;
  std::uint32_t frame_count_ = 0;
  struct Seen {
    std::uint32_t picture = 0;
    Cycles at = 0;
  };
  std::vector<Seen> grabbed_;
  std::vector<Seen> captured_;  // by a parallel port
  std::uint32_t left_address_ = 0;
  std::uint32_t right_address_ = 0;
  std::uint32_t map_address_ = 0;
  std::uint32_t map_size_ = 0;
  std::vector<PublishedMap> maps_;
  std::string line_;
  std::function<void(const std::string&)> console_;
  std::function<void(const PublishedMap&)> map_listener_;
  std::function<void(std::uint32_t, Cycles)> exit_;
};

}  // namespace finback::machine
