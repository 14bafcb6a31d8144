#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <new>

#include <common/error.hpp>
#include <memory_model/memory_system.hpp>
#include <memory_model/strided.hpp>

namespace finback::memory {

namespace {

// Asynchronous memory apart, of which a machine has what its banks hold.
const Region* only_region(const MemoryMap& map, Level level) {
  const Region* found = nullptr;
  for (const Region& region : map.regions) {
    if (region.level == level && !is_asynchronous(region.base)) {
      if (found != nullptr) {
        throw InputError(fmt::format("regions {} and {} are both {}: a machine has at most one",
                                     found->name, region.name,
                                     kLevelNames[static_cast<std::size_t>(level)]));
      }
      found = &region;
    }
  }
  return found;
}

}  // namespace

MemorySystem::MemorySystem(MemoryMap map, const MemoryParameters& parameters,
                           const ClockParameters& clock, const std::vector<ObjectPlace>& places)
    : map_(std::move(map)),
      default_data_banks_(static_cast<int>(parameters.cache_data_banks)),
      default_code_cache_(parameters.cache_code != 0),
      ratio_(clock.ratio()),
      l1_dma_overhead_(static_cast<Cycles>(parameters.l1_dma_overhead_sclk)),
      l1_dma_word_(static_cast<Cycles>(parameters.l1_dma_word_sclk)),
      imdma_overhead_(static_cast<Cycles>(parameters.imdma_overhead_cycles)),
      imdma_word_(static_cast<Cycles>(parameters.imdma_word_cycles)),
      l2_(parameters, ratio_, only_region(map_, Level::l2)),
      bus_(static_cast<Cycles>(parameters.external_patience_sclk), ratio_),
      sdram_(parameters, clock, only_region(map_, Level::l3), bus_),
      async_(parameters, ratio_, bus_) {
  for (WriteBuffer& buffer : write_buffers_) {
    buffer.set_entries(static_cast<std::size_t>(parameters.write_buffer_entries));
  }
  const auto policy = [](std::int64_t number) { return static_cast<CachePolicy>(number); };
  default_policy_ = {CachePolicy::uncached, policy(parameters.cache_l2_policy),
                     policy(parameters.cache_l3_policy)};
  std::vector<ObjectPlace> sorted = places;
  std::erase_if(sorted, [](const ObjectPlace& place) { return place.size == 0; });
  std::stable_sort(sorted.begin(), sorted.end(), [](const ObjectPlace& a, const ObjectPlace& b) {
    return a.address < b.address;
  });
  for (const ObjectPlace& place : sorted) {
    const Region* region = map_.find(place.address);
    if (region == nullptr || !region->contains(place.address, place.size)) {
      throw InputError(fmt::format("{} of {}: {} bytes at {:#010x} do not lie in one region",
                                   place.name, place.owner, place.size, place.address));
    }
  }
  for (std::size_t i = 0; i < map_.regions.size(); ++i) {
    // calloc gives zeroed pages that the host provides when they are touched.
    region_bytes_.emplace_back(static_cast<std::uint8_t*>(std::calloc(map_.regions[i].size, 1)));
    if (region_bytes_.back() == nullptr) {
      throw std::bad_alloc();
    }
    add_region_spans(i, sorted);
  }
  for (Span& span : spans_) {
    if (span.level == Level::l1 && span.core_access) {
      l1_data_spans_[static_cast<std::size_t>(span.core)].push_back(&span);
    }
  }
}

void MemorySystem::change_clock(const clock::ClockChange& change) {
  ratio_ = change.to;
  for (Cycles& free_at : l1_dma_free_at_) {
    free_at = change.system_time(free_at);
  }
  l2_.change_clock(change);
  bus_.change_clock(change);
  sdram_.change_clock(change);
  async_.change_clock(change);
}

void MemorySystem::add_region_spans(std::size_t index, const std::vector<ObjectPlace>& places) {
  const Region& region = map_.regions[index];
  const std::uint64_t region_end = std::uint64_t{region.base} + region.size;
  std::vector<const ObjectPlace*> here;
  for (const ObjectPlace& place : places) {
    if (region.contains(place.address)) {
      here.push_back(&place);
    }
  }
  const std::uint32_t free_object = static_cast<std::uint32_t>(objects_.size() + here.size());
  ObjectTraffic free{
      .name = "(free)",
      .owner = region.core < 0 ? "shared" : name_of(static_cast<CoreId>(region.core)),
      .region = region.name,
      .level = region.level};
  std::uint64_t next = region.base;
  const auto add_free = [&](std::uint64_t end) {
    if (next < end) {
      free.address = free.size == 0 ? static_cast<Address>(next) : free.address;
      free.size += static_cast<std::uint32_t>(end - next);
      add_span(index, next, end, free_object);
    }
  };
  for (std::size_t i = 0; i < here.size(); ++i) {
    const ObjectPlace& place = *here[i];
    if (place.address < next) {
      throw InputError(fmt::format("{} of {} at {:#010x} overlaps {} of {}", place.name,
                                   place.owner, place.address, here[i - 1]->name,
                                   here[i - 1]->owner));
    }
    add_free(place.address);
    const std::uint64_t limit = i + 1 < here.size() ? here[i + 1]->address : region_end;
    const std::uint64_t end = std::uint64_t{place.address} + place.size;
    const std::uint64_t padded = (end + 3) & ~std::uint64_t{3};
    next = padded <= limit ? padded : end;
    add_span(index, place.address, next, static_cast<std::uint32_t>(objects_.size()));
    objects_.push_back(ObjectTraffic{.name = place.name,
                                     .owner = place.owner,
                                     .region = region.name,
                                     .level = region.level,
                                     .address = place.address,
                                     .size = place.size});
  }
  add_free(region_end);
  objects_.push_back(std::move(free));
}

void MemorySystem::add_span(std::size_t index, std::uint64_t base, std::uint64_t end,
                            std::uint32_t object) {
  const Region& region = map_.regions[index];
  // What can become cache has spans of its own.
  if (base < region.cache_base() && region.cache_base() < end) {
    add_span(index, base, region.cache_base(), object);
    base = region.cache_base();
  }
  Span span;
  span.base = static_cast<Address>(base);
  span.size = static_cast<std::uint32_t>(end - base);
  span.bytes = region_bytes_[index].get() + (base - region.base);
  span.level = region.level;
  span.core = region.core;
  span.core_access = region.data || region.level != Level::l1;
  span.dma_reachable = region.dma_reachable;
  span.read_only = region.read_only;
  span.region = static_cast<std::uint32_t>(index);
  span.object = object;
  if (region.level == Level::l1) {
    span.window.base = span.base;
    span.window.size = span.size;
    span.window.bytes = span.bytes;
  }
  spans_.push_back(span);
  span_bases_.push_back(span.base);
}

Span* MemorySystem::find_any(Address address) {
  Span*& recent = recent_[(address >> 10U ^ address >> 20U) % kRecentCount];
  if (recent != nullptr && recent->contains(address)) {
    return recent;
  }
  const auto next = std::upper_bound(span_bases_.begin(), span_bases_.end(), address);
  if (next == span_bases_.begin()) {
    return nullptr;
  }
  Span& span = spans_[static_cast<std::size_t>(next - span_bases_.begin()) - 1];
  if (!span.contains(address)) {
    return nullptr;
  }
  recent = &span;
  return recent;
}

Span* MemorySystem::find_span(int core, Address address) {
  Span* span = find_any(address);
  const bool reachable =
      span != nullptr && span->core_access && (span->core == -1 || span->core == core);
  return reachable ? span : nullptr;
}

std::string MemorySystem::core_fault(int core, Address address, int bytes, bool write) const {
  const std::string access = fmt::format("{} of {} byte{} at {:#010x}", write ? "store" : "load",
                                         bytes, bytes == 1 ? "" : "s", address);
  if (address % static_cast<std::uint32_t>(bytes) != 0) {
    return fmt::format("{}: misaligned, the address must be a multiple of {}", access, bytes);
  }
  const Region* region = map_.find(address);
  if (region == nullptr) {
    return access + ": no memory is mapped there";
  }
  if (region->core != -1 && region->core != core) {
    return fmt::format("{}: {} of {} is out of reach of {} (only DMA goes there)", access,
                       region->name, name_of(static_cast<CoreId>(region->core)),
                       name_of(static_cast<CoreId>(core)));
  }
  if (is_cache(*region, address)) {
    return fmt::format("{}: that part of {} is cache (DMEM_CONTROL)", access, region->name);
  }
  if (region->level == Level::l1 && !region->data) {
    return fmt::format("{}: {} is instruction memory, which loads and stores do not reach", access,
                       region->name);
  }
  if (region->level == Level::l3 && is_asynchronous(address) && !async_.enabled(address)) {
    return fmt::format("{}: {}", access, async_.fault(address));
  }
  if (write && region->read_only) {
    return fmt::format("{}: {} is read-only", access, region->name);
  }
  return "";
}

bool MemorySystem::is_cache(const Region& region, Address address) const {
  if (region.level != Level::l1 || region.cache_bytes == 0 || address < region.cache_base()) {
    return false;
  }
  const CoreCache& caches = caches_[static_cast<std::size_t>(region.core)];
  if (&region == code_half(region.core)) {
    return caches.code.on();
  }
  const DataCache& cache = caches.data;
  return (cache.banks() > 0 && &region == data_bank(region.core, 0)) ||
         (cache.banks() > 1 && &region == data_bank(region.core, 1));
}

Cycles MemorySystem::core_test_and_set(int core, Span* span, Address address, Cycles now) {
  if (span->level == Level::l1) {
    throw GuestFault(fmt::format(
        "TESTSET at {:#010x}: a lock must lie in l2 or l3, L1 has no locked access", address));
  }
  if (is_asynchronous(address)) {
    throw GuestFault(fmt::format(
        "TESTSET at {:#010x}: a lock must lie in l2 or in SDRAM, not in asynchronous memory",
        address));
  }
  const Cycles stall = span->level == Level::l2 ? l2_.locked_read_write(core, address, now)
                                                : sdram_.locked_read_write(address, now);
  count(*span, core, Direction::read, 1, stall);
  count(*span, core, Direction::write, 1, 0);
  return stall;
}

std::uint8_t* MemorySystem::bytes_at(Address address, std::uint32_t size) const {
  const Region* region = map_.find(address);
  if (region == nullptr || !region->contains(address, size)) {
    throw InputError(
        fmt::format("{} bytes at {:#010x} do not lie in one region of memory", size, address));
  }
  return region_bytes_[static_cast<std::size_t>(region - map_.regions.data())].get() +
         (address - region->base);
}

std::uint8_t* MemorySystem::host_access(Address address, std::uint32_t size, Direction direction) {
  std::uint8_t* bytes = bytes_at(address, size);
  if (direction == Direction::write && map_.find(address)->read_only) {
    throw InputError(fmt::format("{} bytes at {:#010x} cannot be written: {} is read-only", size,
                                 address, map_.find(address)->name));
  }
  if (watching_ && size > 0) {
    const Accessor host{};
    direction == Direction::write ? note_write(address, size, host)
                                  : note_read(address, size, host, 0);
  }
  count_run(Initiator::host, direction, DmaRun{address, 1, size}, 1);
  if (observer_ != nullptr) {
    observer_->host_access(address, size, direction);
  }
  return bytes;
}

void MemorySystem::store_bytes(Address address, std::span<const std::uint8_t> bytes) {
  if (!bytes.empty()) {
    std::memcpy(bytes_at(address, static_cast<std::uint32_t>(bytes.size())), bytes.data(),
                bytes.size());
  }
}

std::span<const std::uint8_t> MemorySystem::view_bytes(Address address, std::uint32_t size) const {
  return {bytes_at(address, size), size};
}

}  // namespace finback::memory
