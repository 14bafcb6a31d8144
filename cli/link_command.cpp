// `finback link`: where everything of a firmware lies, without running it.
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

#include <cli/commands.hpp>
#include <cli/run_options.hpp>
#include <isa_sim/ir/linker.hpp>
#include <runner/run_request.hpp>

namespace finback::cli {

namespace {

constexpr const char* kLinkExamples =
    "Examples:\n"
    "  finback link\n"
    "  finback link --firmware mesvs1 --place core_b.shd_scores=l2\n"
    "Nothing is run. More: docs/finback-link.md";

std::string owner_text(int core) {
  return core < 0 ? "shared" : std::string(name_of(static_cast<CoreId>(core)));
}

// "l1.data.a" -> "l1.data": the memory that a region is a part of.
std::string memory_of(const std::string& region) {
  const std::size_t dot = region.find('.');
  return dot == std::string::npos ? region : region.substr(0, region.find('.', dot + 1));
}

struct MemoryUse {
  std::string name;
  int core = -1;
  std::uint64_t used = 0;
  std::uint64_t size = 0;
};

// A line of a table, or the head of one.
void print_use(const std::string& label, int core, std::uint64_t used, std::uint64_t size) {
  fmt::print("{:<22}  {:<8} {:>12} {:>13}  {:>5.1f} %\n", label, owner_text(core), used, size,
             100.0 * static_cast<double>(used) / static_cast<double>(size));
}

// The regions of a memory together: both banks of L1 data, code with and without the cache's part.
std::vector<MemoryUse> by_memory(const std::vector<ir::RegionUse>& regions) {
  std::vector<MemoryUse> memories;
  for (const ir::RegionUse& region : regions) {
    const std::string name = memory_of(region.region);
    auto found = std::ranges::find_if(memories, [&](const MemoryUse& memory) {
      return memory.name == name && memory.core == region.core;
    });
    if (found == memories.end()) {
      found = memories.insert(memories.end(), MemoryUse{name, region.core});
    }
    found->used += region.used;
    found->size += region.size;
  }
  std::ranges::stable_sort(memories, {}, &MemoryUse::core);
  return memories;
}

struct Thing {
  Address address = 0;
  std::uint32_t size = 0;
  std::string name;
  const char* kind = "";
};

// What lies in a region, ordered by address.
std::vector<Thing> things_in(const ir::Image& image, const ir::RegionUse& region) {
  std::vector<Thing> things;
  for (std::size_t core = 0; core < image.cores.size(); ++core) {
    for (const ir::PlacedFunction& function : image.cores[core].functions) {
      if (function.region == region.region &&
          (region.core < 0 || region.core == static_cast<int>(core))) {
        things.push_back({function.address, function.size, function.name, "function"});
      }
    }
  }
  for (const ir::PlacedObject& object : image.objects) {
    const int owner = object.owner == ir::Owner::shared ? -1 : static_cast<int>(object.owner);
    if (object.region == region.region && (region.core < 0 || region.core == owner)) {
      things.push_back({object.address, object.size, object.name, "object"});
    }
  }
  std::ranges::stable_sort(things, {}, &Thing::address);
  return things;
}

int print_link(const runner::RunRequest& request) {
  runner::RunInputs inputs;
  runner::load_linked(request, inputs);
  const memory::MemoryMap map = inputs.machine->placement_map();
  const ir::Firmware& firmware = inputs.firmware.firmware;
  const ir::Image image = ir::link(firmware.units, firmware.placement, map);
  const std::vector<ir::RegionUse> regions = ir::link_report(image, map);

  fmt::print("Firmware {}, placement {}, machine {}\n\n", inputs.firmware.identity.name,
             inputs.firmware.placement.name, inputs.machine->name);
  fmt::print("Memory                  core            used          size\n");
  for (const MemoryUse& memory : by_memory(regions)) {
    if (memory.used > 0) {
      print_use("  " + memory.name, memory.core, memory.used, memory.size);
    }
  }
  for (const ir::RegionUse& region : regions) {
    if (region.used == 0) {
      continue;
    }
    fmt::print("\n");
    print_use(region.region, region.core, region.used, region.size);
    for (const Thing& thing : things_in(image, region)) {
      fmt::print("  {:#010x}  {:<8}  {:>12}  {}\n", thing.address, thing.kind, thing.size,
                 thing.name);
    }
  }
  return kFine;
}

}  // namespace

void add_link_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "link", "How full each core's memories are, and where every function and object lies");
  command->footer(kLinkExamples);
  auto request = std::make_shared<runner::RunRequest>();
  add_link_options(*command, *request);
  command->callback([request, &action] { action = [request] { return print_link(*request); }; });
}

}  // namespace finback::cli
