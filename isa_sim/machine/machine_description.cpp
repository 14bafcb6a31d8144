#include <algorithm>
#include <array>
#include <fmt/format.h>

#include <common/error.hpp>
#include <isa_sim/machine/machine_description.hpp>

namespace finback::machine {

std::vector<const ParameterBase*> MachineDescription::parameters() const {
  const std::array<const ParameterGroup*, 8> groups = {&clock,   &pll,         &memory, &dma,
                                                       &devices, &peripherals, &camera, &core};
  std::vector<const ParameterBase*> all;
  for (const ParameterGroup* group : groups) {
    all.insert(all.end(), group->parameters().begin(), group->parameters().end());
  }
  return all;
}

std::vector<ParameterBase*> MachineDescription::parameters() {
  const std::array<ParameterGroup*, 8> groups = {&clock,   &pll,         &memory, &dma,
                                                 &devices, &peripherals, &camera, &core};
  std::vector<ParameterBase*> all;
  for (const ParameterGroup* group : groups) {
    all.insert(all.end(), group->parameters().begin(), group->parameters().end());
  }
  return all;
}

memory::MemoryMap MachineDescription::placement_map() const {
  memory::MemoryMap places = map;
  for (memory::Region& region : places.regions) {
    const bool data_cache = (region.name == "l1.data.a" && memory.cache_data_banks > 0) ||
                            (region.name == "l1.data.b" && memory.cache_data_banks > 1);
    if (data_cache || (region.name == "l1.code.cache" && memory.cache_code > 0)) {
      region.size -= region.cache_bytes;
    }
  }
  return places;
}

namespace {

template <class ParameterPointer>
ParameterPointer find_parameter(const std::vector<ParameterPointer>& all, std::string_view name) {
  std::vector<std::string> names;
  for (ParameterPointer parameter : all) {
    if (parameter->declaration().name == name) {
      return parameter;
    }
    names.emplace_back(parameter->declaration().name);
  }
  const std::string nearest = nearest_name(name, names);
  throw InputError(fmt::format("unknown machine parameter {}{}", name,
                               nearest.empty() ? "" : fmt::format(", did you mean {}", nearest)));
}

// A number as people write it: no trailing zeros, no point for whole numbers.
std::string plain(double value) { return fmt::format("{}", value); }

}  // namespace

void MachineDescription::set(std::string_view parameter, double value) {
  find_parameter(parameters(), parameter)->set(value);
}

double MachineDescription::get(std::string_view parameter) const {
  return find_parameter(parameters(), parameter)->value();
}

std::unique_ptr<MachineDescription> MachineDescription::clone() const {
  auto copy = std::make_unique<MachineDescription>();
  copy->name = name;
  copy->map = map;
  const std::vector<const ParameterBase*> from = parameters();
  const std::vector<ParameterBase*> to = copy->parameters();
  for (std::size_t i = 0; i < from.size(); ++i) {
    to[i]->set(from[i]->value());
  }
  return copy;
}

std::string parameters_as_markdown() {
  const MachineDescription description;
  std::string page =
      "# Machine parameters\n\n"
      "Every adjustable number of the machine, as `[section]` and key of a machine file\n"
      "(`memory.l2.read_cycles` is `read_cycles` under `[memory.l2]`). This page is generated "
      "from\n"
      "the declarations: `finback machine` prints it. Certainty: **V** verified in the source,\n"
      "**D** derived from verified facts, **M** from memory of the vendor's manuals, **E**\n"
      "estimate.\n\n"
      "| name | unit | default | range | certainty | source | meaning |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const ParameterBase* parameter : description.parameters()) {
    const ParameterDeclaration& d = parameter->declaration();
    page += fmt::format("| `{}` | {} | {} | {} to {} | {} | {} | {} |\n", d.name, d.unit,
                        plain(d.default_value), plain(d.minimum), plain(d.maximum), d.certainty,
                        d.source, d.meaning);
  }
  return page;
}

}  // namespace finback::machine
