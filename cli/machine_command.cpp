#include <fmt/format.h>
#include <memory>

#include <cli/commands.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <power_model/power_parameters.hpp>

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

}  // namespace

void add_machine_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "machine", "Print every parameter of the machine: unit, default, range, source");
  auto power = std::make_shared<bool>(false);
  command->add_flag("--power", *power, "Print the power model's parameters instead");
  command->footer(
      "Example:\n  finback machine | less\nTo change some: docs/machine-file.md, docs/power.md.");
  command->callback(
      [&action, power] { action = *power ? print_power_parameters : print_machine_parameters; });
}

}  // namespace finback::cli
