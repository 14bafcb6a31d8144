#include <fmt/format.h>

#include <common/file.hpp>
#include <common/toml_reader.hpp>
#include <isa_sim/ir/placement.hpp>

namespace finback::ir {
namespace {

constexpr std::array kOwners = {Owner::core_a, Owner::core_b, Owner::shared};
constexpr std::uint32_t kDefaultStackSize = 4096;  // the whole scratchpad
constexpr std::int64_t kLargestStack = 64 << 20;

RegionList read_regions(const TomlReader& reader, const toml::node& node, std::string_view name) {
  return {reader.strings(node, name), reader.place(node)};
}

std::vector<PlacementRule> read_rules(const TomlReader& reader, const toml::table& section,
                                      std::string_view key) {
  std::vector<PlacementRule> rules;
  if (const toml::table* table = reader.table(section, key)) {
    for (const auto& [pattern, node] : TomlReader::in_order(*table)) {
      rules.push_back({pattern, false, read_regions(reader, *node, pattern)});
    }
  }
  return rules;
}

// `stack = "l1.scratch"` or `stack = { region = "l1.scratch", size = 4096 }`.
void read_stack(const TomlReader& reader, const toml::node& node, OwnerPlacement& owner) {
  owner.stack_written = reader.place(node);
  owner.stack_size = kDefaultStackSize;
  if (const auto region = node.value_exact<std::string>()) {
    owner.stack_region = *region;
    return;
  }
  const toml::table* table = node.as_table();
  if (table == nullptr) {
    reader.fail(node, "'stack' is a region, or { region = \"...\", size = bytes }");
  }
  reader.check_keys(*table, "stack", {"region", "size"});
  owner.stack_region = reader.string(*table, "region");
  if (owner.stack_region.empty()) {
    reader.fail(node, "'stack' wants a region");
  }
  if (const toml::node* size = table->get("size")) {
    const auto bytes = size->value_exact<std::int64_t>();
    if (!bytes || *bytes < 64 || *bytes > kLargestStack || *bytes % 4 != 0) {
      reader.fail(*size, fmt::format("a stack's size is a multiple of 4, from 64 to {} bytes",
                                     kLargestStack));
    }
    owner.stack_size = static_cast<std::uint32_t>(*bytes);
  }
}

void read_owner(const TomlReader& reader, const toml::table& section, Owner which,
                OwnerPlacement& owner) {
  const std::string where = fmt::format("[{}]", owner_name(which));
  if (which == Owner::shared) {
    reader.check_keys(section, where, {"default", "objects"});
  } else {
    reader.check_keys(section, where, {"code", "default", "stack", "functions", "objects"});
  }
  if (const toml::node* code = section.get("code")) {
    owner.code = read_regions(reader, *code, "code");
  }
  if (const toml::node* defaults = section.get("default")) {
    owner.defaults = read_regions(reader, *defaults, "default");
  }
  if (const toml::node* stack = section.get("stack")) {
    read_stack(reader, *stack, owner);
  }
  owner.functions = read_rules(reader, section, "functions");
  owner.objects = read_rules(reader, section, "objects");
}

void override_rule(std::vector<PlacementRule>& rules, const std::string& name,
                   const std::string& region, const SourcePlace& written) {
  rules.insert(rules.begin(), {name, true, {{region}, written}});
}

}  // namespace

void Placement::override_object(Owner owner, const std::string& name, const std::string& region,
                                const SourcePlace& written) {
  override_rule(of(owner).objects, name, region, written);
}

void Placement::override_function(Owner owner, const std::string& name, const std::string& region,
                                  const SourcePlace& written) {
  override_rule(of(owner).functions, name, region, written);
}

Placement default_placement() {
  Placement placement;
  placement.source = "(default)";
  const SourcePlace written{placement.source, 0, 0};
  for (const Owner which : {Owner::core_a, Owner::core_b}) {
    OwnerPlacement& owner = placement.of(which);
    owner.code = {{"l1.code", "l1.code.cache", "l2", "l3"}, written};
    owner.defaults = {{"l1.data.b", "l1.data.a", "l2", "l3"}, written};
    owner.stack_region = "l1.scratch";
    owner.stack_size = kDefaultStackSize;
    owner.stack_written = written;
  }
  placement.of(Owner::shared).defaults = {{"l2", "l3"}, written};
  return placement;
}

Placement parse_placement(std::string_view text, const std::string& file) {
  const TomlReader reader(text, file);
  reader.check_keys(reader.root(), "a placement", {"core_a", "core_b", "shared"});
  Placement placement = default_placement();
  placement.source = file;
  for (const Owner which : kOwners) {
    if (const toml::table* section = reader.table(reader.root(), owner_name(which))) {
      read_owner(reader, *section, which, placement.of(which));
    }
  }
  return placement;
}

Placement load_placement(const std::filesystem::path& path) {
  return parse_placement(read_text_file(path), path.string());
}

std::string_view owner_name(Owner owner) {
  static constexpr std::array<std::string_view, 3> kNames = {"core_a", "core_b", "shared"};
  return kNames.at(static_cast<std::size_t>(owner));
}

}  // namespace finback::ir
