// One video, picture by picture: what video.cpp wants of the module that reads videos.
//
// The module, lib/finback/video.so, is OpenCV's videoio behind this interface. It is loaded when
// the first video is opened: its libraries would slow the start of every program by a tenth of a
// second. Does not model: sound, time stamps; pictures are counted.
#pragma once

#include <cstdint>

#include <scenes/image.hpp>

namespace finback::scenes {

class VideoFile {
 public:
  VideoFile() = default;
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;
  virtual ~VideoFile() = default;

  // How many pictures the file says it has; 0: none, or it does not know.
  [[nodiscard]] virtual std::uint32_t frames() const = 0;
  // Luma of picture `number`, in its own size; false where it cannot be read. Forwards is fast.
  virtual bool read(std::uint32_t number, ByteImage& luma) = 0;
};

// What the module exports by this name. The caller owns the video; null: none that OpenCV reads.
inline constexpr const char* kOpenVideoName = "finback_open_video";
using OpenVideo = VideoFile*(const char* path);

}  // namespace finback::scenes
