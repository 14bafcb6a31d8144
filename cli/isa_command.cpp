#include <fmt/format.h>

#include <cli/commands.hpp>
#include <isa_sim/isa/manual.hpp>

namespace finback::cli {

void add_isa_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "isa", "Print every instruction: syntax, length, issue slot, cycles, meaning");
  command->footer("Example:\n  finback isa | less");
  command->callback([&action] {
    action = [] {
      fmt::print("{}", isa::instructions_as_markdown());
      return static_cast<int>(kFine);
    };
  });
}

}  // namespace finback::cli
