// Disparity maps and ground truth as grey pictures.
//
// Models: grey = disparity times a whole scale, 0 for "none", as Middlebury's files have it. Does
// not model: other formats (PFM, 16 bits); finback run's own pictures of maps, which are for the
// eye.
#pragma once

#include <filesystem>

#include <scenes/image.hpp>

namespace finback::stereo_reference {

// Throws InputError "PATH: ..." for a picture that cannot be read, greys that are no multiple of
// the scale, and a scale outside 1..255.
[[nodiscard]] scenes::ByteImage load_map(const std::filesystem::path& path, int scale);

// Greys of a truth as disparities, with fractions of a pixel.
[[nodiscard]] scenes::FloatImage truth_of(const scenes::ByteImage& greys, float scale);

// A ground truth from a file. Throws InputError as load_map, but for greys between multiples.
[[nodiscard]] scenes::FloatImage load_truth(const std::filesystem::path& path, int scale);

// Writes a PNG, whole or not at all. Throws InputError where a disparity times the scale is over
// 255.
void write_map(const scenes::ByteImage& map, int scale, const std::filesystem::path& path);

}  // namespace finback::stereo_reference
