#include <tuple>

#include <memory_model/code_cache.hpp>

namespace finback::memory {

void CodeCache::touch(Address address) {
  for (Way& way : set_of(address).ways) {
    if (way.last_use != 0 && way.line == line_of(address)) {
      way.last_use = ++uses_;
    }
  }
}

void CodeCache::fill(Address address, bool important) {
  Set& set = set_of(address);
  Way* victim = nullptr;
  for (std::size_t i = 0; i < kWays; ++i) {
    Way& way = set.ways[i];
    const auto worth = [](const Way& w) {
      return std::tuple(w.last_use != 0 && w.important, w.last_use);
    };
    if ((locked_ >> i & 1U) == 0 && (victim == nullptr || worth(way) < worth(*victim))) {
      victim = &way;
    }
  }
  if (victim != nullptr) {
    *victim = {.line = line_of(address), .last_use = ++uses_, .important = important};
  }
}

void CodeCache::forget(Address address) {
  for (Way& way : set_of(address).ways) {
    if (way.line == line_of(address)) {
      way.last_use = 0;
    }
  }
}

}  // namespace finback::memory
