#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include <common/error.hpp>
#include <common/parameter.hpp>

namespace finback {

ParameterBase::ParameterBase(ParameterGroup* group, const ParameterDeclaration& declaration,
                             bool is_integer)
    : declaration_(declaration), is_integer_(is_integer) {
  group->parameters_.push_back(this);
}

void ParameterBase::set(double value) {
  const ParameterDeclaration& d = declaration_;
  if (!(value >= d.minimum && value <= d.maximum)) {
    throw InputError(fmt::format("{} = {} is out of range: it takes {} to {} {}", d.name, value,
                                 d.minimum, d.maximum, d.unit));
  }
  if (is_integer_ && value != std::floor(value)) {
    throw InputError(
        fmt::format("{} = {} has a fraction: it takes whole numbers of {}", d.name, value, d.unit));
  }
  store(value);
}

namespace {

std::size_t edit_distance(std::string_view left, std::string_view right) {
  std::vector<std::size_t> row(right.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < left.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < right.size(); ++j) {
      const std::size_t substituted = diagonal + (left[i] == right[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(3, name.size() / 3) + 1;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace finback
