// Pairs (name, number) as one JSON object.
#pragma once

#include <nlohmann/json.hpp>

namespace finback::report {

template <class Pairs>
[[nodiscard]] nlohmann::ordered_json named_numbers(const Pairs& pairs) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (const auto& [name, number] : pairs) {
    object[name] = number;
  }
  return object;
}

}  // namespace finback::report
