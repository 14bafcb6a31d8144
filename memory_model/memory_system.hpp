// The memories of the chip and its board: bytes, spans, and what an access costs.
//
// Models: L1 of both cores, shared L2, SDRAM on the external bus; uncached accesses, posted writes,
// contention between cores and DMA, open rows and refresh; the cores' data caches with their line
// fills and write-backs; instruction fetch and the instruction caches; traffic by initiator, level
// and object; the sub-banks of L1 that DMA takes from a core (l1_bursts.hpp). Does not model: burst
// interruption, the bytes of instruction fetches as traffic. Source: hardware.md 2; the timing of
// the levels stands in l2_timing.hpp and sdram_timing.hpp.
//
// Calls that take `now` must come with non-decreasing `now`, whoever the initiator is.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <common/counters.hpp>
#include <common/memory_window.hpp>
#include <common/units.hpp>
#include <memory_model/access_observer.hpp>
#include <memory_model/async_timing.hpp>
#include <memory_model/clock_parameters.hpp>
#include <memory_model/code_cache.hpp>
#include <memory_model/data_cache.hpp>
#include <memory_model/l1_bursts.hpp>
#include <memory_model/l2_timing.hpp>
#include <memory_model/memory_map.hpp>
#include <memory_model/memory_parameters.hpp>
#include <memory_model/sdram_timing.hpp>
#include <memory_model/traffic.hpp>
#include <memory_model/write_buffer.hpp>

namespace finback::memory {

// Something that was placed: its bytes are counted under its name.
struct ObjectPlace {
  std::string name;
  std::string owner;  // "core_a", "core_b" or "shared"
  Address address = 0;
  std::uint32_t size = 0;
};

// A stretch of one region that belongs to one object or to none. Every mapped address lies in
// exactly one span; padding of up to three bytes behind an object belongs to its span, so that
// aligned words never straddle two spans unless the objects themselves do.
struct Span {
  Address base = 0;
  std::uint32_t size = 0;
  std::uint8_t* bytes = nullptr;  // host copy of the byte at `base`
  Level level = Level::l1;
  int core = -1;              // whose L1; -1: shared
  bool core_access = true;    // loads and stores of the owning core may touch it (not L1 code)
  bool dma_reachable = true;  // not the scratchpad
  bool read_only = false;
  std::uint32_t region = 0;  // index into MemoryMap::regions
  std::uint32_t object = 0;  // index into MemorySystem::objects()
  TrafficTable traffic{};
  MemoryWindow window;  // L1 only; its counts are core `core`'s direct accesses

  [[nodiscard]] bool contains(Address address) const { return address - base < size; }
  [[nodiscard]] std::uint8_t* at(Address address) const { return bytes + (address - base); }
};

// Where DMA meets the memories: on each of them one burst at a time.
enum class DmaPort : std::uint8_t { l1_a, l1_b, l2, external, none };
inline constexpr std::size_t kDmaPortCount = 4;

// How an access through a data cache went.
struct CachedAccess {
  std::uint8_t* bytes = nullptr;  // what is read, or written
  std::uint8_t* also = nullptr;  // a store's copy in the cache, where it writes through; or nullptr
  Cycles stall = 0;              // beyond the issue cycle
  bool through = false;          // a store that went to memory
  // Lines moved between the cache and the levels, in bytes.
  std::array<Bytes, kLevelCount> moved{};
};

struct DataCacheCounters {
  std::uint64_t hits = 0;
  std::uint64_t misses = 0;
  std::uint64_t fills = 0;
  std::uint64_t write_backs = 0;
};

class MemorySystem {
 public:
  // `places`: everything that was placed, in any order. Memory is zero. Throws InputError when two
  // places overlap or one lies outside the map, or when the clock ratio is not whole.
  MemorySystem(MemoryMap map, const MemoryParameters& parameters, const ClockParameters& clock,
               const std::vector<ObjectPlace>& places);
  MemorySystem(const MemorySystem&) = delete;
  MemorySystem& operator=(const MemorySystem&) = delete;

  [[nodiscard]] const MemoryMap& map() const { return map_; }

  // --- the cores ---
  // The span that holds `address` if loads and stores of `core` may touch it; nullptr when it is
  // unmapped, the other core's L1, or L1 instruction memory. Spans live as long as the system.
  [[nodiscard]] Span* find_span(int core, Address address);
  // Whether an access to a span of find_span does not come about all the same: a store to memory
  // that is read-only, or a bank of asynchronous memory that is not enabled.
  [[nodiscard]] bool refuses(const Span& span, bool write) const {
    return (write && span.read_only) ||
           (span.level == Level::l3 && is_asynchronous(span.base) && !async_.enabled(span.base));
  }
  // Why `core` cannot make this access: "store of 4 bytes at 0xff400000: ...". The caller adds who
  // and where. Covers misalignment too; empty when the access is fine.
  [[nodiscard]] std::string core_fault(int core, Address address, int bytes, bool write) const;

  // Time and count one access of 1, 2 or 4 bytes, aligned, to a span of find_span. Return the stall
  // beyond the issue cycle, which is `now`. L1 spans cost nothing.
  Cycles core_read(int core, Span* span, Address address, int bytes, Cycles now) {
    const Cycles stall = read_stall(core, *span, address, bytes, now);
    count(*span, core, Direction::read, bytes, stall);
    return stall;
  }
  Cycles core_write(int core, Span* span, Address address, int bytes, Cycles now) {
    const Cycles stall = write_stall(core, *span, address, bytes, now);
    count(*span, core, Direction::write, bytes, stall);
    return stall;
  }
  // TESTSET of one byte: a read and a write with the bus locked. Returns the stall beyond the
  // instruction's own cycles. Throws GuestFault for L1 (hardware.md 4: L2 or external memory only).
  Cycles core_test_and_set(int core, Span* span, Address address, Cycles now);
  // From now on DMA can be in a core's way in L1, in sub-banks of `bytes`: windows to a sub-bank
  // are closed (of size 0) while a burst passes there, and dma_in_the_way() opens them again.
  void mind_sub_banks(int core, std::uint32_t bytes) {
    sub_bank_bytes_[static_cast<std::size_t>(core)] = bytes;
  }
  // Whether DMA takes the sub-bank and half of `address`, in `core`'s L1, at `now`.
  [[nodiscard]] bool dma_in_the_way(int core, Address address, Cycles now) {
    const auto number = static_cast<std::size_t>(core);
    if (l1_bursts_[number].empty()) {
      return false;
    }
    if (l1_bursts_[number].prune(now)) {
      set_windows(core);
    }
    return l1_bursts_[number].meets(address, now, sub_bank_bytes_[number]);
  }
  // When the posted writes of `core` to L2 and L3 have all arrived (SSYNC); may be in the past.
  [[nodiscard]] Cycles writes_drained_at(int core) const {
    const auto number = static_cast<std::size_t>(core);
    return std::max(write_buffers_[number].drained_at(), caches_[number].write_back_done);
  }
  // The window for direct access to an own-L1 span; its counts join the traffic. nullptr for the
  // other levels.
  [[nodiscard]] static MemoryWindow* window(int core, Span* span) {
    return span->level == Level::l1 && span->core == core ? &span->window : nullptr;
  }

  // --- instruction fetch from L2 and L3; L1's costs nothing here ---
  // `bytes`: a multiple of 8 from a multiple of it. Stall beyond the issue cycle.
  Cycles fetch_code(int core, Level level, Address address, std::uint32_t bytes, Cycles now) {
    if (level == Level::l3) {
      return is_asynchronous(address) ? async_.fetch(address, bytes, now)
                                      : sdram_.fetch(address, bytes, now);
    }
    return l2_.fetch(core, address, bytes, now);
  }
  [[nodiscard]] bool default_code_cache() const { return default_code_cache_; }
  // The half of L1 instruction memory that can be cache becomes one, and empty, or memory again.
  void configure_code_cache(int core, bool on, std::uint32_t locked_ways);
  [[nodiscard]] bool code_cache_on(int core) const {
    return caches_[static_cast<std::size_t>(core)].code.on();
  }
  [[nodiscard]] bool code_cache_holds(int core, Address address) const {
    return caches_[static_cast<std::size_t>(core)].code.holds(address);
  }
  // Up to a line's rest of code through the cache. `important`: its page's lines go last.
  Cycles cached_fetch(int core, Level level, Address address, std::uint32_t bytes, bool important,
                      Cycles now);
  void forget_code(int core, Address address);

  // --- a core's data cache ---
  // How `level` is cached while CPLBs are off, and the banks that are cache from reset on.
  [[nodiscard]] CachePolicy default_policy(Level level) const {
    return default_policy_[static_cast<std::size_t>(level)];
  }
  [[nodiscard]] int default_data_banks() const { return default_data_banks_; }
  // The upper halves of the first `banks` data banks are cache from now on, and empty, and those of
  // the others memory. `who`: for what is lost. Throws GuestFault when something was placed there.
  void configure_data_cache(int core, int banks, bool high_select, Accessor who, Cycles now);
  [[nodiscard]] bool data_cache_on(int core) const {
    return caches_[static_cast<std::size_t>(core)].data.on();
  }
  // Whether a cached access stays within the core's L1, so that nobody else can notice.
  [[nodiscard]] bool stays_in_cache(int core, Address address, bool write, CachePolicy policy) {
    return (!write || policy == CachePolicy::write_back) &&
           caches_[static_cast<std::size_t>(core)].data.find(address) != nullptr;
  }
  // Times, counts and carries out (but for a store's value) an access to a span of find_span in L2
  // or L3 that is cached by `policy`. `site`: where in the core's code.
  CachedAccess cached_access(int core, Span* span, Address address, int bytes, bool write,
                             CachePolicy policy, std::uint32_t site, Cycles now);
  // PREFETCH, FLUSH, FLUSHINV of the line at `address`; of the result, stall and moved are set.
  CachedAccess prefetch_line(int core, Span* span, Address address, std::uint32_t site, Cycles now);
  CachedAccess flush_line(int core, Address address, bool invalidate, std::uint32_t site,
                          Cycles now);
  // Where in the core's L1 a cached byte lies, as far as sub-banks go.
  [[nodiscard]] Address place_in_cache(int core, Address address) const;
  // What the host does in the name of a core's program sees the core's memory: before it the cache
  // is copied to memory, after it from there; neither takes time or changes what is dirty.
  void show_cache(int core);
  void update_cache(int core);

  // Notes for the watch, by whoever accesses memory past the caches; `except`: whose cache knows.
  [[nodiscard]] bool watching() const { return watching_; }
  void note_read(Address address, std::uint32_t bytes, Accessor who, Cycles now);
  void note_write(Address address, std::uint32_t bytes, Accessor who, int except = -1);
  [[nodiscard]] const StaleWatch& stale_watch() const { return stale_watch_; }
  // "core_b.frame": what a report's object is called.
  [[nodiscard]] std::string object_name(std::uint32_t object) const;

  // --- the external port's registers ---
  [[nodiscard]] SdramTiming& sdram() { return sdram_; }
  [[nodiscard]] AsyncTiming& asynchronous() { return async_; }
  [[nodiscard]] ExternalBus& external_bus() { return bus_; }
  // From when on `core` may read a `line` or a word of L3: ExternalBus::core_from. What it waits
  // counts as the span's stall, where there is one.
  [[nodiscard]] Cycles core_turn(int core, Span* span, bool line, Cycles now) {
    const Cycles from = bus_.core_from(core, line, now);
    if (span != nullptr) {
      span->traffic[static_cast<std::size_t>(core)][0].stall_cycles += from - now;
    }
    return from;
  }

  // From now on. Posted writes and words in L1 that are on their way arrive as they would have.
  void change_clock(const clock::ClockChange& change);
  // Transfers of up to 32 bits on the external bus, so far: what the power model wants to know.
  // Every access to SDRAM is one; the host's pictures come as words.
  [[nodiscard]] std::uint64_t external_transfers() const;

  // --- DMA ---
  // Why DMA cannot touch all of `run`, "0x...: ..."; empty when it can. A run lies in one region.
  [[nodiscard]] std::string dma_fault(const DmaRun& run, std::uint32_t element_bytes,
                                      Direction direction) const;
  // Which port DMA meets `address` at: one of a core's L1, L2's, the external one; none where there
  // is no memory for it.
  [[nodiscard]] DmaPort dma_port(Address address);
  // Times and counts one burst, begun at `now`; returns when its last word has passed. The runs
  // must be free of dma_fault and aligned to `element_bytes` (1, 2 or 4). What it waited for
  // others since `asked_at` counts as its stall. `further`: not the first of its work unit, so
  // that its start lies under the words before it, where the memory allows that.
  Cycles dma_burst(Initiator initiator, Direction direction, std::span<const DmaRun> runs,
                   std::uint32_t element_bytes, Cycles now, Cycles asked_at, bool further = false);
  // The same for IMDMA: at the core clock, through the cores' port of L2. L1 and L2 only.
  Cycles internal_dma_burst(Initiator initiator, Direction direction, std::span<const DmaRun> runs,
                            std::uint32_t element_bytes, Cycles now, Cycles asked_at);
  // Move the bytes of a burst, without time or counts.
  void gather(std::span<const DmaRun> runs, std::uint32_t element_bytes, std::uint8_t* to,
              Initiator initiator, Cycles now);
  void scatter(std::span<const DmaRun> runs, std::uint32_t element_bytes, const std::uint8_t* from,
               Initiator initiator);

  // --- the host and the loader ---
  // Count `size` bytes as initiator `host` and return where they lie; takes no time. Throws
  // InputError when the range is not within one region.
  std::uint8_t* host_access(Address address, std::uint32_t size, Direction direction);
  // Neither timed nor counted. Throw InputError when the range is not within one region.
  void store_bytes(Address address, std::span<const std::uint8_t> bytes);
  [[nodiscard]] std::span<const std::uint8_t> view_bytes(Address address, std::uint32_t size) const;

  // --- who watches ---
  // Told of DMA's and the host's accesses from now on; whoever makes a core's tells it of those.
  // Must outlive the system. nullptr, as at first: nobody.
  void set_observer(AccessObserver* observer) { observer_ = observer; }
  [[nodiscard]] AccessObserver* observer() const { return observer_; }

  // --- what was counted ---
  // Sums over all objects; equal to the traffic counters.
  [[nodiscard]] Traffic level_traffic(Level level, Initiator initiator, Direction direction) const;
  // By region in the order of their addresses: one for each place, then "(free)".
  [[nodiscard]] std::vector<ObjectTraffic> objects() const;
  // traffic.<level>.<initiator>.<read|write>.{bytes,accesses,stall.cycles} and memory.sdram.*.
  void register_counters(CounterRegistry& registry) const;

 private:
  struct FreeBytes {
    void operator()(std::uint8_t* bytes) const { std::free(bytes); }
  };
  using HostBytes = std::unique_ptr<std::uint8_t[], FreeBytes>;

  static void count(Span& span, int initiator, Direction direction, int bytes, Cycles stall) {
    Traffic& traffic =
        span.traffic[static_cast<std::size_t>(initiator)][static_cast<std::size_t>(direction)];
    ++traffic.accesses;
    traffic.bytes += static_cast<Bytes>(bytes);
    traffic.stall_cycles += stall;
  }
  Cycles read_stall(int core, const Span& span, Address address, int bytes, Cycles now) {
    if (span.level == Level::l3) {
      const auto size = static_cast<std::uint32_t>(bytes);
      return is_asynchronous(address) ? async_.core_read(address, size, now)
                                      : sdram_.core_read(address, size, now);
    }
    return span.level == Level::l2 ? l2_.core_read(core, address, now) : 0;
  }
  Cycles write_stall(int core, const Span& span, Address address, int bytes, Cycles now) {
    if (span.level == Level::l1) {
      return 0;
    }
    WriteBuffer& buffer = write_buffers_[static_cast<std::size_t>(core)];
    const Cycles stall = buffer.make_room(now);
    const Cycles start = buffer.next_start(now + stall);
    buffer.push(arrival(core, span.level, address, static_cast<std::uint32_t>(bytes), start));
    return stall;
  }
  Cycles arrival(int core, Level level, Address address, std::uint32_t bytes, Cycles start) {
    if (level == Level::l3) {
      return is_asynchronous(address) ? async_.posted_write(address, bytes, start)
                                      : sdram_.posted_write(address, bytes, start);
    }
    return l2_.posted_write(core, address, start);
  }

  // A core's data cache, its fill buffer (one line) and its victim buffer (another).
  struct CoreCache {
    DataCache data;
    LineFill fill;
    Address critical = 0;  // what the fill began with
    Cycles write_back_done = 0;
    std::array<DataCacheCounters, kDataCacheBanks> counters{};
    std::array<std::array<Traffic, kDirectionCount>, kDataCacheBanks> traffic{};

    CodeCache code;
    LineFill code_fill;
    Address code_critical = 0;
    std::uint64_t code_hits = 0;
    std::uint64_t code_misses = 0;
  };
  [[nodiscard]] const Region* code_half(int core) const { return map_.find(core, "l1.code.cache"); }
  void pass_through_l1(const Span& span, const DmaRun& run, Cycles start, Cycles word);
  // Opens and closes the windows of `core`'s L1, as caches and bursts want it.
  void set_windows(int core);
  [[nodiscard]] const Region* data_bank(int core, int bank) const;
  // Whether `address`, in an L1 region, is cache now.
  [[nodiscard]] bool is_cache(const Region& region, Address address) const;
  void turn_half(int core, int bank, bool cache);
  void report_dropped(int core, Accessor who, Cycles now);
  [[nodiscard]] static Cycles wait_for_word(const CoreCache& cache, Address address, Cycles now);
  CacheLine& fill_line(int core, const Span& span, Address address, Accessor who, Cycles now,
                       CachedAccess& result);
  void write_back(int core, CacheLine& line, Accessor who, Cycles start, Cycles now,
                  CachedAccess& result);
  LineFill line_fill(int core, Level level, Address address, Cycles start);
  void count_line(int core, Direction direction, Address address);
  void note_stored(int core, const CacheLine& line, LineBytes bytes);
  void note(StaleKind kind, Address address, Accessor reader, Accessor other, Cycles now);
  void add_caches(std::vector<ObjectTraffic>& objects) const;
  void register_cache_counters(CounterRegistry& registry) const;

  void add_region_spans(std::size_t region, const std::vector<ObjectPlace>& places);
  void add_span(std::size_t region, std::uint64_t base, std::uint64_t end, std::uint32_t object);
  [[nodiscard]] Span* find_any(Address address);
  [[nodiscard]] std::uint8_t* bytes_at(Address address, std::uint32_t size) const;
  void count_run(Initiator initiator, Direction direction, const DmaRun& run,
                 std::uint32_t element_bytes);
  void count_wait(Span& span, Initiator initiator, Direction direction, Cycles cycles);
  [[nodiscard]] Cycles dma_free_at(const Span& span, Address address) const;
  [[nodiscard]] Cycles dma_start(const Span& span, Address address, Initiator initiator,
                                 Direction direction, bool further, Cycles now);
  [[nodiscard]] Cycles dma_words(const Span& span, Direction direction, const DmaRun& run,
                                 std::uint32_t element_bytes, Cycles start);

  AccessObserver* observer_ = nullptr;
  MemoryMap map_;
  std::vector<HostBytes> region_bytes_;  // as map_.regions
  std::vector<Span> spans_;              // ordered by base; fixed after construction
  std::vector<Address> span_bases_;      // as spans_; packed for the search
  std::vector<ObjectTraffic> objects_;   // names; traffic stays in the spans
  // Spans found last, by a hash of the address: programs work on few objects at a time.
  static constexpr std::size_t kRecentCount = 256;
  std::array<Span*, kRecentCount> recent_{};

  std::array<CoreCache, kCoreCount> caches_;
  std::array<CachePolicy, kLevelCount> default_policy_{};
  int default_data_banks_;
  bool default_code_cache_;
  bool watching_ = false;  // a data cache is on
  StaleWatch stale_watch_;

  std::array<std::vector<Span*>, kCoreCount> l1_data_spans_;
  std::array<L1Bursts, kCoreCount> l1_bursts_;
  std::array<std::uint32_t, kCoreCount> sub_bank_bytes_{};  // 0: nobody minds DMA
  clock::ClockRatio ratio_;
  Cycles l1_dma_overhead_;  // in SCLK
  Cycles l1_dma_word_;      // in SCLK
  Cycles imdma_overhead_;
  Cycles imdma_word_;
  std::array<Cycles, kCoreCount> l1_dma_free_at_{};
  std::array<WriteBuffer, kCoreCount> write_buffers_;
  L2Timing l2_;
  ExternalBus bus_;
  SdramTiming sdram_;
  AsyncTiming async_;
};

}  // namespace finback::memory
