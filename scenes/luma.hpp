// Images from files, brought to what a camera delivers, and maps to files that people can look at.
//
// Models: a 640x480 luma camera image made from any picture that OpenCV reads. Does not model: the
// optics, the sensor's noise or the YUV 4:2:2 packing. Results are exact integers on every host.
#pragma once

#include <filesystem>

#include <scenes/image.hpp>

namespace finback::scenes {

inline constexpr int kVgaWidth = 640;
inline constexpr int kVgaHeight = 480;

// Reads a picture as luma (BT.601 weights) of its own size, 8 bits.
// Throws InputError "PATH: ..." when it is missing, empty, a folder or not an image.
[[nodiscard]] ByteImage load_luma(const std::filesystem::path& path);

// Reads a picture of any size and colour as 640x480 luma: the largest centred 4:3 part of it, then,
// per direction, the mean over the area of a target pixel where it shrinks and linear interpolation
// where it grows, rounded to the nearest. Throws like load_luma, also for a picture without a 4:3
// part (narrower than 4 or lower than 3 pixels).
[[nodiscard]] ByteImage load_luma_vga(const std::filesystem::path& path);

struct LumaPair {
  ByteImage left;
  ByteImage right;
};

// Both views by load_luma_vga. Throws InputError naming both sizes when the pictures differ in
// size: crop and scale would then not be the same for both.
[[nodiscard]] LumaPair load_luma_vga_pair(const std::filesystem::path& left,
                                          const std::filesystem::path& right);

// The two steps of load_luma_vga on an image at hand. Throws InputError on a size below 4x3
// (crop) or an empty image (resize).
[[nodiscard]] ByteImage crop_to_4_by_3(const ByteImage& image);
[[nodiscard]] ByteImage resize(const ByteImage& image, int width, int height);

// Writes a PNG whose file appears whole or not at all. Throws InputError when it cannot be written.
void write_png(const ByteImage& image, const std::filesystem::path& path);

// Writes a disparity map as a grey PNG: 0 (invalid) is black; disparity d in dmin..dmax becomes
// 255 * (d - dmin + 1) / (dmax - dmin + 1), rounded, so that dmax is white and near is bright.
// Throws InputError when the range is empty or a valid disparity lies outside it.
void write_disparity_png(const ByteImage& map, int disparity_min, int disparity_max,
                         const std::filesystem::path& path);

}  // namespace finback::scenes
