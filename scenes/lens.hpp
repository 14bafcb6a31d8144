// What a lens and its mounting do to a picture: radial distortion, rotation, shift.
//
// Models: the Brown-Conrady radial terms, r' = r (1 + k1 r^2 + k2 r^4) with r = 1 at half the
// picture's width from its centre, then a rotation about the centre and a shift; bilinear sampling;
// what lies beyond the picture repeats its edge. Does not model: tangential distortion, blur,
// vignetting, colour. Sampling points are rounded to 1/256 pixel and sines come from their series,
// so that the same picture has the same bytes on every host.
#pragma once

#include <string>

#include <scenes/image.hpp>

namespace finback::scenes {

struct Lens {
  double k1 = 0;
  double k2 = 0;
  double rotation_degrees = 0;  // clockwise, as seen in the picture; -45 to 45
  double shift_x = 0;           // pixels, to the right
  double shift_y = 0;           // pixels, down

  [[nodiscard]] bool changes_nothing() const { return *this == Lens{}; }
  friend bool operator==(const Lens&, const Lens&) = default;
};

// Throws InputError where the lens would fold the picture (r' must grow with r up to the corners)
// or turns it too far.
void check_lens(const Lens& lens, const std::string& what);

// What a camera with that lens sees of `image`, which is the scene without one.
[[nodiscard]] ByteImage through_lens(const ByteImage& image, const Lens& lens);
// The scene again: what rectification does.
[[nodiscard]] ByteImage without_lens(const ByteImage& image, const Lens& lens);

}  // namespace finback::scenes
