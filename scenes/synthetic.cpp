#include <array>

#include <scenes/luma.hpp>
#include <scenes/scene.hpp>

namespace finback::scenes {

namespace {

constexpr int kStep = 4;  // VGA pixels from one pixel of 160x120 to the next

// A frontal rectangle in VGA columns and rows of the left view, the ends excluded.
struct Surface {
  int left;
  int top;
  int right;
  int bottom;
  int disparity;  // pixels of 160x120
  int speed = 0;  // VGA pixels a frame, of what moves

  [[nodiscard]] bool covers(int x, int y) const {
    return x >= left && x < right && y >= top && y < bottom;
  }
};

// From near to far. The floor's steps reach far beyond the image on both sides, so that the right
// view, which looks further to the right, sees no end of it.
constexpr std::array<Surface, 9> kSurfaces = {{
    {472, 64, 496, 400, 34, 4},    // the post
    {316, 200, 436, 360, 26, 8},   // hides part of the next box
    {200, 120, 356, 300, 20, -4},  //
    {512, 112, 616, 280, 15, 2},   //
    {-800, 400, 1440, 480, 14},    // the floor's nearest step
    {-800, 320, 1440, 400, 12},    //
    {-800, 240, 1440, 320, 10},    //
    {-800, 160, 1440, 240, 8},     //
    {-800, 0, 1440, 160, 6},       // and the wall behind it
}};

// A seeded hash with well mixed bits (the finaliser of MurmurHash3).
std::uint32_t mix(std::uint32_t value) {
  value ^= value >> 16U;
  value *= 0x85EBCA6BU;
  value ^= value >> 13U;
  value *= 0xC2B2AE35U;
  value ^= value >> 16U;
  return value;
}

// Brightness 0..255 of lattice point (x, y) of a surface.
int lattice(std::uint32_t seed, int x, int y) {
  const std::uint32_t row = mix(seed ^ (static_cast<std::uint32_t>(y) * 0x9E3779B9U));
  return static_cast<int>(mix(row ^ static_cast<std::uint32_t>(x)) & 255U);
}

// Value noise: random brightness on a lattice of 6 VGA pixels, linear between, so that the pixels
// of 160x120 differ from each other and the VGA picture stays smooth. Coordinates are shifted to
// be positive before the division.
int texture(std::uint32_t seed, int x, int y) {
  constexpr int kCell = 6;
  constexpr int kOffset = 1200 * kCell;
  const int column = (x + kOffset) / kCell;
  const int row = (y + kOffset) / kCell;
  const int fx = (x + kOffset) % kCell;
  const int fy = (y + kOffset) % kCell;
  const int upper = lattice(seed, column, row) * (kCell - fx) + lattice(seed, column + 1, row) * fx;
  const int lower =
      lattice(seed, column, row + 1) * (kCell - fx) + lattice(seed, column + 1, row + 1) * fx;
  return (upper * (kCell - fy) + lower * fy) / (kCell * kCell);
}

// What a view sees at (x, y); `shift` is 0 for the left view and 1 for the right one, whose pixel x
// shows a surface's point x + 4 d. The last surface covers what no other does.
struct Sight {
  int brightness;
  int disparity;
};

// How far a surface has moved in frame `frame`: to the side, back and to the other side.
int moved(int speed, std::uint32_t frame) {
  constexpr std::int64_t kFarthest = 96;
  const std::int64_t way = (std::int64_t{speed} * frame % (4 * kFarthest) + 5 * kFarthest) %
                           (4 * kFarthest);  // 0 at the left end
  return static_cast<int>(way < 2 * kFarthest ? way - kFarthest : 3 * kFarthest - way);
}

Sight look(std::uint32_t seed, std::uint32_t frame, int x, int y, int shift) {
  std::uint32_t number = 0;
  for (const Surface& surface : kSurfaces) {
    const int own_x = x + shift * kStep * surface.disparity - moved(surface.speed, frame);
    if (surface.covers(own_x, y)) {
      return {texture(mix(seed * 64U + number), own_x, y), surface.disparity};
    }
    ++number;
  }
  return {0, 0};
}

}  // namespace

Scene make_synthetic_scene(std::uint32_t seed, std::uint32_t frame) {
  Scene scene{"synthetic", ByteImage(kVgaWidth, kVgaHeight), ByteImage(kVgaWidth, kVgaHeight),
              FloatImage(kVgaWidth / kStep, kVgaHeight / kStep)};
  for (int y = 0; y < kVgaHeight; ++y) {
    for (int x = 0; x < kVgaWidth; ++x) {
      const Sight left = look(seed, frame, x, y, 0);
      scene.left.at(x, y) = static_cast<std::uint8_t>(left.brightness);
      scene.right.at(x, y) = static_cast<std::uint8_t>(look(seed, frame, x, y, 1).brightness);
      if (x % kStep == 0 && y % kStep == 0) {
        scene.truth.at(x / kStep, y / kStep) = static_cast<float>(left.disparity);
      }
    }
  }
  return scene;
}

}  // namespace finback::scenes
