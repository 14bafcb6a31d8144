// A plain image: rows of pixels, row-major, without padding.
//
// Shared by the scenes and the stereo reference, so that neither hands OpenCV types around: the
// machine's host port and the firmware's C kernels want the same bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace finback::scenes {

template <typename Pixel>
class Image {
 public:
  Image() = default;
  Image(int width, int height, Pixel value = Pixel())
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool empty() const { return pixels_.empty(); }

  // Column x in 0..width-1, row y in 0..height-1; not checked.
  [[nodiscard]] Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
  [[nodiscard]] const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

  [[nodiscard]] Pixel* data() { return pixels_.data(); }
  [[nodiscard]] const Pixel* data() const { return pixels_.data(); }
  [[nodiscard]] const std::vector<Pixel>& pixels() const { return pixels_; }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

using ByteImage = Image<std::uint8_t>;
using FloatImage = Image<float>;

}  // namespace finback::scenes
