// Where the cycles went, summed from counts x constants when somebody asks.
#include <algorithm>
#include <fmt/format.h>

#include <isa_sim/core/core.hpp>
#include <isa_sim/core/placed.hpp>

namespace finback::core {

namespace {

void add(CauseCycles& sum, Cause cause, Cycles cycles) {
  sum[static_cast<std::size_t>(cause)] += cycles;
}

void add(CauseCycles& sum, const CauseCycles& more) {
  for (std::size_t cause = 0; cause < sum.size(); ++cause) {
    sum[cause] += more[cause];
  }
}

bool any(const CauseCycles& cycles) {
  return std::ranges::any_of(cycles, [](Cycles count) { return count != 0; });
}

}  // namespace

// What an execution moves is known when it is decoded, and where it went only when it was not the
// core's own L1: the rest is L1's, its cache's too. A block that waits for its turn has run as
// far as the access that waits.
LevelBytes Core::bytes_of(std::uint32_t packet, std::uint64_t executions) const {
  const ir::PlacedPacket& placed = image_.packets[packet];
  Bytes all = 0;
  for (std::size_t slot = 0; slot < placed.count; ++slot) {
    all += executions * access_bytes(placed.slots[slot]);
  }
  if (const auto killed = killed_bytes_.find(packet); killed != killed_bytes_.end()) {
    all += killed->second;
  }
  if (state_.retry != nullptr) {
    for (const isa::Operation* o = current_->operations.get(); o != state_.retry; ++o) {
      all += o->site == packet ? o->access_bytes : 0;
    }
  }
  const auto& far = far_bytes_[packet];
  const auto level = [](memory::Level which) { return static_cast<std::size_t>(which); };
  LevelBytes bytes{};
  bytes[level(memory::Level::l2)] = far[level(memory::Level::l2)];
  bytes[level(memory::Level::l3)] = far[level(memory::Level::l3)];
  bytes[level(memory::Level::l1)] =
      all - far[level(memory::Level::l2)] - far[level(memory::Level::l3)] - far[kDeviceBytes];
  if (const auto lines = line_bytes_.find(packet); lines != line_bytes_.end()) {
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] += lines->second[i];
    }
  }
  return bytes;
}

CoreProfile Core::profile() const {
  CoreProfile result;
  result.started = started_;
  if (!started_) {
    return result;
  }
  result.cycles = state_.time - started_at_;
  std::vector<CauseCycles> by_packet = dynamic_;
  std::vector<std::uint64_t> executions(image_.packets.size());
  std::vector<std::uint64_t> instructions(image_.functions.size());
  for (const auto& block : blocks_) {
    for (const StaticCost& cost : block->costs) {
      add(by_packet[cost.packet], cost.cause, cost.cycles * block->executions);
    }
    const std::uint32_t last = block->first_packet + block->packet_count - 1;
    add(by_packet[last], block->taken_cause, block->taken_extra * block->taken);
    add(by_packet[last], block->fall_cause, block->fall_extra * (block->executions - block->taken));
    for (std::uint32_t packet = block->first_packet; packet <= last; ++packet) {
      executions[packet] += block->executions;
    }
    instructions[block->function] += block->instructions * block->executions;
    result.instructions += block->instructions * block->executions;
    result.packets += block->packet_count * block->executions;
    for (std::size_t i = 0; i < result.by_energy_class.size(); ++i) {
      result.by_energy_class[i] += block->by_energy_class[i] * block->executions;
    }
  }
  const std::vector<Cycles> inclusive = calls_.inclusive(state_.time);
  for (std::uint32_t i = 0; i < image_.functions.size(); ++i) {
    result.functions.push_back({.name = image_.functions[i].name,
                                .calls = calls_.calls(i),
                                .instructions = instructions[i],
                                .exclusive = {},
                                .inclusive = inclusive[i],
                                .bytes = {}});
  }
  for (std::uint32_t packet = 0; packet < by_packet.size(); ++packet) {
    FunctionProfile& function = result.functions[image_.packets[packet].function];
    const LevelBytes bytes = bytes_of(packet, executions[packet]);
    for (std::size_t level = 0; level < bytes.size(); ++level) {
      function.bytes[level] += bytes[level];
    }
    add(function.exclusive, by_packet[packet]);
    add(result.causes, by_packet[packet]);
    if (executions[packet] != 0 || any(by_packet[packet])) {
      result.packet_profiles.push_back({packet, executions[packet], by_packet[packet], bytes});
    }
  }
  return result;
}

CoreWork Core::work() const {
  CoreWork work;
  if (!started_) {
    return work;
  }
  work.busy = state_.time - started_at_;
  for (const CauseCycles& cycles : dynamic_) {
    work.busy -= cycles[static_cast<std::size_t>(Cause::idle)];
  }
  for (const auto& block : blocks_) {
    for (std::size_t i = 0; i < work.by_energy_class.size(); ++i) {
      work.by_energy_class[i] += block->by_energy_class[i] * block->executions;
    }
  }
  return work;
}

void Core::register_counters(CounterRegistry& registry) const {
  const std::string core = name_of(id_);
  registry.add(core + ".cycles", "cycles",
               "from the core's start to the end of the run, sleep included",
               [this] { return profile().cycles; });
  registry.add(core + ".instructions", "instructions",
               "executed, without the NOPs that fill packets",
               [this] { return profile().instructions; });
  registry.add(core + ".packets", "packets", "issued", [this] { return profile().packets; });
  for (std::size_t cause = 0; cause < kCauseCount; ++cause) {
    const std::string name = cause == 0
                                 ? core + ".issue.cycles"
                                 : fmt::format("{}.stall.{}.cycles", core, kCauseNames[cause]);
    registry.add(name, "cycles", cause == 0 ? "one for each packet" : "waiting, by cause",
                 [this, cause] { return profile().causes[cause]; });
  }
}

}  // namespace finback::core
