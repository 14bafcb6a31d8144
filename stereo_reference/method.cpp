#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <common/error.hpp>
#include <stereo_reference/fast_matching.hpp>
#include <stereo_reference/method.hpp>

namespace finback::stereo_reference {

namespace {

// At most 24 in a window of 5.
ByteImage rank_bytes(const ByteImage& image, int window) {
  const WordImage ranks = rank_transform(image, window);
  ByteImage bytes(ranks.width(), ranks.height());
  std::ranges::transform(ranks.pixels(), bytes.data(),
                         [](std::uint32_t rank) { return static_cast<std::uint8_t>(rank); });
  return bytes;
}

}  // namespace

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names = {"census3", "census5", "rank3", "rank5",
                                                 "sad",     "ssd",     "ncc"};
  return names;
}

const std::string& name_of(Method method) {
  return method_names()[static_cast<std::size_t>(method)];
}

Method parse_method(const std::string& name) {
  const auto found = std::ranges::find(method_names(), name);
  if (found == method_names().end()) {
    throw InputError(
        fmt::format("matching by '{}': it is one of {}", name, fmt::join(method_names(), ", ")));
  }
  return static_cast<Method>(found - method_names().begin());
}

DisparityPair match(Method method, const ByteImage& left, const ByteImage& right,
                    const MatchParameters& parameters) {
  // Before pictures that do not fit are transformed at length.
  check_match_arguments({left.width(), left.height()}, {right.width(), right.height()}, parameters);
  const auto ranked = [&](int window) {
    return match_bytes(Measure::sad, rank_bytes(left, window), rank_bytes(right, window),
                       parameters);
  };
  switch (method) {
    case Method::census3:
      return match_bytes(Measure::shd, census_3x3(left), census_3x3(right), parameters);
    case Method::census5:
      return match_by(Measure::shd, census_transform(left, 5), census_transform(right, 5),
                      parameters);
    case Method::rank3:
      return ranked(3);
    case Method::rank5:
      return ranked(5);
    case Method::sad:
      return match_bytes(Measure::sad, left, right, parameters);
    case Method::ssd:
      return match_by(Measure::ssd, as_words(left), as_words(right), parameters);
    case Method::ncc:
      break;
  }
  return match_by(Measure::ncc, as_words(left), as_words(right), parameters);
}

}  // namespace finback::stereo_reference
