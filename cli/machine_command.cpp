#include <fmt/format.h>
#include <memory>
#include <utility>

#include <cli/commands.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <isa_sim/machine/registers_page.hpp>
#include <power_model/power_parameters.hpp>
#include <runner/run_request.hpp>

namespace finback::cli {

namespace {

int print_power_parameters() {
  fmt::print(
      "| name | unit | default | range | certainty | source | meaning |\n"
      "|---|---|---|---|---|---|---|\n");
  const power::PowerParameters power;
  for (const ParameterBase* parameter : power.parameters()) {
    const ParameterDeclaration& d = parameter->declaration();
    fmt::print("| `{}` | {} | {} | {} to {} | {} | {} | {} |\n", d.name, d.unit, d.default_value,
               d.minimum, d.maximum, d.certainty, d.source, d.meaning);
  }
  return kFine;
}

int print_machine_parameters() {
  fmt::print("{}", machine::parameters_as_markdown());
  return kFine;
}

int print_register_page() {
  fmt::print("{}", machine::registers_as_markdown());
  return kFine;
}

std::string size_text(std::uint32_t bytes) {
  constexpr std::uint32_t kKilobyte = 1024;
  constexpr std::uint32_t kMegabyte = kKilobyte * kKilobyte;
  if (bytes % kMegabyte == 0) {
    return fmt::format("{} MB", bytes / kMegabyte);
  }
  return bytes % kKilobyte == 0 ? fmt::format("{} KB", bytes / kKilobyte)
                                : fmt::format("{} B", bytes);
}

// One machine: its map, and what is not as on the BF561.
int print_machine(const std::string& name) {
  const auto description = runner::load_machine(name, {});
  fmt::print("Machine {}\n\nMemory           core     level     base          size  holds\n",
             description->name);
  for (const memory::Region& region : description->map.regions) {
    fmt::print("  {:<14} {:<8} {:<5} {:#010x} {:>9}  {}{}{}\n", region.name,
               region.core < 0 ? "shared" : name_of(static_cast<CoreId>(region.core)),
               memory::kLevelNames[static_cast<std::size_t>(region.level)], region.base,
               size_text(region.size), region.code ? "code" : "",
               region.code && region.data ? ", " : "", region.data ? "data" : "");
  }
  fmt::print("\nParameters that differ from the BF561's\n");
  bool any = false;
  for (const ParameterBase* parameter : std::as_const(*description).parameters()) {
    const ParameterDeclaration& d = parameter->declaration();
    if (parameter->value() != d.default_value) {
      fmt::print("  {:<36} {} {} instead of {}\n", d.name, parameter->value(), d.unit,
                 d.default_value);
      any = true;
    }
  }
  fmt::print("{}", any ? "" : "  none\n");
  return kFine;
}

}  // namespace

void add_machine_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "machine", "Print a machine's memory map, or every parameter: unit, default, range, source");
  auto name = std::make_shared<std::string>();
  command->add_option(
      "machine", *name,
      "Installed machine, or machine file: its map and what differs from the BF561");
  auto power = std::make_shared<bool>(false);
  command->add_flag("--power", *power, "Print the power model's parameters instead");
  auto registers = std::make_shared<bool>(false);
  command->add_flag("--registers", *registers, "Print the device registers instead");
  command->footer(
      "Examples:\n  finback machine | less\n  finback machine half_l1\n"
      "To change some: docs/machine-file.md, docs/power.md.");
  command->callback([&action, power, registers, name] {
    if (*power) {
      action = print_power_parameters;
    } else if (*registers) {
      action = print_register_page;
    } else if (name->empty()) {
      action = print_machine_parameters;
    } else {
      action = [name] { return print_machine(*name); };
    }
  });
}

}  // namespace finback::cli
