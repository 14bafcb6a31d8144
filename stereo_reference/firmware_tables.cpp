#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <random>

#include <stereo_reference/firmware_tables.hpp>

namespace finback::stereo_reference {

namespace {

using scenes::ByteImage;

constexpr int kPixelsPerLine = 4;

ByteImage noise_picture(int width, int height) {
  std::mt19937 generator(1);
  ByteImage image(width, height);
  std::generate_n(image.data(), image.pixels().size(),
                  [&] { return static_cast<std::uint8_t>(generator() >> 24U); });
  return image;
}

bool inside(const Eigen::Vector2d& at, int width, int height) {
  return at.x() >= 0 && at.y() >= 0 && at.x() <= width - 1 && at.y() <= height - 1;
}

TableErrors errors_of(const RectificationTable& table, const PixelMap& used,
                      const PixelMap& exact) {
  const ByteImage picture = noise_picture(exact.width, exact.height);
  const ByteImage truth = remap(picture, exact);
  const ByteImage by_table = remap(picture, table);
  const ByteImage by_used = remap(picture, used);
  TableErrors errors;
  double both = 0;
  double seen = 0;
  for (Eigen::Index n = 0; n < exact.sources.cols(); ++n) {
    const bool is_seen = inside(used.sources.col(n), exact.width, exact.height);
    seen += is_seen ? 1 : 0;
    if (!is_seen || !inside(exact.sources.col(n), exact.width, exact.height)) {
      continue;
    }
    const auto i = static_cast<std::size_t>(n);
    const int error = std::abs(int{by_table.pixels()[i]} - int{truth.pixels()[i]});
    errors.mean += error;
    errors.largest = std::max(errors.largest, error);
    errors.tangential_mean += std::abs(int{by_used.pixels()[i]} - int{truth.pixels()[i]});
    errors.tangential_shift =
        std::max(errors.tangential_shift, (used.sources.col(n) - exact.sources.col(n)).norm());
    ++both;
  }
  errors.seen_percent = 100 * seen / static_cast<double>(exact.sources.cols());
  errors.mean /= std::max(both, 1.0);
  errors.tangential_mean /= std::max(both, 1.0);
  return errors;
}

void append(std::string& text, const char* name, const RectificationTable& table) {
  auto out = std::back_inserter(text);
  const std::size_t pixels = table.weights.size();
  fmt::format_to(out, "\nconst unsigned char rectification_{}_source[{}][2] = {{", name, pixels);
  for (std::size_t n = 0; n < pixels; ++n) {
    fmt::format_to(out, "{}{{{}, {}}},", n % kPixelsPerLine == 0 ? "\n    " : " ", table.column[n],
                   table.row[n]);
  }
  fmt::format_to(out, "\n}};\n\nconst short rectification_{}_weights[{}][4] = {{", name, pixels);
  for (std::size_t n = 0; n < pixels; ++n) {
    const auto& w = table.weights[n];
    fmt::format_to(out, "{}{{{}, {}, {}, {}}},", n % kPixelsPerLine == 0 ? "\n    " : " ", w[0],
                   w[1], w[2], w[3]);
  }
  text += "\n};\n";
}

void append_16(std::string& bytes, int value) {
  bytes += static_cast<char>(value & 0xFF);
  bytes += static_cast<char>((value >> 8) & 0xFF);
}

}  // namespace

FirmwareTables firmware_tables(const StereoCalibration& calibration, int n, bool tangential) {
  const StereoCalibration small = subsampled(calibration, n);
  const RectifiedPair pair = rectify(small);
  FirmwareTables tables;
  const auto make = [&](const Intrinsics& camera, const Eigen::Matrix3d& rotation,
                        const Intrinsics& rectified, RectificationTable& table,
                        TableErrors& errors) {
    const PixelMap exact = pixel_map(camera, rotation, rectified, small.width, small.height);
    const PixelMap used =
        pixel_map(camera, rotation, rectified, small.width, small.height, tangential);
    table = rectification_table(used);
    errors = errors_of(table, used, exact);
  };
  make(small.left, pair.left_rotation, pair.left, tables.left, tables.left_errors);
  make(small.right, pair.right_rotation, pair.right, tables.right, tables.right_errors);
  return tables;
}

std::string tables_as_c(const FirmwareTables& tables) {
  std::string text = fmt::format(
      "/* Rectification of pictures of {0} x {1} pixels, row by row, made by finback stereo "
      "tables.\n"
      "   source: column and row of the upper left of four neighbours.\n"
      "   weights: of the upper left, upper right, lower left, lower right one, as fractions of "
      "1.15;\n"
      "   all 0 where the camera did not see. */\n",
      tables.left.width, tables.left.height);
  append(text, "left", tables.left);
  append(text, "right", tables.right);
  return text;
}

std::string tables_as_flash(const FirmwareTables& tables) {
  std::string bytes = "RECT";
  append_16(bytes, tables.left.width);
  append_16(bytes, tables.left.height);
  for (const RectificationTable* table : {&tables.left, &tables.right}) {
    const auto width = static_cast<std::size_t>(table->width);
    for (std::size_t row = 0; row < table->weights.size(); row += width) {
      for (std::size_t n = row; n < row + width; ++n) {
        bytes += static_cast<char>(table->column[n]);
        bytes += static_cast<char>(table->row[n]);
      }
      for (std::size_t n = row; n < row + width; ++n) {
        for (const std::int16_t weight : table->weights[n]) {
          append_16(bytes, weight);
        }
      }
    }
  }
  return bytes;
}

}  // namespace finback::stereo_reference
