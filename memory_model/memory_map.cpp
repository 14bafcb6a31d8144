#include <algorithm>

#include <memory_model/memory_map.hpp>

namespace finback::memory {

const Region* MemoryMap::find(Address address) const {
  const auto next =
      std::upper_bound(regions.begin(), regions.end(), address,
                       [](Address wanted, const Region& region) { return wanted < region.base; });
  if (next == regions.begin() || !std::prev(next)->contains(address)) {
    return nullptr;
  }
  return &*std::prev(next);
}

const Region* MemoryMap::find(int core, std::string_view name) const {
  const auto found = std::find_if(regions.begin(), regions.end(), [&](const Region& region) {
    return region.name == name && (region.core == core || region.core == -1);
  });
  return found == regions.end() ? nullptr : &*found;
}

std::vector<std::string> MemoryMap::names(int core) const {
  std::vector<std::string> known;
  for (const Region& region : regions) {
    if (region.core == -1 || region.core == core) {
      known.push_back(region.name);
    }
  }
  return known;
}

namespace {

constexpr std::uint32_t kKilobyte = 1024;

Region make_region(const char* name, Address base, std::uint32_t kilobytes, Level level, int core) {
  Region region;
  region.name = name;
  region.base = base;
  region.size = kilobytes * kKilobyte;
  region.level = level;
  region.core = core;
  return region;
}

void add_l1(MemoryMap& map, int core, Address base) {
  const auto add = [&](const char* name, Address offset, std::uint32_t kilobytes) -> Region& {
    map.regions.push_back(make_region(name, base + offset, kilobytes, Level::l1, core));
    return map.regions.back();
  };
  const auto add_data = [&](const char* name, Address offset) {
    Region& bank = add(name, offset, 32);
    bank.data = true;
    bank.cache_bytes = 16 * kKilobyte;
  };
  add_data("l1.data.a", 0);
  add_data("l1.data.b", 0x100000);
  add("l1.code", 0x200000, 16).code = true;
  Region& code = add("l1.code.cache", 0x210000, 16);
  code.code = true;
  code.cache_bytes = code.size;
  Region& scratch = add("l1.scratch", 0x300000, 4);
  scratch.data = true;
  scratch.dma_reachable = false;
}

}  // namespace

MemoryMap bf561_map() {
  MemoryMap map;
  map.regions.push_back(make_region("l3", 0, 64 * 1024, Level::l3, -1));
  map.regions.push_back(make_region("flash", 0x20000000, 8 * 1024, Level::l3, -1));
  map.regions.back().read_only = true;
  map.regions.push_back(make_region("l2", 0xFEB00000, 128, Level::l2, -1));
  for (Region& region : map.regions) {
    region.code = true;
    region.data = true;
  }
  add_l1(map, 1, 0xFF400000);
  add_l1(map, 0, 0xFF800000);
  return map;
}

}  // namespace finback::memory
