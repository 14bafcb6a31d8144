// Makes scenes/aloe from the pictures of Debian's package opencv-doc (see scenes/aloe/README.md):
//   finback_make_aloe /usr/share/doc/opencv-doc/examples/data scenes/aloe
//
// From the 1282x1110 originals it takes the same 1280x960 part of both views, shrinks it by exactly
// 2 to VGA, and takes every 8th pixel of every 8th row of the truth, whose grey values, disparities
// of the full size, thereby become 8 times the disparities at 160x120.
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>

#include <common/error.hpp>
#include <scenes/luma.hpp>

namespace {

using finback::scenes::ByteImage;

constexpr int kLeft = 1;
constexpr int kTop = 75;
constexpr int kWidth = 1280;
constexpr int kHeight = 960;
constexpr int kTruthStep = 8;

ByteImage part_of(const ByteImage& image) {
  if (image.width() < kLeft + kWidth || image.height() < kTop + kHeight) {
    throw finback::InputError(
        fmt::format("the picture is {}x{}, expected 1282x1110", image.width(), image.height()));
  }
  ByteImage part(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      part.at(x, y) = image.at(kLeft + x, kTop + y);
    }
  }
  return part;
}

ByteImage every_eighth(const ByteImage& image) {
  ByteImage small(kWidth / kTruthStep, kHeight / kTruthStep);
  for (int y = 0; y < small.height(); ++y) {
    for (int x = 0; x < small.width(); ++x) {
      small.at(x, y) = image.at(kTruthStep * x, kTruthStep * y);
    }
  }
  return small;
}

void make(const std::filesystem::path& from, const std::filesystem::path& to) {
  using namespace finback::scenes;
  for (const auto& [source, target] :
       {std::pair{"aloeL.jpg", "left.png"}, std::pair{"aloeR.jpg", "right.png"}}) {
    write_png(resize(part_of(load_luma(from / source)), kVgaWidth, kVgaHeight), to / target);
  }
  write_png(every_eighth(part_of(load_luma(from / "aloeGT.png"))), to / "truth.png");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: finback_make_aloe FOLDER_OF_ALOE_PICTURES TARGET_FOLDER\n");
    return 1;
  }
  try {
    make(argv[1], argv[2]);
  } catch (const finback::InputError& error) {
    fmt::print(stderr, "finback_make_aloe: {}\n", error.what());
    return 2;
  }
  return 0;
}
