#include <algorithm>
#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string_view>
#include <system_error>
#include <vector>

#include <common/error.hpp>
#include <common/file.hpp>
#include <scenes/luma.hpp>

namespace finback::scenes {

namespace fs = std::filesystem;

namespace {

// A source pixel and its weight in a target pixel; the weights of a target pixel sum to the axis's
// total.
struct Tap {
  int index = 0;
  std::int64_t weight = 0;
};

struct Axis {
  std::vector<std::vector<Tap>> taps;  // per target pixel
  std::int64_t total = 1;
};

// Shrinking: target pixel i covers [i * source, (i + 1) * source) of a line in which a source pixel
// is `target` long; a tap's weight is the length covered.
Axis area_axis(int source, int target) {
  Axis axis;
  axis.total = source;
  for (std::int64_t i = 0; i < target; ++i) {
    const std::int64_t begin = i * source;
    const std::int64_t end = begin + source;
    std::vector<Tap> taps;
    for (std::int64_t pixel = begin / target; pixel * target < end; ++pixel) {
      const std::int64_t covered =
          std::min(end, (pixel + 1) * target) - std::max(begin, pixel * target);
      taps.push_back({static_cast<int>(pixel), covered});
    }
    axis.taps.push_back(std::move(taps));
  }
  return axis;
}

// Growing: the centre of target pixel i lies at ((2 i + 1) * source - target) / (2 * target) source
// pixels from the centre of the first one; beyond the outer centres the outer pixel is repeated.
Axis linear_axis(int source, int target) {
  Axis axis;
  const std::int64_t unit = 2 * static_cast<std::int64_t>(target);
  axis.total = unit;
  for (std::int64_t i = 0; i < target; ++i) {
    const std::int64_t last = (source - 1) * unit;
    const std::int64_t place = std::clamp<std::int64_t>((2 * i + 1) * source - target, 0, last);
    const int pixel = static_cast<int>(place / unit);
    const std::int64_t fraction = place % unit;
    axis.taps.push_back({{pixel, unit - fraction}, {std::min(pixel + 1, source - 1), fraction}});
  }
  return axis;
}

Axis make_axis(int source, int target) {
  return source >= target ? area_axis(source, target) : linear_axis(source, target);
}

}  // namespace

ByteImage crop_to_4_by_3(const ByteImage& image) {
  const int unit = std::min(image.width() / 4, image.height() / 3);
  if (unit == 0) {
    throw InputError(fmt::format("image of {}x{}: too small for a 4:3 picture, at least 4x3 needed",
                                 image.width(), image.height()));
  }
  // The limiting side stays whole; the other one is cut to the nearest pixel below 4:3.
  const bool wide =
      static_cast<std::int64_t>(image.width()) * 3 > static_cast<std::int64_t>(image.height()) * 4;
  const int width = wide ? image.height() * 4 / 3 : image.width();
  const int height = wide ? image.height() : image.width() * 3 / 4;
  const int left = (image.width() - width) / 2;
  const int top = (image.height() - height) / 2;
  ByteImage part(width, height);
  for (int y = 0; y < height; ++y) {
    std::copy_n(&image.at(left, top + y), width, &part.at(0, y));
  }
  return part;
}

ByteImage resize(const ByteImage& image, int width, int height) {
  if (image.empty() || width < 1 || height < 1) {
    throw InputError(fmt::format("resizing {}x{} to {}x{}: no side may be 0", image.width(),
                                 image.height(), width, height));
  }
  const Axis columns = make_axis(image.width(), width);
  const Axis rows = make_axis(image.height(), height);
  Image<std::int64_t> narrowed(width, image.height());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < width; ++x) {
      for (const Tap& tap : columns.taps[static_cast<std::size_t>(x)]) {
        narrowed.at(x, y) += tap.weight * image.at(tap.index, y);
      }
    }
  }
  const std::int64_t total = columns.total * rows.total;
  ByteImage resized(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::int64_t sum = 0;
      for (const Tap& tap : rows.taps[static_cast<std::size_t>(y)]) {
        sum += tap.weight * narrowed.at(x, tap.index);
      }
      resized.at(x, y) = static_cast<std::uint8_t>((2 * sum + total) / (2 * total));
    }
  }
  return resized;
}

ByteImage load_luma(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw InputError(fmt::format("{}: no such image file", path.string()));
  }
  if (fs::is_directory(path, error)) {
    throw InputError(fmt::format("{}: is a folder, not an image file", path.string()));
  }
  if (fs::file_size(path, error) == 0) {
    throw InputError(fmt::format("{}: the image file is empty", path.string()));
  }
  cv::Mat colour;
  try {
    colour = cv::imread(path.string(), cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    // Damaged headers make some decoders throw instead of returning an empty image.
    colour.release();
  }
  if (colour.empty()) {
    throw InputError(fmt::format(
        "{}: not an image that can be read; use PNG, JPEG, PGM, PPM, BMP or TIFF", path.string()));
  }
  cv::Mat luma;
  cv::cvtColor(colour, luma, cv::COLOR_BGR2GRAY);
  ByteImage image(luma.cols, luma.rows);
  for (int y = 0; y < luma.rows; ++y) {
    std::copy_n(luma.ptr<std::uint8_t>(y), luma.cols, &image.at(0, y));
  }
  return image;
}

namespace {

ByteImage to_vga(const ByteImage& image, const fs::path& path) {
  try {
    return resize(crop_to_4_by_3(image), kVgaWidth, kVgaHeight);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

}  // namespace

ByteImage load_luma_vga(const fs::path& path) { return to_vga(load_luma(path), path); }

LumaPair load_luma_vga_pair(const fs::path& left, const fs::path& right) {
  const ByteImage left_image = load_luma(left);
  const ByteImage right_image = load_luma(right);
  if (left_image.width() != right_image.width() || left_image.height() != right_image.height()) {
    throw InputError(
        fmt::format("stereo pair: {} is {}x{} but {} is {}x{}; both views must have the same size",
                    left.string(), left_image.width(), left_image.height(), right.string(),
                    right_image.width(), right_image.height()));
  }
  return {to_vga(left_image, left), to_vga(right_image, right)};
}

void write_png(const ByteImage& image, const fs::path& path) {
  if (image.empty()) {
    throw InputError(fmt::format("{}: an empty image cannot be written", path.string()));
  }
  cv::Mat pixels(image.height(), image.width(), CV_8UC1);
  for (int y = 0; y < image.height(); ++y) {
    std::copy_n(&image.at(0, y), image.width(), pixels.ptr<std::uint8_t>(y));
  }
  std::vector<std::uint8_t> encoded;
  if (!cv::imencode(".png", pixels, encoded)) {
    throw InputError(fmt::format("{}: the PNG encoder refused an image of {}x{}", path.string(),
                                 image.width(), image.height()));
  }
  write_file_whole(path, std::string(encoded.begin(), encoded.end()));
}

void write_disparity_png(const ByteImage& map, int disparity_min, int disparity_max,
                         const fs::path& path) {
  if (disparity_min < 1 || disparity_max > 255 || disparity_min > disparity_max) {
    throw InputError(fmt::format("{}: disparities {}..{} must lie in 1..255, the smaller first",
                                 path.string(), disparity_min, disparity_max));
  }
  const int levels = disparity_max - disparity_min + 1;
  ByteImage grey(map.width(), map.height());
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const int d = map.at(x, y);
      if (d == 0) {
        continue;
      }
      if (d < disparity_min || d > disparity_max) {
        throw InputError(fmt::format("{}: disparity {} at ({}, {}) is outside {}..{}",
                                     path.string(), d, x, y, disparity_min, disparity_max));
      }
      grey.at(x, y) =
          static_cast<std::uint8_t>((2 * 255 * (d - disparity_min + 1) + levels) / (2 * levels));
    }
  }
  write_png(grey, path);
}

}  // namespace finback::scenes
