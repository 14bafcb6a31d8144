// One scene of table 8 under many readings: each map is made and judged once.
#include <cmath>
#include <map>
#include <tuple>

#include <stereo_reference/evaluation.hpp>
#include <stereo_reference/fast_matching.hpp>
#include <stereo_reference/masks.hpp>
#include <stereo_reference/table8.hpp>
#include <stereo_reference/texture.hpp>

namespace finback::stereo_reference {

namespace {

// What a pixel is, as bits: regions of all readings are made of them.
constexpr unsigned kOccluded = 1;
constexpr unsigned kFlat = 2;         // A.22
constexpr unsigned kLowVariance = 4;  // equation 19's
constexpr unsigned kGapOfPixels = 8;
constexpr unsigned kGapOfGreys = 16;
constexpr unsigned kKinds = 32;

constexpr double kTextureThreshold = 135;  // T_L
constexpr double kGap = 3;
constexpr int kMaskWindow = 9;
constexpr std::size_t kRules = 3;

// The map that a reading looks at.
struct MapKey {
  int window = 0;
  bool whole_range = false;
  int consistency = -1;             // -1: not checked
  double disparity_threshold = -1;  // -1: not post-processed
  bool either = false;

  friend bool operator<(const MapKey& a, const MapKey& b) {
    return std::tie(a.window, a.whole_range, a.consistency, a.disparity_threshold, a.either) <
           std::tie(b.window, b.whole_range, b.consistency, b.disparity_threshold, b.either);
  }
};

struct Tally {
  int compared = 0;
  int invalid = 0;
  std::array<int, kRules> bad{};          // by rule, invalid ones too
  std::array<int, kRules> invalid_bad{};  // of these, the invalid ones

  Tally& operator+=(const Tally& other) {
    compared += other.compared;
    invalid += other.invalid;
    for (std::size_t i = 0; i < kRules; ++i) {
      bad[i] += other.bad[i];
      invalid_bad[i] += other.invalid_bad[i];
    }
    return *this;
  }
};
using Tallies = std::array<Tally, kKinds>;

std::array<bool, kRules> judge(int disparity, int grey, int scale) {
  const int error = std::abs(disparity * scale - grey);
  return {error > 1, error > scale, std::abs(disparity - grey / scale) > 1};
}

bool belongs(unsigned kind, TableRegion region, const Reading& reading) {
  const auto is = [kind](unsigned bit) { return (kind & bit) != 0; };
  const bool seen = !is(kOccluded);
  switch (region) {
    case TableRegion::all:
      return true;
    case TableRegion::non_occluded:
      return seen;
    case TableRegion::texture_less:
      return (seen || reading.hidden_counts) &&
             is(reading.variance_is_texture ? kLowVariance : kFlat);
    case TableRegion::discontinuous:
      break;
  }
  return (seen || reading.hidden_counts) && is(reading.gap_in_greys ? kGapOfGreys : kGapOfPixels);
}

class Scene {
 public:
  Scene(const StereoSample& sample, float scale)
      : sample_(sample),
        scale_(static_cast<int>(scale)),
        left_(census_3x3(sample.left)),
        right_(census_3x3(sample.right)),
        kinds_(sample.left.width(), sample.left.height()) {
    mark(occluded_mask(sample.left_truth, sample.right_truth), kOccluded);
    mark(textureless_mask(sample.left), kFlat);
    mark(discontinuity_mask(sample.left_truth, kMaskWindow, kGap), kGapOfPixels);
    mark(discontinuity_mask(sample.left_truth, kMaskWindow, kGap / scale_ + kRounding),
         kGapOfGreys);
    const auto variances = variance_map(sample.left, kMaskWindow);
    for (int y = 0; y < kinds_.height(); ++y) {
      for (int x = 0; x < kinds_.width(); ++x) {
        kinds_.at(x, y) |= variances.at(x, y) <= kTextureThreshold ? kLowVariance : 0U;
      }
    }
  }

  SceneFigures figures(const Reading& reading) {
    const MapKey matched{reading.window, reading.whole_range};
    MapKey checked = matched;
    checked.consistency = reading.consistency;
    MapKey post_processed = checked;
    post_processed.disparity_threshold = reading.disparity_threshold;
    post_processed.either = reading.either;
    SceneFigures result;
    std::size_t stage = 0;
    for (const MapKey& key : {matched, checked, post_processed}) {
      const Tallies& tallies = tallies_of(key);
      for (std::size_t region = 0; region < kTableRegions; ++region) {
        result[region][stage] = percent(tallies, static_cast<TableRegion>(region), reading);
      }
      ++stage;
    }
    return result;
  }

 private:
  // Thirds of a pixel are no binary fractions.
  static constexpr double kRounding = 1e-4;

  void mark(const ByteImage& mask, unsigned kind) {
    for (int y = 0; y < mask.height(); ++y) {
      for (int x = 0; x < mask.width(); ++x) {
        kinds_.at(x, y) |= mask.at(x, y) != 0 ? kind : 0U;
      }
    }
  }

  static std::optional<double> percent(const Tallies& tallies, TableRegion region,
                                       const Reading& reading) {
    Tally sum;
    for (unsigned kind = 0; kind < kKinds; ++kind) {
      if (belongs(kind, region, reading)) {
        sum += tallies[kind];
      }
    }
    const auto rule = static_cast<std::size_t>(reading.bad);
    const int left_out = reading.invalid_is_bad ? 0 : sum.invalid;
    const int bad = sum.bad[rule] - (reading.invalid_is_bad ? 0 : sum.invalid_bad[rule]);
    if (sum.compared == left_out) {
      return std::nullopt;
    }
    return 100.0 * bad / (sum.compared - left_out);
  }

  const DisparityPair& matched(const MapKey& key) {
    const auto [place, added] = pairs_.try_emplace({key.window, key.whole_range});
    if (added) {
      const MatchParameters parameters{key.window, 1, sample_.largest_disparity()};
      place->second = match_bytes(Measure::shd, left_, right_, parameters);
      if (key.whole_range) {
        cut_to_whole_range(place->second, parameters);
      }
    }
    return place->second;
  }

  // The listings compute a pixel only where its largest disparity has a candidate, too.
  static void cut_to_whole_range(DisparityPair& maps, const MatchParameters& parameters) {
    const int border = parameters.half_window() + parameters.disparity_max;
    const int width = maps.left.width();
    for (int y = 0; y < maps.left.height(); ++y) {
      for (int x = 0; x < std::min(border, width); ++x) {
        maps.left.at(x, y) = 0;
        maps.right.at(width - 1 - x, y) = 0;
      }
    }
  }

  ByteImage map_of(const MapKey& key) {
    const DisparityPair& pair = matched(key);
    if (key.consistency < 0) {
      return pair.left;
    }
    ByteImage map = check_left_right(pair, key.consistency);
    if (key.disparity_threshold < 0) {
      return map;
    }
    return post_process(map, sample_.left,
                        {kMaskWindow, kTextureThreshold, key.disparity_threshold, key.either});
  }

  const Tallies& tallies_of(const MapKey& key) {
    const auto [place, added] = tallies_.try_emplace(key);
    if (added) {
      place->second =
          tally(map_of(key), inner_region(kinds_.width(), kinds_.height(), key.window / 2));
    }
    return place->second;
  }

  [[nodiscard]] Tallies tally(const ByteImage& map, const Region& region) const {
    Tallies tallies;
    for (int y = region.top; y < region.bottom; ++y) {
      for (int x = region.left; x < region.right; ++x) {
        const auto grey =
            static_cast<int>(std::lround(sample_.left_truth.at(x, y) * static_cast<float>(scale_)));
        if (grey == 0) {
          continue;
        }
        const int disparity = map.at(x, y);
        const auto bad = judge(disparity, grey, scale_);
        Tally& kind = tallies[kinds_.at(x, y)];
        ++kind.compared;
        kind.invalid += disparity == 0 ? 1 : 0;
        for (std::size_t rule = 0; rule < kRules; ++rule) {
          kind.bad[rule] += bad[rule] ? 1 : 0;
          kind.invalid_bad[rule] += bad[rule] && disparity == 0 ? 1 : 0;
        }
      }
    }
    return tallies;
  }

  const StereoSample& sample_;
  int scale_;
  ByteImage left_;  // census
  ByteImage right_;
  scenes::Image<unsigned> kinds_;
  std::map<std::pair<int, bool>, DisparityPair> pairs_;
  std::map<MapKey, Tallies> tallies_;
};

}  // namespace

std::vector<SceneFigures> measure_scene(const StereoSample& sample, float scale,
                                        const std::vector<Reading>& readings) {
  Scene scene(sample, scale);
  std::vector<SceneFigures> figures;
  figures.reserve(readings.size());
  for (const Reading& reading : readings) {
    figures.push_back(scene.figures(reading));
  }
  return figures;
}

}  // namespace finback::stereo_reference
