#include <memory_model/data_cache.hpp>

namespace finback::memory {

void DataCache::configure(int banks, bool high_select) {
  banks_ = banks;
  select_bit_ = high_select ? 23 : 14;
  sets_.assign(static_cast<std::size_t>(banks) * kSetsPerBank, Set{});
}

CacheLine& DataCache::victim(Address address) {
  Set& set = set_of(address);
  for (CacheLine& line : set.ways) {
    if (!line.valid) {
      return line;
    }
  }
  return set.ways[set.oldest];
}

}  // namespace finback::memory
