// The side of the memory system that instruction caches use.
//
// Models: one line fill at a time, the word that is waited for first; fetches from the rest of the
// line wait for their words. Does not model: fetching ahead, the line that is on its way when
// control goes elsewhere (it is brought in whole). Source: Programming Reference, chapter 6.
#include <algorithm>

#include <memory_model/memory_system.hpp>

namespace finback::memory {

void MemorySystem::configure_code_cache(int core, bool on, std::uint32_t locked_ways) {
  CoreCache& cache = caches_[static_cast<std::size_t>(core)];
  if (on != cache.code.on()) {
    cache.code.configure(on);
    cache.code_fill = {};
  }
  cache.code.lock(locked_ways);
}

Cycles MemorySystem::cached_fetch(int core, Level level, Address address, std::uint32_t bytes,
                                  bool important, Cycles now) {
  CoreCache& cache = caches_[static_cast<std::size_t>(core)];
  if (cache.code.holds(address)) {
    ++cache.code_hits;
    cache.code.touch(address);
    if (now >= cache.code_fill.done() || line_of(address) != line_of(cache.code_critical)) {
      return 0;
    }
  } else {
    ++cache.code_misses;
    const Cycles start = std::max(now, cache.code_fill.done());
    cache.code_fill = line_fill(core, level, address, start);
    cache.code_critical = address;
    cache.code.fill(address, important);
  }
  const Cycles arrival = cache.code_fill.arrival(cache.code_critical, address + bytes - 1);
  return arrival > now + 1 ? arrival - now - 1 : 0;
}

void MemorySystem::forget_code(int core, Address address) {
  CodeCache& cache = caches_[static_cast<std::size_t>(core)].code;
  if (cache.on()) {
    cache.forget(address);
  }
}

}  // namespace finback::memory
