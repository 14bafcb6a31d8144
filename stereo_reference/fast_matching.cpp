#include <algorithm>
#include <limits>
#include <vector>

#include <common/error.hpp>
#include <stereo_reference/fast_matching.hpp>

namespace finback::stereo_reference {

namespace {

using Sum = std::uint16_t;
constexpr std::uint64_t kMostSum = std::numeric_limits<Sum>::max() - 1;  // the rest: "none yet"

struct Hamming {
  // Bits counted in pairs, fours and eights: as bytes, what vectors can do.
  static std::uint8_t of(std::uint8_t left, std::uint8_t right) {
    auto bits = static_cast<std::uint8_t>(left ^ right);
    bits = static_cast<std::uint8_t>(bits - ((bits >> 1U) & 0x55U));
    bits = static_cast<std::uint8_t>((bits & 0x33U) + ((bits >> 2U) & 0x33U));
    return static_cast<std::uint8_t>((bits + (bits >> 4U)) & 0x0fU);
  }
};

struct Difference {
  static std::uint8_t of(std::uint8_t left, std::uint8_t right) {
    return static_cast<std::uint8_t>(std::max(left, right) - std::min(left, right));
  }
};

// The best candidates of one row of both maps.
struct RowWinners {
  explicit RowWinners(std::size_t width)
      : best_left(width), best_right(width), left(width), right(width) {}

  void clear() {
    std::ranges::fill(best_left, std::numeric_limits<Sum>::max());
    std::ranges::fill(best_right, std::numeric_limits<Sum>::max());
    std::ranges::fill(left, Sum{0});
    std::ranges::fill(right, Sum{0});
  }

  std::vector<Sum> best_left;
  std::vector<Sum> best_right;
  std::vector<Sum> left;
  std::vector<Sum> right;
};

void keep_smaller(const Sum* sums, std::size_t count, Sum disparity, Sum* best, Sum* winners) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool better = sums[i] < best[i];
    best[i] = better ? sums[i] : best[i];
    winners[i] = better ? disparity : winners[i];
  }
}

template <class Cost>
class RowMatcher {
 public:
  RowMatcher(const ByteImage& left, const ByteImage& right, const MatchParameters& p)
      : left_(left),
        right_(right),
        p_(p),
        width_(static_cast<std::size_t>(left.width())),
        window_(static_cast<std::size_t>(p.window)),
        columns_(static_cast<std::size_t>(p.disparity_max - p.disparity_min + 1) * width_),
        sums_(width_),
        winners_(width_) {}

  DisparityPair run() {
    DisparityPair maps{ByteImage(left_.width(), left_.height()),
                       ByteImage(left_.width(), left_.height())};
    const int last = std::min(p_.disparity_max, left_.width() - p_.window);
    for (int row = 0; row < left_.height(); ++row) {
      winners_.clear();
      for (int d = p_.disparity_min; d <= last; ++d) {
        Sum* columns = &columns_[static_cast<std::size_t>(d - p_.disparity_min) * width_];
        take_row(row, static_cast<std::size_t>(d), columns);
        if (row >= p_.window - 1) {
          offer_row(static_cast<std::size_t>(d), columns);
        }
      }
      if (row >= p_.window - 1) {
        const int y = row - p_.half_window();
        std::ranges::transform(winners_.left, &maps.left.at(0, y), narrowed);
        std::ranges::transform(winners_.right, &maps.right.at(0, y), narrowed);
      }
    }
    return maps;
  }

 private:
  static std::uint8_t narrowed(Sum winner) { return static_cast<std::uint8_t>(winner); }

  // Sums over the window's height, of every column: one row comes in, one goes.
  void take_row(int row, std::size_t d, Sum* columns) const {
    const std::uint8_t* left = &left_.at(0, row);
    const std::uint8_t* right = &right_.at(0, row);
    for (std::size_t x = d; x < width_; ++x) {
      columns[x] = static_cast<Sum>(columns[x] + Cost::of(left[x], right[x - d]));
    }
    if (row < p_.window) {
      return;
    }
    left = &left_.at(0, row - p_.window);
    right = &right_.at(0, row - p_.window);
    for (std::size_t x = d; x < width_; ++x) {
      columns[x] = static_cast<Sum>(columns[x] - Cost::of(left[x], right[x - d]));
    }
  }

  // sums_[i] is that of the window which begins at left column d + i.
  void offer_row(std::size_t d, const Sum* columns) {
    const std::size_t count = width_ - window_ + 1 - d;
    Sum sum = 0;
    for (std::size_t x = d; x < d + window_; ++x) {
      sum = static_cast<Sum>(sum + columns[x]);
    }
    sums_[0] = sum;
    for (std::size_t i = 1; i < count; ++i) {
      sum = static_cast<Sum>(sum + columns[d + i + window_ - 1] - columns[d + i - 1]);
      sums_[i] = sum;
    }
    const auto disparity = static_cast<Sum>(d);
    const std::size_t n = window_ / 2;
    keep_smaller(sums_.data(), count, disparity, &winners_.best_left[n + d], &winners_.left[n + d]);
    keep_smaller(sums_.data(), count, disparity, &winners_.best_right[n], &winners_.right[n]);
  }

  const ByteImage& left_;
  const ByteImage& right_;
  const MatchParameters& p_;
  std::size_t width_;
  std::size_t window_;
  std::vector<Sum> columns_;  // a row for each disparity
  std::vector<Sum> sums_;
  RowWinners winners_;
};

std::uint64_t largest_sum(Measure measure, const ByteImage& left, const ByteImage& right,
                          const MatchParameters& p) {
  std::uint64_t most = 8;
  if (measure == Measure::sad) {
    most = std::max(*std::ranges::max_element(left.pixels()),
                    *std::ranges::max_element(right.pixels()));
  }
  return most * static_cast<std::uint64_t>(p.window) * static_cast<std::uint64_t>(p.window);
}

}  // namespace

DisparityPair match_bytes(Measure measure, const ByteImage& left, const ByteImage& right,
                          const MatchParameters& parameters) {
  check_match_arguments({left.width(), left.height()}, {right.width(), right.height()}, parameters);
  if (measure != Measure::shd && measure != Measure::sad) {
    throw InputError("matching of bytes: SHD and SAD are possible; NCC and SSD by match_by");
  }
  if (largest_sum(measure, left, right, parameters) > kMostSum) {
    return match_by(measure, as_words(left), as_words(right), parameters);
  }
  return measure == Measure::shd ? RowMatcher<Hamming>(left, right, parameters).run()
                                 : RowMatcher<Difference>(left, right, parameters).run();
}

}  // namespace finback::stereo_reference
