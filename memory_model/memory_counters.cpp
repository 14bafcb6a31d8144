// What the memory system counted, by level and by object, out of the counts of its spans.
#include <fmt/format.h>

#include <memory_model/memory_system.hpp>

namespace finback::memory {

namespace {

// A window's direct accesses, counted by log2 of their size.
Traffic direct(const std::array<std::uint64_t, 3>& by_size) {
  return {.accesses = by_size[0] + by_size[1] + by_size[2],
          .bytes = by_size[0] + 2 * by_size[1] + 4 * by_size[2]};
}

Traffic total(const Span& span, std::size_t initiator, std::size_t direction) {
  Traffic sum = span.traffic[initiator][direction];
  if (span.core == static_cast<int>(initiator)) {  // cores are initiators 0 and 1
    sum += direct(direction == 0 ? span.window.reads : span.window.writes);
  }
  return sum;
}

}  // namespace

std::uint64_t MemorySystem::external_transfers() const {
  std::uint64_t transfers = 0;
  for (int initiator = 0; initiator < kInitiatorCount; ++initiator) {
    for (const Direction direction : {Direction::read, Direction::write}) {
      const Traffic traffic =
          level_traffic(Level::l3, static_cast<Initiator>(initiator), direction);
      transfers += static_cast<Initiator>(initiator) == Initiator::host ? traffic.bytes / 4
                                                                        : traffic.accesses;
    }
  }
  return transfers;
}

Traffic MemorySystem::level_traffic(Level level, Initiator initiator, Direction direction) const {
  Traffic sum;
  for (const Span& span : spans_) {
    if (span.level == level) {
      sum += total(span, static_cast<std::size_t>(initiator), static_cast<std::size_t>(direction));
    }
  }
  const auto core = static_cast<std::size_t>(initiator);
  if (level == Level::l1 && core < caches_.size()) {
    for (const auto& bank : caches_[core].traffic) {
      sum += bank[static_cast<std::size_t>(direction)];
    }
  }
  return sum;
}

std::vector<ObjectTraffic> MemorySystem::objects() const {
  std::vector<ObjectTraffic> result = objects_;
  for (const Span& span : spans_) {
    TrafficTable& table = result[span.object].traffic;
    for (std::size_t initiator = 0; initiator < table.size(); ++initiator) {
      for (std::size_t direction = 0; direction < kDirectionCount; ++direction) {
        table[initiator][direction] += total(span, initiator, direction);
      }
    }
  }
  add_caches(result);
  return result;
}

// What cores had from their data caches, for those that had anything.
void MemorySystem::add_caches(std::vector<ObjectTraffic>& objects) const {
  for (std::size_t core = 0; core < caches_.size(); ++core) {
    for (std::size_t bank = 0; bank < kDataCacheBanks; ++bank) {
      const auto& traffic = caches_[core].traffic[bank];
      if (traffic[0].accesses + traffic[1].accesses == 0) {
        continue;
      }
      const Region& region = *data_bank(static_cast<int>(core), static_cast<int>(bank));
      ObjectTraffic cache{.name = "(cache)",
                          .owner = name_of(static_cast<CoreId>(core)),
                          .region = region.name,
                          .level = Level::l1,
                          .address = region.cache_base(),
                          .size = region.cache_bytes};
      cache.traffic[core] = traffic;
      objects.push_back(std::move(cache));
    }
  }
}

void MemorySystem::register_cache_counters(CounterRegistry& registry) const {
  for (std::size_t core = 0; core < caches_.size(); ++core) {
    for (std::size_t bank = 0; bank < kDataCacheBanks; ++bank) {
      const DataCacheCounters& counters = caches_[core].counters[bank];
      const auto add = [&](const char* what, const char* meaning, const std::uint64_t& value) {
        registry.add(fmt::format("{}.data_cache.{}.{}.accesses", name_of(static_cast<CoreId>(core)),
                                 bank == 0 ? "a" : "b", what),
                     "accesses", meaning, &value);
      };
      add("hit", "Loads and stores that found their line in the data cache.", counters.hits);
      add("miss", "Loads and stores of cacheable data that did not.", counters.misses);
      add("fill", "Lines brought into the data cache.", counters.fills);
      add("write_back", "Lines written back from the data cache.", counters.write_backs);
    }
  }
  for (std::size_t core = 0; core < caches_.size(); ++core) {
    const std::string name = fmt::format("{}.code_cache.", name_of(static_cast<CoreId>(core)));
    registry.add(name + "hit.accesses", "accesses",
                 "Fetches of code outside L1 that found their line in the instruction cache.",
                 &caches_[core].code_hits);
    registry.add(name + "miss.accesses", "accesses", "Those of cacheable code that did not.",
                 &caches_[core].code_misses);
  }
  for (std::size_t kind = 0; kind < kStaleKinds; ++kind) {
    registry.add(fmt::format("memory.stale.{}.events", kStaleKindNames[kind]), "events",
                 "Times that a data cache made somebody see, or leave behind, old data.",
                 &stale_watch_.count(static_cast<StaleKind>(kind)));
  }
}

void MemorySystem::register_counters(CounterRegistry& registry) const {
  for (std::size_t l = 0; l < kLevelCount; ++l) {
    for (std::size_t i = 0; i < kInitiatorCount; ++i) {
      for (std::size_t d = 0; d < kDirectionCount; ++d) {
        const auto sum = [this, l, i, d] {
          return level_traffic(static_cast<Level>(l), static_cast<Initiator>(i),
                               static_cast<Direction>(d));
        };
        const std::string name =
            fmt::format("traffic.{}.{}.{}", kLevelNames[l], kInitiatorNames[i], kDirectionNames[d]);
        const std::string what = fmt::format("{} by {} in {}", d == 0 ? "reads" : "writes",
                                             kInitiatorNames[i], kLevelNames[l]);
        registry.add(name + ".accesses", "accesses", what + ".", [sum] { return sum().accesses; });
        registry.add(name + ".bytes", "bytes", "Bytes of " + what + ".",
                     [sum] { return sum().bytes; });
        registry.add(name + ".stall.cycles", "cycles", "Cycles lost to " + what + ".",
                     [sum] { return sum().stall_cycles; });
      }
    }
  }
  const SdramCounters& sdram = sdram_.counters();
  registry.add("memory.sdram.row_hit.accesses", "accesses",
               "Accesses of cores, and pages of DMA bursts, that found their row open.",
               &sdram.row_hits);
  registry.add("memory.sdram.row_miss.accesses", "accesses",
               "Accesses of cores, and pages of DMA bursts, that had to open their row.",
               &sdram.row_misses);
  registry.add("memory.sdram.refresh.events", "events",
               "Refreshes up to the last access to the SDRAM.", &sdram.refreshes);
  registry.add("memory.sdram.busy.cycles", "cycles", "Time that accesses held the external bus.",
               &bus_.busy_cycles());
  register_cache_counters(registry);
}

}  // namespace finback::memory
