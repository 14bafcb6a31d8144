#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include <common/error.hpp>
#include <stereo_reference/masks.hpp>

namespace finback::stereo_reference {

namespace {

constexpr std::uint8_t kInside = 255;

void check(int width, int height, int window, double threshold, const char* what) {
  if (width < 1 || height < 1) {
    throw InputError(fmt::format("{}: the picture is empty", what));
  }
  if (window < 1 || window % 2 == 0) {
    throw InputError(fmt::format("{}: window {}: it must be an odd number from 1", what, window));
  }
  if (!(threshold > 0)) {
    throw InputError(fmt::format("{}: threshold {} must be positive", what, threshold));
  }
}

// Sums over rectangles in four look-ups.
class SummedArea {
 public:
  explicit SummedArea(const scenes::Image<std::int64_t>& values)
      : sums_(values.width() + 1, values.height() + 1) {
    for (int y = 0; y < values.height(); ++y) {
      for (int x = 0; x < values.width(); ++x) {
        sums_.at(x + 1, y + 1) =
            values.at(x, y) + sums_.at(x, y + 1) + sums_.at(x + 1, y) - sums_.at(x, y);
      }
    }
  }

  // Sum and size of the window of half side n around (x, y), cut off at the edges.
  struct Part {
    std::int64_t sum = 0;
    std::int64_t count = 0;
  };
  [[nodiscard]] Part around(int x, int y, int n) const {
    const int left = std::max(x - n, 0);
    const int top = std::max(y - n, 0);
    const int right = std::min(x + n + 1, sums_.width() - 1);
    const int bottom = std::min(y + n + 1, sums_.height() - 1);
    return {sums_.at(right, bottom) - sums_.at(left, bottom) - sums_.at(right, top) +
                sums_.at(left, top),
            std::int64_t{right - left} * (bottom - top)};
  }

 private:
  scenes::Image<std::int64_t> sums_;
};

template <class Inside>
ByteImage mask_of(int width, int height, const Inside& inside) {
  ByteImage mask(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      mask.at(x, y) = inside(x, y) ? kInside : 0;
    }
  }
  return mask;
}

}  // namespace

ByteImage occluded_mask(const FloatImage& left, const FloatImage& right, double threshold) {
  if (left.width() != right.width() || left.height() != right.height()) {
    throw InputError(
        fmt::format("occluded regions: the left map is {}x{}, the right one {}x{}; "
                    "both must have the same size",
                    left.width(), left.height(), right.width(), right.height()));
  }
  check(left.width(), left.height(), 1, threshold, "occluded regions");
  return mask_of(left.width(), left.height(), [&](int x, int y) {
    const double disparity = left.at(x, y);
    const int opposite = static_cast<int>(std::lround(x - disparity));
    if (disparity == 0 || opposite < 0 || opposite >= left.width()) {
      return true;
    }
    const double back = right.at(opposite, y);
    return back == 0 || std::abs(back - disparity) > threshold;
  });
}

ByteImage occluded_mask(const FloatImage& left, double threshold) {
  const int width = left.width();
  check(width, left.height(), 1, threshold, "occluded regions");
  // The largest disparity that lands on each pixel of the right view.
  FloatImage nearest(width, left.height());
  const auto landing = [&](int x, int y) {
    return static_cast<int>(std::lround(x - double{left.at(x, y)}));
  };
  for (int y = 0; y < left.height(); ++y) {
    for (int x = 0; x < width; ++x) {
      const int place = landing(x, y);
      if (place >= 0 && place < width) {
        nearest.at(place, y) = std::max(nearest.at(place, y), left.at(x, y));
      }
    }
  }
  return mask_of(width, left.height(), [&](int x, int y) {
    const int place = landing(x, y);
    return left.at(x, y) == 0 || place < 0 || place >= width ||
           double{nearest.at(place, y)} - double{left.at(x, y)} > threshold;
  });
}

ByteImage discontinuity_mask(const FloatImage& disparity, int window, double gap) {
  const int width = disparity.width();
  const int height = disparity.height();
  check(width, height, window, gap, "depth discontinuities");
  scenes::Image<std::int64_t> edges(width, height);
  const auto step = [&](int x, int y, int other_x, int other_y) {
    const float here = disparity.at(x, y);
    const float there = disparity.at(other_x, other_y);
    if (here != 0 && there != 0 && std::abs(double{here} - double{there}) > gap) {
      edges.at(x, y) = edges.at(other_x, other_y) = 1;
    }
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width) {
        step(x, y, x + 1, y);
      }
      if (y + 1 < height) {
        step(x, y, x, y + 1);
      }
    }
  }
  const SummedArea sums(edges);
  return mask_of(width, height,
                 [&](int x, int y) { return sums.around(x, y, window / 2).sum > 0; });
}

ByteImage textureless_mask(const ByteImage& image, int window, double threshold) {
  const int width = image.width();
  const int height = image.height();
  check(width, height, window, threshold, "texture-less regions");
  scenes::Image<std::int64_t> gradients(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x + 1 < width; ++x) {
      const int difference = int{image.at(x, y)} - int{image.at(x + 1, y)};
      const std::int64_t squared = std::int64_t{difference} * difference;
      gradients.at(x, y) = std::max(gradients.at(x, y), squared);
      gradients.at(x + 1, y) = squared;
    }
  }
  const SummedArea sums(gradients);
  return mask_of(width, height, [&](int x, int y) {
    const SummedArea::Part part = sums.around(x, y, window / 2);
    return static_cast<double>(part.sum) < threshold * threshold * static_cast<double>(part.count);
  });
}

}  // namespace finback::stereo_reference
