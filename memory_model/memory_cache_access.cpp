// The side of the memory system that the cores' data caches use: lines in and out, in time.
//
// Models: one line fill at a time, critical word first, during which hits in other lines go on and
// a hit in the line waits for its word; a store that misses waits in the store buffer while its
// line comes; a buffer for one victim, which follows the fill on the bus; a miss waits for both.
// Does not model: the store buffer's size where stores miss, fills that are broken off. Source:
// Programming Reference, chapter 6; hardware.md 2.2 to 2.4; what overlaps with what is an estimate.
#include <algorithm>
#include <cstring>
#include <fmt/format.h>

#include <common/error.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::memory {

namespace {

Accessor core_accessor(int core, std::uint32_t site) {
  return {static_cast<Initiator>(core), site};
}

// The bytes of line `line` among the `bytes` at `address`.
LineBytes bytes_in_line(Address line, Address address, std::uint32_t bytes) {
  const std::uint64_t first = std::max<std::uint64_t>(line, address);
  const std::uint64_t end =
      std::min(std::uint64_t{line} + kLineBytes, std::uint64_t{address} + bytes);
  return line_bytes(static_cast<Address>(first), static_cast<std::uint32_t>(end - first));
}

void copy_bytes(std::uint8_t* to, const std::uint8_t* from, LineBytes which) {
  for (std::size_t i = 0; i < kLineBytes; ++i) {
    if ((which >> i & 1U) != 0) {
      to[i] = from[i];
    }
  }
}

// Calls `visit(line address)` for each line that holds one of `bytes` bytes at `address`.
template <class Visit>
void for_each_line_address(Address address, std::uint32_t bytes, const Visit& visit) {
  const std::uint64_t end = std::uint64_t{address} + bytes;
  for (std::uint64_t line = line_of(address); line < end; line += kLineBytes) {
    visit(static_cast<Address>(line));
  }
}

}  // namespace

const Region* MemorySystem::data_bank(int core, int bank) const {
  return map_.find(core, bank == 0 ? "l1.data.a" : "l1.data.b");
}

void MemorySystem::configure_data_cache(int core, int banks, bool high_select, Accessor who,
                                        Cycles now) {
  CoreCache& cache = caches_[static_cast<std::size_t>(core)];
  for (int bank = 0; bank < banks; ++bank) {
    const Region* region = data_bank(core, bank);
    if (region == nullptr || region->cache_bytes != kCacheBankBytes) {
      throw GuestFault(
          fmt::format("DMEM_CONTROL: data bank {} of {} has no {} bytes that can be "
                      "cache on this machine",
                      bank == 0 ? 'A' : 'B', name_of(static_cast<CoreId>(core)), kCacheBankBytes));
    }
    for (const Span& span : spans_) {
      if (region->contains(span.base) && span.base >= region->cache_base() &&
          objects_[span.object].name != "(free)") {
        throw GuestFault(fmt::format(
            "{:#010x} to {:#010x} of {} shall be data cache, but {} lies there at {:#010x}: place "
            "it elsewhere",
            region->cache_base(), region->base + region->size - 1,
            name_of(static_cast<CoreId>(core)), object_name(span.object), span.base));
      }
    }
  }
  for (const Region& region : map_.regions) {
    if (banks > 0 && region.level != Level::l1 && (region.base | region.size) % kLineBytes != 0) {
      throw GuestFault(
          fmt::format("region {} is not made of lines of {} bytes: it cannot be cached",
                      region.name, kLineBytes));
    }
  }
  report_dropped(core, who, now);
  cache.data.configure(banks, high_select);
  cache.fill = {};
  for (int bank = 0; bank < kDataCacheBanks; ++bank) {
    turn_half(core, bank, bank < banks);
  }
  watching_ = std::ranges::any_of(caches_, [](const CoreCache& c) { return c.data.on(); });
}

// Nobody reaches the half of a bank that is cache.
void MemorySystem::turn_half(int core, int bank, bool cache) {
  const Region* region = data_bank(core, bank);
  if (region == nullptr || region->cache_bytes == 0) {
    return;
  }
  for (Span& span : spans_) {
    if (region->contains(span.base) && span.base >= region->cache_base()) {
      span.core_access = !cache;
      span.dma_reachable = !cache && region->dma_reachable;
    }
  }
  set_windows(core);
}

void MemorySystem::report_dropped(int core, Accessor who, Cycles now) {
  caches_[static_cast<std::size_t>(core)].data.for_each_line([&](CacheLine& line) {
    if (line.valid && line.dirty != 0) {
      note(StaleKind::dropped, line.address, who, core_accessor(core, line.stored_at), now);
    }
  });
}

Cycles MemorySystem::wait_for_word(const CoreCache& cache, Address address, Cycles now) {
  if (now >= cache.fill.done() || line_of(address) != line_of(cache.critical)) {
    return 0;
  }
  const Cycles arrival = cache.fill.arrival(cache.critical, address);
  return arrival > now + 1 ? arrival - now - 1 : 0;
}

CachedAccess MemorySystem::cached_access(int core, Span* span, Address address, int bytes,
                                         bool write, CachePolicy policy, std::uint32_t site,
                                         Cycles now) {
  CoreCache& cache = caches_[static_cast<std::size_t>(core)];
  const auto bank = static_cast<std::size_t>(cache.data.bank_of(address));
  const LineBytes touched = line_bytes(address, static_cast<std::uint32_t>(bytes));
  const Accessor who = core_accessor(core, site);
  CachedAccess result;
  CacheLine* line = cache.data.find(address);
  ++(line != nullptr ? cache.counters[bank].hits : cache.counters[bank].misses);
  if (line != nullptr && !write) {
    result.stall = wait_for_word(cache, address, now);
  } else if (line == nullptr && (!write || policy != CachePolicy::write_through)) {
    line = &fill_line(core, *span, address, who, now, result);
    result.stall += write ? 0 : cache.fill.first - (now + result.stall) - 1;
  }
  if (line != nullptr) {
    cache.data.touch(*line);
  }
  if (write && policy != CachePolicy::write_back) {
    result.stall += core_write(core, span, address, bytes, now + result.stall);
    result.through = true;
    result.bytes = span->at(address);
    note_write(address, static_cast<std::uint32_t>(bytes), who, core);
  } else {
    Traffic& traffic = cache.traffic[bank][write ? 1 : 0];
    ++traffic.accesses;
    traffic.bytes += static_cast<Bytes>(bytes);
    traffic.stall_cycles += result.stall;
    result.bytes = line->at(address);
  }
  if (!write) {
    if ((line->stale & touched) != 0) {
      note(StaleKind::old_in_cache, address, who, line->stale_by, now);
    }
  } else if (line != nullptr) {
    line->stale &= ~touched;
    if (result.through) {
      result.also = line->at(address);
    } else {
      line->dirty |= touched;
      line->stored_at = site;
      note_stored(core, *line, touched);
    }
  }
  return result;
}

// Brings in the line at `address`; `result.stall` is what the core waits before the fill begins.
CacheLine& MemorySystem::fill_line(int core, const Span& span, Address address, Accessor who,
                                   Cycles now, CachedAccess& result) {
  CoreCache& cache = caches_[static_cast<std::size_t>(core)];
  CacheLine& line = cache.data.victim(address);
  const bool writes_back = line.valid && line.dirty != 0;
  const Cycles start =
      std::max({now, cache.fill.done(), writes_back ? cache.write_back_done : now});
  result.stall = start - now;
  cache.fill = line_fill(core, span.level, address, start);
  cache.critical = address;
  if (writes_back) {
    write_back(core, line, who, start, now, result);
  }
  ++cache.counters[static_cast<std::size_t>(cache.data.bank_of(address))].fills;
  line = CacheLine{.address = line_of(address), .valid = true};
  std::memcpy(line.bytes.data(), bytes_at(line.address, kLineBytes), kLineBytes);
  for (int other = 0; other < kCoreCount; ++other) {
    CoreCache& theirs = caches_[static_cast<std::size_t>(other)];
    const CacheLine* newer =
        other != core && theirs.data.on() ? theirs.data.find(address) : nullptr;
    if (newer != nullptr && newer->dirty != 0) {
      line.stale = newer->dirty;
      line.stale_by = core_accessor(other, newer->stored_at);
    }
  }
  count_line(core, Direction::read, line.address);
  result.moved[static_cast<std::size_t>(span.level)] += kLineBytes;
  return line;
}

LineFill MemorySystem::line_fill(int core, Level level, Address address, Cycles start) {
  if (level == Level::l3) {
    return is_asynchronous(address) ? async_.line_fill(address, start)
                                    : sdram_.line_fill(address, start);
  }
  return l2_.line_fill(core, address, start);
}

// The whole line goes, be it for one byte.
void MemorySystem::write_back(int core, CacheLine& line, Accessor who, Cycles start, Cycles now,
                              CachedAccess& result) {
  CoreCache& cache = caches_[static_cast<std::size_t>(core)];
  const Level level = find_any(line.address)->level;
  cache.write_back_done = level == Level::l2 ? l2_.line_write(core, line.address, start)
                          : is_asynchronous(line.address)
                              ? async_.posted_write(line.address, kLineBytes, start)
                              : sdram_.line_write(line.address, start);
  std::memcpy(bytes_at(line.address, kLineBytes), line.bytes.data(), kLineBytes);
  if (line.stale != 0) {
    note(StaleKind::overwritten, line.address, who, line.stale_by, now);
  }
  line.dirty = 0;
  line.stale = 0;
  ++cache.counters[static_cast<std::size_t>(cache.data.bank_of(line.address))].write_backs;
  count_line(core, Direction::write, line.address);
  result.moved[static_cast<std::size_t>(level)] += kLineBytes;
}

// One access, and each object's share of the bytes.
void MemorySystem::count_line(int core, Direction direction, Address address) {
  Bytes left = kLineBytes;
  for (Address at = address; left > 0;) {
    Span* span = find_any(at);
    const Bytes here = std::min<Bytes>(left, span->size - (at - span->base));
    Traffic& traffic =
        span->traffic[static_cast<std::size_t>(core)][static_cast<std::size_t>(direction)];
    traffic.accesses += left == kLineBytes ? 1 : 0;
    traffic.bytes += here;
    left -= here;
    at += static_cast<Address>(here);
  }
}

CachedAccess MemorySystem::prefetch_line(int core, Span* span, Address address, std::uint32_t site,
                                         Cycles now) {
  CoreCache& cache = caches_[static_cast<std::size_t>(core)];
  CachedAccess result;
  CacheLine* line = cache.data.find(address);
  if (line == nullptr) {
    line = &fill_line(core, *span, address, core_accessor(core, site), now, result);
  }
  cache.data.touch(*line);
  return result;
}

CachedAccess MemorySystem::flush_line(int core, Address address, bool invalidate,
                                      std::uint32_t site, Cycles now) {
  CoreCache& cache = caches_[static_cast<std::size_t>(core)];
  CachedAccess result;
  CacheLine* line = cache.data.find(address);
  if (line == nullptr) {
    return result;
  }
  if (line->dirty != 0) {
    const Cycles start = std::max(now, cache.write_back_done);
    result.stall = start - now;
    write_back(core, *line, core_accessor(core, site), start, now, result);
  }
  line->valid = !invalidate;
  return result;
}

Address MemorySystem::place_in_cache(int core, Address address) const {
  constexpr Address kSubBankAndWord = 0x3000 | (kLineBytes - 1);
  const int bank = caches_[static_cast<std::size_t>(core)].data.bank_of(address);
  return data_bank(core, bank)->cache_base() + (address & kSubBankAndWord);
}

void MemorySystem::show_cache(int core) {
  caches_[static_cast<std::size_t>(core)].data.for_each_line([&](CacheLine& line) {
    if (line.valid && line.dirty != 0) {
      copy_bytes(bytes_at(line.address, kLineBytes), line.bytes.data(), line.dirty);
    }
  });
}

void MemorySystem::update_cache(int core) {
  caches_[static_cast<std::size_t>(core)].data.for_each_line([&](CacheLine& line) {
    if (line.valid) {
      copy_bytes(line.bytes.data(), bytes_at(line.address, kLineBytes), ~line.stale);
    }
  });
}

// ---- the watch ----

void MemorySystem::note(StaleKind kind, Address address, Accessor reader, Accessor other,
                        Cycles now) {
  stale_watch_.note({.kind = kind,
                     .object = find_any(address)->object,
                     .reader = reader,
                     .other = other,
                     .address = address,
                     .at = now});
}

void MemorySystem::note_read(Address address, std::uint32_t bytes, Accessor who, Cycles now) {
  for (int core = 0; core < kCoreCount; ++core) {
    DataCache& cache = caches_[static_cast<std::size_t>(core)].data;
    if (!cache.on()) {
      continue;
    }
    for_each_line_address(address, bytes, [&](Address at) {
      const CacheLine* line = cache.find(at);
      if (line != nullptr && (line->dirty & bytes_in_line(at, address, bytes)) != 0) {
        note(StaleKind::old_in_memory, std::max(at, address), who,
             core_accessor(core, line->stored_at), now);
      }
    });
  }
}

void MemorySystem::note_write(Address address, std::uint32_t bytes, Accessor who, int except) {
  for (int core = 0; core < kCoreCount; ++core) {
    DataCache& cache = caches_[static_cast<std::size_t>(core)].data;
    if (!cache.on() || core == except) {
      continue;
    }
    for_each_line_address(address, bytes, [&](Address at) {
      if (CacheLine* line = cache.find(at)) {
        line->stale |= bytes_in_line(at, address, bytes);
        line->stale_by = who;
      }
    });
  }
}

// Stored into `core`'s cache: older in the others'.
void MemorySystem::note_stored(int core, const CacheLine& line, LineBytes bytes) {
  for (int other = 0; other < kCoreCount; ++other) {
    DataCache& cache = caches_[static_cast<std::size_t>(other)].data;
    CacheLine* older = other != core && cache.on() ? cache.find(line.address) : nullptr;
    if (older != nullptr) {
      older->stale |= bytes;
      older->stale_by = core_accessor(core, line.stored_at);
    }
  }
}

std::string MemorySystem::object_name(std::uint32_t object) const {
  const ObjectTraffic& traffic = objects_[object];
  return traffic.name == "(free)" ? fmt::format("free memory of {}", traffic.region)
                                  : fmt::format("{}.{}", traffic.owner, traffic.name);
}

}  // namespace finback::memory
