// Somebody who watches every access to memory, and what orders them: nobody in an ordinary run.
//
// The memory system tells it of accesses when they are made, the machine of all that one actor
// does for another to see. Watching changes neither results nor cycles; a watched run is slower,
// since no access goes past the memory system then.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <common/units.hpp>
#include <memory_model/memory_map.hpp>
#include <memory_model/traffic.hpp>

namespace finback::memory {

// `count` elements, `stride` bytes from one to the next.
struct DmaRun {
  Address address = 0;
  std::int32_t stride = 0;
  std::uint32_t count = 0;
};

class AccessObserver {
 public:
  virtual ~AccessObserver() = default;

  // --- accesses ---
  // A load or store of `core` by its packet number `packet`.
  virtual void core_access(int core, std::uint32_t packet, Address address, int bytes,
                           Direction direction, Cycles now) = 0;
  // TESTSET of one byte.
  virtual void core_lock(int core, std::uint32_t packet, Address address, Cycles now) = 0;
  // A burst of DMA.
  virtual void dma_access(Initiator stream, std::span<const DmaRun> runs,
                          std::uint32_t element_bytes, Direction direction, Cycles now) = 0;
  // The host, on behalf of the core that acts.
  virtual void host_access(Address address, std::uint32_t size, Direction direction) = 0;

  // --- order ---
  // What follows is of the doing of `who`; nothing: of a device that touches no memory.
  virtual void acts(std::optional<Initiator> who) = 0;
  // `core` acts: it reads or writes the device register at `address`.
  virtual void device_access(int core, std::uint32_t packet, Address address, Direction direction,
                             Cycles now) = 0;
  // The core that acts reads or writes a register of the DMA channel of `stream`.
  virtual void channel_access(Initiator stream, Direction direction) = 0;
  // Who acts raised a line of the interrupt controller of `core`; saw the lines of a word of it.
  virtual void line_raised(int core, int source) = 0;
  virtual void lines_seen(int core, int word, std::uint32_t lines) = 0;
  // The core that acts let `core` start.
  virtual void core_released(int core) = 0;
};

}  // namespace finback::memory
