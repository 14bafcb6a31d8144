// Reading a machine file (TOML) into a MachineDescription.
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <toml++/toml.h>

#include <common/error.hpp>
#include <common/file.hpp>
#include <isa_sim/machine/machine_description.hpp>

namespace finback::machine {

namespace {

using memory::Level;
using memory::Region;

constexpr Address kDeviceRegisters = 0xFFC00000;

class MachineReader {
 public:
  explicit MachineReader(std::string file) : file_(std::move(file)) {}

  std::unique_ptr<MachineDescription> read(const toml::table& root) {
    for (const auto& [key, node] : root) {
      if (key == "name") {
        description_->name = text(key.str(), node);
      } else if (key == "region") {
        read_regions(node);
      } else if (key == "map") {
        // Below.
      } else {
        read_parameters(std::string(key.str()), key, node);
      }
    }
    if (const toml::node* changes = root.get("map")) {
      if (root.contains("region")) {
        fail(changes->source(),
             "[map] changes the BF561's map, [[region]] replaces it: one of the two");
      }
      change_map(*changes);
    }
    try {
      static_cast<void>(description_->clock.ratio());
    } catch (const InputError& error) {
      throw InputError(SourcePlace{file_}, error.what());
    }
    return std::move(description_);
  }

 private:
  [[noreturn]] void fail(const toml::source_region& at, const std::string& message) const {
    throw InputError(
        SourcePlace{file_, static_cast<int>(at.begin.line), static_cast<int>(at.begin.column)},
        message);
  }

  std::string text(std::string_view what, const toml::node& node) const {
    if (!node.is_string()) {
      fail(node.source(), fmt::format("{} wants a text in quotes", what));
    }
    return **node.as_string();
  }

  void read_parameters(const std::string& name, const toml::key& key, const toml::node& node) {
    if (const toml::table* table = node.as_table()) {
      for (const auto& [inner_key, inner] : *table) {
        read_parameters(name + "." + std::string(inner_key.str()), inner_key, inner);
      }
      return;
    }
    ParameterBase* parameter = find(name);
    if (parameter == nullptr) {
      fail(key.source(), unknown("key", name, parameter_names()));
    }
    if (!node.is_number()) {
      fail(node.source(),
           fmt::format(
               "{} wants a number of {}", name,
               parameter->declaration().unit.empty() ? "units" : parameter->declaration().unit));
    }
    try {
      parameter->set(*node.value<double>());
    } catch (const InputError& error) {
      fail(node.source(), error.what());
    }
  }

  ParameterBase* find(std::string_view name) {
    for (ParameterBase* parameter : description_->parameters()) {
      if (parameter->declaration().name == name) {
        return parameter;
      }
    }
    return nullptr;
  }

  [[nodiscard]] std::vector<std::string> parameter_names() const {
    std::vector<std::string> names = {"name", "region", "map"};
    for (const ParameterBase* parameter : std::as_const(*description_).parameters()) {
      names.emplace_back(parameter->declaration().name);
    }
    return names;
  }

  static std::string unknown(std::string_view kind, const std::string& name,
                             const std::vector<std::string>& known) {
    const std::string nearest = nearest_name(name, known);
    return fmt::format("unknown {} {}{}", kind, name,
                       nearest.empty() ? "" : fmt::format(", did you mean {}", nearest));
  }

  void read_regions(const toml::node& node) {
    const toml::array* array = node.as_array();
    if (array == nullptr || !array->is_homogeneous(toml::node_type::table)) {
      fail(node.source(), "region wants [[region]] tables, one for each region of the map");
    }
    std::vector<Region>& regions = description_->map.regions;
    regions.clear();
    for (const toml::node& entry : *array) {
      const Region region = read_region(*entry.as_table());
      for (const Region& other : regions) {
        check_pair(entry.source(), region, other);
      }
      regions.push_back(region);
    }
    std::sort(regions.begin(), regions.end(),
              [](const Region& a, const Region& b) { return a.base < b.base; });
  }

  // What stands in [map]: `name = { size = ... }` or `name = false`.
  void change_map(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      fail(node.source(), "map wants a table [map] of regions and what changes in them");
    }
    for (const auto& [key, change] : *table) {
      change_regions(key, change);
    }
    const std::vector<Region>& regions = description_->map.regions;
    for (std::size_t i = 1; i < regions.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        check_pair(node.source(), regions[i], regions[j]);
      }
    }
    std::ranges::sort(description_->map.regions, {}, &Region::base);
  }

  // Whether `key`, "l1.code", "core_b.l1.code" or "core_b", means `region`.
  static bool means(std::string_view key, const Region& region) {
    if (region.core < 0) {
      return key == region.name;
    }
    const std::string core = name_of(static_cast<CoreId>(region.core));
    return key == region.name || key == core || key == core + "." + region.name;
  }

  void change_regions(const toml::key& key, const toml::node& change) {
    std::vector<Region>& regions = description_->map.regions;
    std::vector<std::string> known = {"core_b"};
    bool found = false;
    for (Region& region : regions) {
      known.push_back(region.name);
      if (!means(key.str(), region)) {
        continue;
      }
      found = true;
      if (const toml::table* table = change.as_table()) {
        change_region(*table, region);
      } else if (!change.is_boolean() || **change.as_boolean()) {
        fail(change.source(),
             fmt::format("map.{} wants {{ size = ... }}, or false for a machine without it",
                         key.str()));
      }
    }
    if (!found) {
      fail(key.source(), unknown("region", std::string(key.str()), known));
    }
    if (change.is_boolean()) {
      std::erase_if(regions, [&](const Region& region) { return means(key.str(), region); });
    }
  }

  void change_region(const toml::table& table, Region& region) const {
    check_keys(table,
               {"base", "size", "code", "data", "dma_reachable", "read_only", "cache_bytes"});
    if (table.contains("base")) {
      region.base = number(table, "base", 0);
    }
    if (table.contains("size")) {
      region.size = number(table, "size", 4);
    }
    region.code = flag(table, "code", region.code);
    region.data = flag(table, "data", region.data);
    region.dma_reachable = flag(table, "dma_reachable", region.dma_reachable);
    region.read_only = flag(table, "read_only", region.read_only);
    region.cache_bytes = table.contains("cache_bytes") ? cache_bytes(table, region)
                                                       : std::min(region.cache_bytes, region.size);
    check_end(table.source(), region);
  }

  Region read_region(const toml::table& table) const {
    check_keys(table, {"name", "base", "size", "level", "core", "code", "data", "dma_reachable",
                       "read_only", "cache_bytes"});
    Region region;
    region.name = text("region.name", required(table, "name"));
    region.base = number(table, "base", 0);
    region.size = number(table, "size", 4);
    region.level = level(required(table, "level"));
    region.core = core(table);
    region.code = flag(table, "code", false);
    region.data = flag(table, "data", false);
    region.dma_reachable = flag(table, "dma_reachable", true);
    region.read_only = flag(table, "read_only", false);
    region.cache_bytes = cache_bytes(table, region);
    if ((region.level == Level::l1) != (region.core >= 0)) {
      fail(table.source(), region.level == Level::l1
                               ? fmt::format("region {}: an l1 region needs core = \"core_a\" or "
                                             "\"core_b\"",
                                             region.name)
                               : fmt::format("region {}: only l1 regions belong to a core; leave "
                                             "out core",
                                             region.name));
    }
    check_end(table.source(), region);
    return region;
  }

  void check_end(const toml::source_region& at, const Region& region) const {
    if (std::uint64_t{region.base} + region.size > kDeviceRegisters) {
      fail(at, fmt::format("region {} reaches into the device registers at {:#x}", region.name,
                           kDeviceRegisters));
    }
    const Address last = region.base + (region.size - 1);
    const bool of_one_kind = memory::is_asynchronous(region.base)
                                 ? region.base >> 26U == last >> 26U
                                 : region.base >> 28U > 2 || last >> 28U < 2;
    if (region.level == Level::l3 && !of_one_kind) {
      fail(at, fmt::format("region {} is not all of one kind: from 0x20000000 to 0x2fffffff lie "
                           "four banks of asynchronous memory, 64 MB each",
                           region.name));
    }
  }

  void check_keys(const toml::table& table, const std::vector<std::string>& known) const {
    for (const auto& [key, node] : table) {
      if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
        fail(key.source(), unknown("key of a region:", std::string(key.str()), known));
      }
    }
  }

  std::uint32_t cache_bytes(const toml::table& table, const Region& region) const {
    if (!table.contains("cache_bytes")) {
      return 0;
    }
    const std::uint32_t bytes = number(table, "cache_bytes", 0);
    if (region.level != Level::l1 || bytes > region.size) {
      fail(table.get("cache_bytes")->source(),
           fmt::format("region {}: cache_bytes are the last bytes of an l1 region that can be "
                       "cache, at most its size",
                       region.name));
    }
    return bytes;
  }

  const toml::node& required(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
      fail(table.source(), fmt::format("a region needs {}", key));
    }
    return *node;
  }

  // A multiple of 4 in 32 bits, at least `minimum`.
  std::uint32_t number(const toml::table& table, std::string_view key, std::int64_t minimum) const {
    const toml::node& node = required(table, key);
    const toml::value<std::int64_t>* value = node.as_integer();
    if (value == nullptr || value->get() < minimum || value->get() > 0xFFFFFFFF ||
        value->get() % 4 != 0) {
      fail(node.source(),
           fmt::format("region.{} wants a multiple of 4 from {} to 0xffffffff", key, minimum));
    }
    return static_cast<std::uint32_t>(value->get());
  }

  Level level(const toml::node& node) const {
    const std::string name = text("region.level", node);
    const auto* found =
        std::find(memory::kLevelNames.begin(), memory::kLevelNames.end(), std::string_view(name));
    if (found == memory::kLevelNames.end()) {
      fail(node.source(),
           fmt::format("region.level = \"{}\": it is \"l1\", \"l2\" or \"l3\"", name));
    }
    return static_cast<Level>(found - memory::kLevelNames.begin());
  }

  int core(const toml::table& table) const {
    const toml::node* node = table.get("core");
    if (node == nullptr) {
      return -1;
    }
    const std::string name = text("region.core", *node);
    for (const CoreId id : {CoreId::a, CoreId::b}) {
      if (name == name_of(id)) {
        return static_cast<int>(id);
      }
    }
    fail(node->source(), fmt::format("region.core = \"{}\": it is \"core_a\" or \"core_b\"", name));
  }

  bool flag(const toml::table& table, std::string_view key, bool otherwise) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
      return otherwise;
    }
    if (!node->is_boolean()) {
      fail(node->source(), fmt::format("region.{} wants true or false", key));
    }
    return **node->as_boolean();
  }

  void check_pair(const toml::source_region& at, const Region& region, const Region& other) const {
    if (region.base <= other.base + (other.size - 1) &&
        other.base <= region.base + (region.size - 1)) {
      fail(at, fmt::format("region {} at {:#010x} overlaps {} at {:#010x}", region.name,
                           region.base, other.name, other.base));
    }
    const bool seen_together = region.core == other.core || region.core == -1 || other.core == -1;
    if (region.name == other.name && seen_together) {
      fail(at, fmt::format("there are two regions {} for the same core", region.name));
    }
    if (region.level != Level::l1 && region.level == other.level &&
        !memory::is_asynchronous(region.base) && !memory::is_asynchronous(other.base)) {
      fail(at,
           fmt::format("regions {} and {} are both {}: a machine has at most one", other.name,
                       region.name, memory::kLevelNames[static_cast<std::size_t>(region.level)]));
    }
  }

  std::string file_;
  std::unique_ptr<MachineDescription> description_ = std::make_unique<MachineDescription>();
};

}  // namespace

std::unique_ptr<MachineDescription> parse_machine(std::string_view text, const std::string& file) {
  try {
    return MachineReader(file).read(toml::parse(text, file));
  } catch (const toml::parse_error& error) {
    const toml::source_position& at = error.source().begin;
    throw InputError(SourcePlace{file, static_cast<int>(at.line), static_cast<int>(at.column)},
                     std::string(error.description()));
  }
}

std::unique_ptr<MachineDescription> load_machine(const std::filesystem::path& path) {
  return parse_machine(read_text_file(path), path.string());
}

}  // namespace finback::machine
