#include <algorithm>
#include <fmt/format.h>
#include <map>

#include <common/file.hpp>
#include <common/toml_reader.hpp>
#include <isa_sim/assembler/assemble.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/ir/verifier.hpp>

namespace finback::ir {
namespace {

namespace fs = std::filesystem;

bool is_c_name(std::string_view name) {
  const auto letter = [](char c) {
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  return !name.empty() && letter(name.front()) &&
         std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

// Reads each unit once, however many cores name it.
class UnitLoader {
 public:
  UnitLoader(const TomlReader& reader, fs::path folder)
      : reader_(reader), folder_(std::move(folder)) {}

  std::vector<Unit> load(const toml::table& section, std::string_view where) {
    const toml::node* node = section.get("units");
    if (node == nullptr) {
      reader_.fail(section, fmt::format("{} wants units = [\"a.bir\", ...]", where));
    }
    std::vector<Unit> units;
    std::vector<std::string> seen;
    for (const std::string& name : reader_.strings(*node, "units")) {
      if (std::ranges::count(seen, name) > 0) {
        reader_.fail(*node, fmt::format("{} names {} twice", where, name));
      }
      seen.push_back(name);
      units.push_back(load_one(*node, name));
    }
    return units;
  }

 private:
  Unit load_one(const toml::node& node, const std::string& name) {
    Unit& unit = units_[name];
    if (unit == nullptr) {
      const fs::path path = folder_ / name;
      std::error_code error;
      if (!fs::exists(path, error)) {
        reader_.fail(node, fmt::format("unit {} is not there", path.string()));
      }
      unit = std::make_shared<const Program>(load_program(path));
    }
    return unit;
  }

  const TomlReader& reader_;
  fs::path folder_;
  std::map<std::string, Unit> units_;
};

std::vector<Stage> read_stages(const TomlReader& reader) {
  std::vector<Stage> stages;
  const toml::table* table = reader.table(reader.root(), "stages");
  if (table == nullptr) {
    return stages;
  }
  for (const auto& [name, node] : TomlReader::in_order(*table)) {
    const toml::table* stage = node->as_table();
    if (stage == nullptr) {
      reader.fail(*node, "a stage is { core = \"a\", function = \"name\" }");
    }
    reader.check_keys(*stage, "a stage", {"core", "function"});
    const std::string core = reader.string(*stage, "core");
    const std::string function = reader.string(*stage, "function");
    if ((core != "a" && core != "b") || function.empty()) {
      reader.fail(*node, "a stage names its core (\"a\" or \"b\") and its function");
    }
    stages.push_back({name, core == "a" ? Owner::core_a : Owner::core_b, function});
  }
  return stages;
}

std::vector<std::string> read_flags(const TomlReader& reader, const toml::table& section,
                                    const std::vector<Unit>& shared) {
  const toml::node* node = section.get("flags");
  if (node == nullptr) {
    return {};
  }
  std::vector<std::string> flags = reader.strings(*node, "flags");
  for (const std::string& flag : flags) {
    const bool known = std::ranges::any_of(shared, [&](const Unit& unit) {
      return std::ranges::any_of(unit->objects,
                                 [&](const Object& object) { return c_name(object.name) == flag; });
    });
    if (!known) {
      reader.fail(*node, fmt::format("flags: no shared unit has an object {}", flag));
    }
  }
  return flags;
}

// `tables = { file = "tables.bin", at = 0x20000000 }`.
void read_flash(const TomlReader& reader, const fs::path& folder, FirmwareUnits& units) {
  const toml::table* table = reader.table(reader.root(), "flash");
  if (table == nullptr) {
    return;
  }
  for (const auto& [name, node] : TomlReader::in_order(*table)) {
    const toml::table* entry = node->as_table();
    if (entry == nullptr || !is_c_name(name)) {
      reader.fail(*node,
                  "[flash] holds NAME = { file = \"tables.bin\", at = 0x20000000 }, and NAME "
                  "is one that C can say");
    }
    reader.check_keys(*entry, name, {"file", "at"});
    const std::string file = reader.string(*entry, "file");
    if (file.empty()) {
      reader.fail(*node, fmt::format("{} wants file = \"tables.bin\"", name));
    }
    std::optional<Address> at;
    if (const toml::node* address = entry->get("at")) {
      const auto number = address->value_exact<std::int64_t>();
      if (!number || *number < 0 || *number > 0xFFFFFFFF || *number % 4 != 0) {
        reader.fail(*address, "'at' is an address, a multiple of 4");
      }
      at = static_cast<Address>(*number);
    }
    add_flash(units, name, folder / file, at, reader.place(*node));
  }
}

Firmware load_manifest(const fs::path& path) {
  const TomlReader reader(read_text_file(path), path.string());
  const toml::table& root = reader.root();
  reader.check_keys(root, "a firmware manifest",
                    {"name", "placement", "core_a", "core_b", "shared", "stages", "flash"});
  Firmware firmware;
  FirmwareUnits& units = firmware.units;
  units.name = reader.string(root, "name");
  if (units.name.empty()) {
    units.name = path.stem().string();
  }
  units.path = path.string();
  UnitLoader loader(reader, path.parent_path());
  for (const Owner which : {Owner::core_a, Owner::core_b}) {
    const std::string key(owner_name(which));
    const toml::table* section = reader.table(root, key);
    if (section == nullptr) {
      continue;
    }
    reader.check_keys(*section, key, {"units", "entry"});
    CoreUnits& core = units.cores[static_cast<std::size_t>(which)];
    core.present = true;
    core.units = loader.load(*section, key);
    if (const std::string entry = reader.string(*section, "entry"); !entry.empty()) {
      core.entry = entry;
    }
  }
  if (!units.cores[0].present) {
    throw InputError(path.string() + ": a firmware has a section [core_a]: that core starts first");
  }
  if (const toml::table* shared = reader.table(root, "shared")) {
    reader.check_keys(*shared, "shared", {"units", "flags"});
    units.shared = loader.load(*shared, "shared");
    units.flags = read_flags(reader, *shared, units.shared);
  }
  units.stages = read_stages(reader);
  const std::string placement = reader.string(root, "placement");
  firmware.placement =
      placement.empty() ? default_placement() : load_placement(path.parent_path() / placement);
  read_flash(reader, path.parent_path(), units);
  return firmware;
}

}  // namespace

void add_flash(FirmwareUnits& units, const std::string& name, const fs::path& path,
               std::optional<Address> at, const SourcePlace& written) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    throw InputError(written, fmt::format("{} is not there", path.string()));
  }
  const std::string text = read_text_file(path);
  if (text.empty()) {
    throw InputError(written, fmt::format("{} is empty", path.string()));
  }
  FlashFile file{.name = name,
                 .path = path,
                 .at = at,
                 .bytes = {text.begin(), text.end()},
                 .written = written};
  Object object;
  object.name = "_" + name;
  object.binding = Binding::global;
  object.align = 4;
  object.size = static_cast<std::uint32_t>(file.bytes.size());
  object.section = ".rodata";
  object.initial = file.bytes;
  object.written = written;
  Program program;
  program.path = path.string();
  program.source_files = {""};
  program.objects.push_back(std::move(object));
  auto unit = std::make_shared<const Program>(std::move(program));
  const auto known = std::ranges::find(units.flash, name, &FlashFile::name);
  if (known != units.flash.end()) {
    const auto old = std::ranges::find_if(units.shared, [&](const Unit& one) {
      return one->objects.size() == 1 && one->objects[0].name == "_" + name;
    });
    *old = std::move(unit);
    file.at = at ? at : known->at;
    *known = std::move(file);
    return;
  }
  units.shared.push_back(std::move(unit));
  units.flash.push_back(std::move(file));
}

Firmware bare_firmware(Program program) {
  Firmware firmware;
  firmware.units.name = fs::path(program.path).stem().string();
  firmware.units.path = program.path;
  CoreUnits& core = firmware.units.cores[0];
  core.present = true;
  if (!defines_code(program, core.entry)) {
    if (!defines_code(program, "_main")) {
      throw InputError(program.path + ": has neither a function _start nor a function _main");
    }
    core.units.push_back(std::make_shared<const Program>(parse(bare_start_text(), "(start-up)")));
  }
  core.units.push_back(std::make_shared<const Program>(std::move(program)));
  firmware.placement = default_placement();
  return firmware;
}

Firmware load_firmware(const fs::path& path) {
  if (path.extension() == ".bir" || assembler::is_assembler_file(path)) {
    return bare_firmware(load_program(path));
  }
  return load_manifest(path);
}

}  // namespace finback::ir
