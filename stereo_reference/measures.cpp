#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <vector>

#include <common/error.hpp>
#include <stereo_reference/measures.hpp>

namespace finback::stereo_reference {

namespace {

// What a measure sums over a window, and how good a sum is: the smaller, the better.
struct Sad {
  using Sum = std::uint64_t;
  static Sum of(std::uint32_t left, std::uint32_t right) {
    return left < right ? right - left : left - right;
  }
  static double badness(Sum sum) { return static_cast<double>(sum); }
};

struct Ssd {
  using Sum = std::uint64_t;
  static Sum of(std::uint32_t left, std::uint32_t right) {
    const Sum difference = Sad::of(left, right);
    return difference * difference;
  }
  static double badness(Sum sum) { return static_cast<double>(sum); }
};

struct Shd {
  using Sum = std::uint64_t;
  static Sum of(std::uint32_t left, std::uint32_t right) {
    return static_cast<Sum>(std::popcount(left ^ right));
  }
  static double badness(Sum sum) { return static_cast<double>(sum); }
};

struct Ncc {
  struct Sum {
    std::uint64_t both = 0;
    std::uint64_t left = 0;
    std::uint64_t right = 0;
    Sum& operator+=(const Sum& other) {
      both += other.both;
      left += other.left;
      right += other.right;
      return *this;
    }
    Sum& operator-=(const Sum& other) {
      both -= other.both;
      left -= other.left;
      right -= other.right;
      return *this;
    }
  };
  static Sum of(std::uint32_t left, std::uint32_t right) {
    const std::uint64_t l = left;
    const std::uint64_t r = right;
    return {l * r, l * l, r * r};
  }
  static double badness(const Sum& sum) {
    const double light = static_cast<double>(sum.left) * static_cast<double>(sum.right);
    return light == 0 ? 0 : -static_cast<double>(sum.both) / std::sqrt(light);
  }
};

// The best candidate so far of every pixel of both maps. Candidates come by rising disparity.
class Winners {
 public:
  Winners(int width, int height)
      : maps{ByteImage(width, height), ByteImage(width, height)},
        left_(width, height, std::numeric_limits<double>::infinity()),
        right_(left_) {}

  void offer(int x, int y, int disparity, double badness) {
    keep(badness, disparity, left_.at(x, y), maps.left.at(x, y));
    keep(badness, disparity, right_.at(x - disparity, y), maps.right.at(x - disparity, y));
  }

  DisparityPair maps;

 private:
  static void keep(double badness, int disparity, double& best, std::uint8_t& winner) {
    if (badness < best) {
      best = badness;
      winner = static_cast<std::uint8_t>(disparity);
    }
  }

  scenes::Image<double> left_;
  scenes::Image<double> right_;
};

void check(Measure measure, const WordImage& left, const WordImage& right,
           const MatchParameters& parameters) {
  check_match_arguments({left.width(), left.height()}, {right.width(), right.height()}, parameters);
  constexpr std::uint32_t kMost = 65535;  // squares over a window of 255 x 255 stay in 64 bits
  if (measure == Measure::ssd || measure == Measure::ncc) {
    for (const WordImage* image : {&left, &right}) {
      const std::uint32_t largest =
          *std::max_element(image->pixels().begin(), image->pixels().end());
      if (largest > kMost) {
        throw InputError(
            fmt::format("matching: a value of {}; squares take up to {}", largest, kMost));
      }
    }
  }
}

template <class M>
DisparityPair match_plain(const WordImage& left, const WordImage& right, const MatchParameters& p) {
  const int n = p.half_window();
  Winners winners(left.width(), left.height());
  for (int d = p.disparity_min; d <= p.disparity_max; ++d) {
    for (int y = n; y < left.height() - n; ++y) {
      for (int x = n + d; x < left.width() - n; ++x) {
        typename M::Sum sum{};
        for (int row = y - n; row <= y + n; ++row) {
          for (int column = x - n; column <= x + n; ++column) {
            sum += M::of(left.at(column, row), right.at(column - d, row));
          }
        }
        winners.offer(x, y, d, M::badness(sum));
      }
    }
  }
  return std::move(winners.maps);
}

// Sums of one disparity: columns of the window's height go down row by row, the window goes along
// them.
template <class M>
void match_disparity(const WordImage& left, const WordImage& right, const MatchParameters& p, int d,
                     Winners& winners) {
  const int n = p.half_window();
  std::vector<typename M::Sum> columns(static_cast<std::size_t>(left.width()));
  for (int row = 0; row < left.height(); ++row) {
    const int leaving = row - p.window;
    for (int x = d; x < left.width(); ++x) {
      typename M::Sum& column = columns[static_cast<std::size_t>(x)];
      column += M::of(left.at(x, row), right.at(x - d, row));
      if (leaving >= 0) {
        column -= M::of(left.at(x, leaving), right.at(x - d, leaving));
      }
    }
    if (row < p.window - 1) {
      continue;
    }
    typename M::Sum sum{};
    for (int x = d; x < left.width(); ++x) {
      sum += columns[static_cast<std::size_t>(x)];
      if (x - p.window >= d) {
        sum -= columns[static_cast<std::size_t>(x - p.window)];
      }
      if (x - d >= p.window - 1) {
        winners.offer(x - n, row - n, d, M::badness(sum));
      }
    }
  }
}

template <class M>
DisparityPair match_fast(const WordImage& left, const WordImage& right, const MatchParameters& p) {
  Winners winners(left.width(), left.height());
  for (int d = p.disparity_min; d <= p.disparity_max; ++d) {
    match_disparity<M>(left, right, p, d, winners);
  }
  return std::move(winners.maps);
}

// Calls `act` with the measure's type.
template <class Act>
DisparityPair with_measure(Measure measure, const Act& act) {
  switch (measure) {
    case Measure::sad:
      return act(Sad{});
    case Measure::ssd:
      return act(Ssd{});
    case Measure::ncc:
      return act(Ncc{});
    case Measure::shd:
      break;
  }
  return act(Shd{});
}

}  // namespace

DisparityPair match_by_plain(Measure measure, const WordImage& left, const WordImage& right,
                             const MatchParameters& parameters) {
  check(measure, left, right, parameters);
  return with_measure(measure,
                      [&](auto m) { return match_plain<decltype(m)>(left, right, parameters); });
}

DisparityPair match_by(Measure measure, const WordImage& left, const WordImage& right,
                       const MatchParameters& parameters) {
  check(measure, left, right, parameters);
  return with_measure(measure,
                      [&](auto m) { return match_fast<decltype(m)>(left, right, parameters); });
}

}  // namespace finback::stereo_reference
