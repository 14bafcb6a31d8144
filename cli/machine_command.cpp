#include <fmt/format.h>

#include <cli/commands.hpp>
#include <isa_sim/machine/machine_description.hpp>

namespace finback::cli {

void add_machine_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "machine", "Print every parameter of the machine: unit, default, range, source");
  command->footer("Example:\n  finback machine | less\nTo change some, see docs/machine-file.md.");
  command->callback([&action] {
    action = [] {
      fmt::print("{}", machine::parameters_as_markdown());
      return int{kFine};
    };
  });
}

}  // namespace finback::cli
