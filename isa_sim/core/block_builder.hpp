// Decodes packets into blocks: operations in an order that respects parallel issue, their time,
// their exits.
#pragma once

#include <memory>
#include <set>
#include <span>
#include <unordered_map>

#include <isa_sim/core/block.hpp>
#include <isa_sim/core/pipeline.hpp>
#include <isa_sim/ir/image.hpp>
#include <memory_model/memory_system.hpp>

namespace finback::core {

class BlockBuilder {
 public:
  // `image` and the rest must outlive the builder. `conflict` is the Execute of the operation that
  // checks two accesses of one packet for a sub-bank conflict; its operands are {register, offset,
  // register, offset}. `fetch` fetches code outside L1; its operands are {address, fetches, level}.
  BlockBuilder(const ir::CoreImage& image, const CoreParameters& parameters,
               const memory::MemorySystem& memory, isa::Execute conflict, isa::Execute fetch);

  // Long enough for any loop worth the name, short enough that interrupts and other actors are not
  // kept waiting.
  static constexpr std::uint32_t kMaxPackets = 64;

  // The state that stands for `state` at `address`: where an empty alignment buffer costs nothing,
  // it needs no block of its own.
  [[nodiscard]] std::uint32_t entry_state(Address address, std::uint32_t state);

  // The block at `address`, entered in pipeline state `state`; nullptr when no packet starts there.
  // `packets`: it has just so many, whatever they are; 0: as many as belong together.
  [[nodiscard]] std::unique_ptr<Block> build(Address address, std::uint32_t state,
                                             std::uint32_t packets = 0);

  // From now on blocks have at most `max_packets`, and `save` (or nullptr) runs before each packet
  // that could change registers and then not be completed. False when that is so already.
  bool set_style(std::uint32_t max_packets, isa::Execute save) {
    const bool changed = max_packets != max_packets_ || save != save_;
    max_packets_ = max_packets;
    save_ = save;
    return changed;
  }
  // A number for the present style: blocks of one style do not serve another.
  [[nodiscard]] std::uint32_t style() const {
    return (max_packets_ == 1 ? 1U : 0U) | (save_ != nullptr ? 2U : 0U);
  }

  // What the last operation of every block executes.
  [[nodiscard]] static isa::Execute leave();

  // Makes `address` the end of every block that reaches it. False when it was one already.
  // Where no packet begins there is nothing to end.
  bool add_loop_bottom(Address address) {
    return packet_at(address) != kNoPacket && loop_bottoms_.insert(address).second;
  }

  // Where packet `address` stands in the image; kNoPacket when none does.
  static constexpr std::uint32_t kNoPacket = ~std::uint32_t{0};
  [[nodiscard]] std::uint32_t packet_at(Address address) const;

 private:
  struct Draft;
  void add_packet(Draft& draft, std::uint32_t index) const;
  void add_operations(Draft& draft, const ir::PlacedPacket& packet, std::uint32_t index,
                      Cycles cycle) const;
  [[nodiscard]] static bool may_be_undone(const ir::PlacedPacket& packet);
  static void save_store_source(Draft& draft, std::span<const ir::PlacedInstruction*> packet,
                                const ir::PlacedInstruction& store, isa::Operation& operation);
  void add_conflict_check(Draft& draft, const ir::PlacedPacket& packet, std::uint32_t index,
                          Cycles cycle) const;
  void add_fetch(Draft& draft, const ir::PlacedPacket& packet, std::uint32_t index) const;
  // True when the pipeline is refilled even where control falls through.
  [[nodiscard]] bool set_exit(Block& block, const ir::PlacedPacket& last) const;

  const ir::CoreImage& image_;
  const CoreParameters& parameters_;
  const memory::MemorySystem& memory_;
  isa::Execute conflict_;
  isa::Execute fetch_;
  std::uint32_t max_packets_ = kMaxPackets;
  isa::Execute save_ = nullptr;
  Pipeline pipeline_;
  PipelineStates states_;
  std::set<Address> loop_bottoms_;
  std::unordered_map<Address, std::uint32_t> packet_index_;
};

// A window that no access hits: where every access site starts.
[[nodiscard]] MemoryWindow* no_window();

}  // namespace finback::core
