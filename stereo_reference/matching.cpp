#include <bit>
#include <cstdlib>
#include <fmt/format.h>
#include <limits>
#include <vector>

#include <common/error.hpp>
#include <stereo_reference/matching.hpp>

namespace finback::stereo_reference {

namespace {

int hamming_distance(std::uint8_t left, std::uint8_t right) {
  return std::popcount(static_cast<unsigned>(left ^ right));
}

ImageSize size_of(const ByteImage& image) { return {image.width(), image.height()}; }

// Whether the windows of left x and right x - d both lie inside the rows.
bool is_candidate(int x, int disparity, int width, int half_window) {
  return x - disparity >= half_window && x <= width - 1 - half_window;
}

int window_score(const ByteImage& left, const ByteImage& right, int x, int y, int disparity,
                 int half_window) {
  int score = 0;
  for (int row = y - half_window; row <= y + half_window; ++row) {
    for (int column = x - half_window; column <= x + half_window; ++column) {
      score += hamming_distance(left.at(column, row), right.at(column - disparity, row));
    }
  }
  return score;
}

// Plain matching of either view; `side` is the factor of d from a pixel of the map to its left x.
ByteImage match_plain(const ByteImage& left, const ByteImage& right,
                      const MatchParameters& parameters, int side) {
  check_match_arguments(size_of(left), size_of(right), parameters);
  const int n = parameters.half_window();
  ByteImage map(left.width(), left.height());
  for (int y = n; y < left.height() - n; ++y) {
    for (int x = 0; x < left.width(); ++x) {
      int best_score = std::numeric_limits<int>::max();
      for (int d = parameters.disparity_min; d <= parameters.disparity_max; ++d) {
        const int left_x = x + side * d;
        if (!is_candidate(left_x, d, left.width(), n)) {
          continue;
        }
        const int score = window_score(left, right, left_x, y, d, n);
        if (score < best_score) {
          best_score = score;
          map.at(x, y) = static_cast<std::uint8_t>(d);
        }
      }
    }
  }
  return map;
}

// The state of the recursive matcher: scores of one row of windows, updated from row to row.
//
// With h(x, y, d) the Hamming distance at left x and right x - d, the window centred on (x, y) is
// reached from the one above by U, the sum over the window's columns of what enters below minus
// what leaves above; U moves to the right by the column that enters minus the one that leaves,
// and the leaving one is what entered 2n + 1 columns ago, kept in M.
class RecursiveMatcher {
 public:
  RecursiveMatcher(const ByteImage& left, const ByteImage& right, const MatchParameters& parameters)
      : left_(left),
        right_(right),
        parameters_(parameters),
        disparities_(parameters.disparity_max - parameters.disparity_min + 1),
        scores_(disparities_, left.width()),
        update_(disparities_, 1),
        modular_(disparities_, parameters.window) {}

  // Takes image row `row` into the windows and drops the one `window` rows above it.
  void enter_row(int row) {
    update_ = scenes::Image<int>(disparities_, 1);
    modular_ = scenes::Image<int>(disparities_, parameters_.window);
    for (int column = 0; column < left_.width(); ++column) {
      const int centre = column - parameters_.half_window();
      for (int k = 0; k < disparities_; ++k) {
        const int d = parameters_.disparity_min + k;
        int& oldest = modular_.at(k, column % parameters_.window);
        const int newest = distance(column, row, d) - distance(column, row - parameters_.window, d);
        update_.at(k, 0) += newest - oldest;
        oldest = newest;
        if (centre >= 0) {
          scores_.at(k, centre) += update_.at(k, 0);
        }
      }
    }
  }

  // The winners of both views on row y, whose windows must be complete.
  void select(int y, DisparityPair& maps) {
    const int width = left_.width();
    std::vector<int> best_left(static_cast<std::size_t>(width), std::numeric_limits<int>::max());
    std::vector<int> best_right = best_left;
    for (int x = 0; x < width; ++x) {
      for (int k = 0; k < disparities_; ++k) {
        const int d = parameters_.disparity_min + k;
        if (!is_candidate(x, d, width, parameters_.half_window())) {
          continue;
        }
        keep_smaller(scores_.at(k, x), d, best_left[static_cast<std::size_t>(x)],
                     maps.left.at(x, y));
        keep_smaller(scores_.at(k, x), d, best_right[static_cast<std::size_t>(x - d)],
                     maps.right.at(x - d, y));
      }
    }
  }

 private:
  // Rising x and d reach the candidates of either view in the order of rising d.
  static void keep_smaller(int score, int disparity, int& best, std::uint8_t& winner) {
    if (score < best) {
      best = score;
      winner = static_cast<std::uint8_t>(disparity);
    }
  }

  // 0 outside the images: such scores belong to no candidate, and the recursions drop exactly
  // what they took in.
  [[nodiscard]] int distance(int x, int y, int disparity) const {
    return y < 0 || x < disparity ? 0
                                  : hamming_distance(left_.at(x, y), right_.at(x - disparity, y));
  }

  const ByteImage& left_;
  const ByteImage& right_;
  const MatchParameters& parameters_;
  int disparities_;
  // Column k stands for disparity disparity_min + k.
  scenes::Image<int> scores_;   // S, a row for each x
  scenes::Image<int> update_;   // U, one row
  scenes::Image<int> modular_;  // M, a row for each x mod window
};

}  // namespace

void check_match_arguments(const ImageSize& left, const ImageSize& right,
                           const MatchParameters& parameters) {
  if (left != right) {
    throw InputError(fmt::format(
        "stereo pair: the left image is {}x{}, the right one {}x{}; both must have the same size",
        left.width, left.height, right.width, right.height));
  }
  const auto& p = parameters;
  if (p.window < 1 || p.window > 255 || p.window % 2 == 0) {
    throw InputError(
        fmt::format("matching window {}: it must be an odd number from 1 to 255", p.window));
  }
  if (p.disparity_min < 1 || p.disparity_max > 255 || p.disparity_min > p.disparity_max) {
    throw InputError(fmt::format(
        "disparities {}..{}: they must lie in 1..255 (0 marks invalid pixels), the smaller first",
        p.disparity_min, p.disparity_max));
  }
  if (left.height < p.window || left.width < p.window + p.disparity_min) {
    throw InputError(fmt::format(
        "stereo pair of {}x{}: too small for a window of {} at disparity {}; at least {}x{} needed",
        left.width, left.height, p.window, p.disparity_min, p.window + p.disparity_min, p.window));
  }
}

Region computed_region(int width, int height, const MatchParameters& parameters) {
  const int n = parameters.half_window();
  return {n + parameters.disparity_min, n, width - n, height - n};
}

ByteImage census_3x3(const ByteImage& image) {
  if (image.empty()) {
    throw InputError("census transform: the image is empty");
  }
  ByteImage census(image.width(), image.height());
  for (int y = 1; y < image.height() - 1; ++y) {
    for (int x = 1; x < image.width() - 1; ++x) {
      unsigned bits = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (dx == 0 && dy == 0) {
            continue;
          }
          bits = bits << 1U | (image.at(x + dx, y + dy) < image.at(x, y) ? 1U : 0U);
        }
      }
      census.at(x, y) = static_cast<std::uint8_t>(bits);
    }
  }
  return census;
}

ByteImage match_left_plain(const ByteImage& left_census, const ByteImage& right_census,
                           const MatchParameters& parameters) {
  return match_plain(left_census, right_census, parameters, 0);
}

ByteImage match_right_plain(const ByteImage& left_census, const ByteImage& right_census,
                            const MatchParameters& parameters) {
  return match_plain(left_census, right_census, parameters, 1);
}

DisparityPair match_recursive(const ByteImage& left_census, const ByteImage& right_census,
                              const MatchParameters& parameters) {
  check_match_arguments(size_of(left_census), size_of(right_census), parameters);
  const int width = left_census.width();
  const int height = left_census.height();
  DisparityPair maps{ByteImage(width, height), ByteImage(width, height)};
  RecursiveMatcher matcher(left_census, right_census, parameters);
  for (int row = 0; row < height; ++row) {
    matcher.enter_row(row);
    if (row >= parameters.window - 1) {
      matcher.select(row - parameters.half_window(), maps);
    }
  }
  return maps;
}

ByteImage check_left_right(const DisparityPair& maps, int threshold) {
  if (maps.left.width() != maps.right.width() || maps.left.height() != maps.right.height()) {
    throw InputError(fmt::format(
        "left-right check: the left map is {}x{}, the right one {}x{}; both must have "
        "the same size",
        maps.left.width(), maps.left.height(), maps.right.width(), maps.right.height()));
  }
  if (threshold < 0) {
    throw InputError(fmt::format("left-right check: threshold {} must not be negative", threshold));
  }
  ByteImage checked(maps.left.width(), maps.left.height());
  for (int y = 0; y < checked.height(); ++y) {
    for (int x = 0; x < checked.width(); ++x) {
      const int d = maps.left.at(x, y);
      if (d == 0 || d > x) {
        continue;
      }
      const int opposite = maps.right.at(x - d, y);
      if (opposite != 0 && std::abs(opposite - d) <= threshold) {
        checked.at(x, y) = static_cast<std::uint8_t>(d);
      }
    }
  }
  return checked;
}

ByteImage disparity_map(const ByteImage& left, const ByteImage& right,
                        const MatchParameters& parameters, int threshold) {
  return check_left_right(match_recursive(census_3x3(left), census_3x3(right), parameters),
                          threshold);
}

ByteImage subsample_by_4(const ByteImage& image) {
  if (image.empty()) {
    throw InputError("sub-sampling: the image is empty");
  }
  ByteImage small((image.width() + 3) / 4, (image.height() + 3) / 4);
  for (int y = 0; y < small.height(); ++y) {
    for (int x = 0; x < small.width(); ++x) {
      small.at(x, y) = image.at(4 * x, 4 * y);
    }
  }
  return small;
}

}  // namespace finback::stereo_reference
