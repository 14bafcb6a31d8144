// Makes the README's picture from a real run: left view, computed map, truth, side by side.
//
//     build/release/bin/finback run --scene aloe --frames 1 --out out/aloe
//     cmake --build build/release --target finback_montage
//     build/release/bin/finback_montage aloe out/aloe/disparity_0000.png docs/images/aloe.png
#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <common/file.hpp>
#include <scenes/luma.hpp>
#include <scenes/scene.hpp>

namespace {

using namespace finback;

constexpr int kWidth = 480;
constexpr int kHeight = 360;
constexpr int kGap = 12;
constexpr float kDisparityMin = 5;
constexpr float kDisparityMax = 35;

// Colours from blue (far) over green to red (near); 0 is black.
cv::Mat coloured(const scenes::FloatImage& disparities) {
  cv::Mat grey(disparities.height(), disparities.width(), CV_8UC1);
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      const float share = (disparities.at(x, y) - kDisparityMin) / (kDisparityMax - kDisparityMin);
      grey.at<std::uint8_t>(y, x) =
          static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0F, 1.0F)));
    }
  }
  cv::Mat colours;
  cv::applyColorMap(grey, colours, cv::COLORMAP_TURBO);
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      if (disparities.at(x, y) == 0) {
        colours.at<cv::Vec3b>(y, x) = cv::Vec3b(0, 0, 0);
      }
    }
  }
  cv::resize(colours, colours, cv::Size(kWidth, kHeight), 0, 0, cv::INTER_NEAREST);
  return colours;
}

// A map as `finback run` writes it, back to disparities.
scenes::FloatImage read_map(const std::string& path) {
  const scenes::ByteImage grey = scenes::load_luma(path);
  scenes::FloatImage map(grey.width(), grey.height());
  std::transform(grey.pixels().begin(), grey.pixels().end(), map.data(), [](std::uint8_t value) {
    return value == 0 ? 0
                      : static_cast<float>(value) * (kDisparityMax - kDisparityMin + 1) / 255 +
                            kDisparityMin - 1;
  });
  return map;
}

cv::Mat view(const scenes::ByteImage& image) {
  const cv::Mat grey(image.height(), image.width(), CV_8UC1,
                     const_cast<std::uint8_t*>(image.data()));
  cv::Mat colour;
  cv::resize(grey, colour, cv::Size(kWidth, kHeight), 0, 0, cv::INTER_AREA);
  cv::cvtColor(colour, colour, cv::COLOR_GRAY2BGR);
  return colour;
}

void make(const std::string& scene_name, const std::string& map, const std::string& output) {
  const scenes::Scene scene = scenes::load_scene(scene_name, share_folder() / "scenes");
  const cv::Mat gap(kHeight, kGap, CV_8UC3, cv::Scalar(255, 255, 255));
  cv::Mat picture;
  cv::hconcat(std::vector<cv::Mat>{view(scene.left), gap, coloured(read_map(map)), gap,
                                   coloured(scene.truth)},
              picture);
  cv::imwrite(output, picture, {cv::IMWRITE_PNG_COMPRESSION, 9});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: finback_montage SCENE MAP.png OUTPUT.png\n");
    return 1;
  }
  try {
    make(argv[1], argv[2], argv[3]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "finback_montage: {}\n", error.what());
    return 2;
  }
}
