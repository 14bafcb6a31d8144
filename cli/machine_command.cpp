#include <fmt/format.h>

#include <cli/commands.hpp>
#include <isa_sim/machine/machine_description.hpp>
#include <power_model/power_parameters.hpp>

namespace finback::cli {

namespace {

int print_parameters() {
  fmt::print("{}", machine::parameters_as_markdown());
  fmt::print(
      "\nThe power model's, for `finback run --power FILE`:\n\n"
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

}  // namespace

void add_machine_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "machine", "Print every parameter of the machine: unit, default, range, source");
  command->footer("Example:\n  finback machine | less\nTo change some, see docs/machine-file.md.");
  command->callback([&action] { action = print_parameters; });
}

}  // namespace finback::cli
