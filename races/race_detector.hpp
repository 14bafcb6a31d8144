// Finds accesses to one byte by two actors, one of them a write, that nothing orders.
//
// Models what happens before what, by vector clocks: each core and each DMA stream goes through its
// own steps in order; DMA begins behind the register write that commanded it and is done for who
// reads its registers or takes its interrupt; an interrupt line carries what its raiser knew to the
// core that takes it; locks (TESTSET), the words declared as flags and device registers carry what
// their writers knew to their readers. Does not model: the order in which posted writes to
// different memories arrive, caches, the host (it acts for the core that asked). A run shows the
// races of that run: what another timing would do differently is found only where no order was kept
// in this one either. Source: the method is that of happens-before detectors (Lamport clocks; last
// write, last reads).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <races/shadow_memory.hpp>
#include <races/vector_clock.hpp>
#include <unordered_map>
#include <utility>
#include <vector>

#include <memory_model/access_observer.hpp>

namespace finback::races {

// A packet of a core: where something was asked for.
struct Place {
  int core = -1;
  std::uint32_t packet = 0;
  // NOLINTNEXTLINE(modernize-use-nullptr): sees one in what the compiler writes
  friend auto operator<=>(const Place&, const Place&) = default;
};

// One of the two accesses. `place` of a DMA stream's: where the stream was last commanded; core -1:
// it never was.
struct RaceSide {
  memory::Initiator actor = memory::Initiator::core_a;
  memory::Direction direction = memory::Direction::read;
  Place place;
  // NOLINTNEXTLINE(modernize-use-nullptr): sees one in what the compiler writes
  friend auto operator<=>(const RaceSide&, const RaceSide&) = default;
};

// All races between two places.
struct Race {
  RaceSide earlier;
  RaceSide later;
  Address address = 0;      // of the first byte
  Cycles at = 0;            // when the later access came, the first time
  std::uint64_t bytes = 0;  // how many, counted each time
};

struct Range {
  Address base = 0;
  std::uint32_t size = 0;
};

class RaceDetector final : public memory::AccessObserver {
 public:
  // `flags`: memory through which actors synchronise by plain loads and stores.
  explicit RaceDetector(std::vector<Range> flags);

  // In the order in which they were met.
  [[nodiscard]] const std::vector<Race>& races() const { return races_; }

  void core_access(int core, std::uint32_t packet, Address address, int bytes,
                   memory::Direction direction, Cycles now) override;
  void core_lock(int core, std::uint32_t packet, Address address, Cycles now) override;
  void dma_access(memory::Initiator stream, std::span<const memory::DmaRun> runs,
                  std::uint32_t element_bytes, memory::Direction direction, Cycles now) override;
  void host_access(Address address, std::uint32_t size, memory::Direction direction) override;
  void acts(std::optional<memory::Initiator> who) override;
  void device_access(int core, std::uint32_t packet, Address address, memory::Direction direction,
                     Cycles now) override;
  void channel_access(memory::Initiator stream, memory::Direction direction) override;
  void line_raised(int core, int source) override;
  void lines_seen(int core, int word, std::uint32_t lines) override;
  void core_released(int core) override;

 private:
  using Key = std::pair<RaceSide, RaceSide>;
  // Whoever accesses, as the checks want it.
  struct Actor {
    std::size_t number = 0;
    std::uint32_t place = 0;
    memory::Direction direction = memory::Direction::read;
    Cycles now = 0;
  };

  [[nodiscard]] std::uint32_t place_index(const Place& place);
  [[nodiscard]] VectorClock* flag_at(Address address, std::uint32_t bytes);
  void through_flag(std::size_t actor, VectorClock& flag, memory::Direction direction);
  void access(const Actor& actor, Address address, std::uint32_t bytes);
  void read_byte(const Actor& actor, Address address, Cell& cell);
  void write_byte(const Actor& actor, Address address, Cell& cell);
  [[nodiscard]] Mark mark_of(const Actor& actor) const;
  [[nodiscard]] bool unordered(const Actor& actor, const Mark& mark) const;
  void check(const Actor& actor, const Mark& earlier, memory::Direction direction, Address address);
  // Hands what `actor` knows on to `clock`, and begins its next step.
  void release(std::size_t actor, VectorClock& clock);

  std::vector<Range> flags_;                              // ordered by base
  std::unordered_map<Address, VectorClock> flag_clocks_;  // of flags' and registers' words
  std::array<VectorClock, kActorCount> clocks_;
  std::array<std::uint32_t, kActorCount> stream_places_{};  // where streams were commanded
  std::unordered_map<std::uint32_t, VectorClock> lines_;    // by core and source
  std::optional<std::size_t> acting_;
  std::uint32_t acting_place_ = 0;
  Cycles acting_since_ = 0;
  ShadowMemory shadow_;
  std::vector<Place> places_{Place{}};  // 0: nowhere
  std::map<Place, std::uint32_t> place_indices_;
  std::vector<Race> races_;
  std::map<Key, std::size_t> known_;  // index into races_
};

}  // namespace finback::races
