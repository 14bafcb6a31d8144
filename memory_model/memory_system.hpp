// The memories of the chip and its board: bytes, spans, and what an access costs.
//
// Models: L1 of both cores, shared L2, SDRAM on the external bus; uncached accesses, posted writes,
// contention between cores and DMA, open rows and refresh; traffic by initiator, level and object.
// Does not model: caches, burst interruption, L1 stalls of a core by DMA in the same sub-bank (at
// most one cycle a DMA word), instruction fetch contention. Source: hardware.md 2; the timing of
// the levels stands in l2_timing.hpp and sdram_timing.hpp.
//
// Calls that take `now` must come with non-decreasing `now`, whoever the initiator is.
#pragma once

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
#include <memory_model/clock_parameters.hpp>
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
  std::uint32_t region = 0;   // index into MemoryMap::regions
  std::uint32_t object = 0;   // index into MemorySystem::objects()
  TrafficTable traffic{};
  MemoryWindow window;  // L1 only; its counts are core `core`'s direct accesses

  [[nodiscard]] bool contains(Address address) const { return address - base < size; }
  [[nodiscard]] std::uint8_t* at(Address address) const { return bytes + (address - base); }
};

// Where DMA meets the memories: on each of them one burst at a time.
enum class DmaPort : std::uint8_t { l1_a, l1_b, l2, external, none };
inline constexpr std::size_t kDmaPortCount = 4;

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
  // Why `core` cannot make this access: "store of 4 bytes at 0xff400000: ...". The caller adds who
  // and where. Covers misalignment too; empty when the access is fine.
  [[nodiscard]] std::string core_fault(int core, Address address, int bytes, bool write) const;

  // Time and count one access of 1, 2 or 4 bytes, aligned, to a span of find_span. Return the stall
  // beyond the issue cycle, which is `now`. L1 spans cost nothing.
  Cycles core_read(int core, Span* span, Address address, int bytes, Cycles now) {
    const Cycles stall = read_stall(core, *span, address, now);
    count(*span, core, Direction::read, bytes, stall);
    return stall;
  }
  Cycles core_write(int core, Span* span, Address address, int bytes, Cycles now) {
    const Cycles stall = write_stall(core, *span, address, now);
    count(*span, core, Direction::write, bytes, stall);
    return stall;
  }
  // TESTSET of one byte: a read and a write with the bus locked. Returns the stall beyond the
  // instruction's own cycles. Throws GuestFault for L1 (hardware.md 4: L2 or external memory only).
  Cycles core_test_and_set(int core, Span* span, Address address, Cycles now);
  // When the posted writes of `core` to L2 and L3 have all arrived (SSYNC); may be in the past.
  [[nodiscard]] Cycles writes_drained_at(int core) const {
    return write_buffers_[static_cast<std::size_t>(core)].drained_at();
  }
  // The window for direct access to an own-L1 span; its counts join the traffic. nullptr for the
  // other levels.
  [[nodiscard]] static MemoryWindow* window(int core, Span* span) {
    return span->level == Level::l1 && span->core == core ? &span->window : nullptr;
  }
  // Stall of fetching the next 8 bytes of code from `level`, without contention; 0 for L1.
  [[nodiscard]] Cycles fetch_line_cost(Level level) const;

  // --- DMA ---
  // Why DMA cannot touch all of `run`, "0x...: ..."; empty when it can. A run lies in one region.
  [[nodiscard]] std::string dma_fault(const DmaRun& run, std::uint32_t element_bytes) const;
  // Which port DMA meets `address` at: one of a core's L1, L2's, the external one; none where there
  // is no memory for it.
  [[nodiscard]] DmaPort dma_port(Address address);
  // Times and counts one burst, begun at `now`; returns when its last word has passed. The runs
  // must be free of dma_fault and aligned to `element_bytes` (1, 2 or 4). What it waited for
  // others since `asked_at` counts as its stall.
  Cycles dma_burst(Initiator initiator, Direction direction, std::span<const DmaRun> runs,
                   std::uint32_t element_bytes, Cycles now, Cycles asked_at);
  // The same for IMDMA: at the core clock, through the cores' port of L2. L1 and L2 only.
  Cycles internal_dma_burst(Initiator initiator, Direction direction, std::span<const DmaRun> runs,
                            std::uint32_t element_bytes, Cycles now, Cycles asked_at);
  // Move the bytes of a burst, without time or counts.
  void gather(std::span<const DmaRun> runs, std::uint32_t element_bytes, std::uint8_t* to);
  void scatter(std::span<const DmaRun> runs, std::uint32_t element_bytes, const std::uint8_t* from);

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
  Cycles read_stall(int core, const Span& span, Address address, Cycles now) {
    if (span.level == Level::l3) {
      return sdram_.core_read(address, now);
    }
    return span.level == Level::l2 ? l2_.core_read(core, address, now) : 0;
  }
  Cycles write_stall(int core, const Span& span, Address address, Cycles now) {
    if (span.level == Level::l1) {
      return 0;
    }
    WriteBuffer& buffer = write_buffers_[static_cast<std::size_t>(core)];
    const Cycles stall = buffer.make_room(now);
    const Cycles start = buffer.next_start(now + stall);
    buffer.push(span.level == Level::l3 ? sdram_.posted_write(address, start)
                                        : l2_.posted_write(core, address, start));
    return stall;
  }

  void add_region_spans(std::size_t region, const std::vector<ObjectPlace>& places);
  void add_span(std::size_t region, std::uint64_t base, std::uint64_t end, std::uint32_t object);
  [[nodiscard]] Span* find_any(Address address);
  [[nodiscard]] std::uint8_t* bytes_at(Address address, std::uint32_t size) const;
  void count_run(Initiator initiator, Direction direction, const DmaRun& run,
                 std::uint32_t element_bytes);
  void count_wait(Span& span, Initiator initiator, Direction direction, Cycles cycles);
  [[nodiscard]] Cycles dma_free_at(const Span& span) const;
  [[nodiscard]] Cycles dma_start(const Span& span, Direction direction, Cycles now);
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

  Cycles l1_dma_overhead_;
  Cycles l1_dma_word_;
  Cycles imdma_overhead_;
  Cycles imdma_word_;
  std::array<Cycles, kCoreCount> l1_dma_free_at_{};
  std::array<WriteBuffer, kCoreCount> write_buffers_;
  L2Timing l2_;
  SdramTiming sdram_;
};

}  // namespace finback::memory
