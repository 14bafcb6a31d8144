// `finback`: reads the command line, runs one subcommand, turns what went wrong into one line and
// an exit code.
#include <exception>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <string_view>
#include <vector>

#include <cli/commands.hpp>
#include <cli/program_options.hpp>
#include <common/error.hpp>
#include <common/parameter.hpp>

namespace {

using namespace finback::cli;

// The first option of argv[next] and on that `command` does not have, with the nearest that it has;
// "" when it has all.
std::string unknown_option(const CLI::App& command, const std::string& words, int next, int argc,
                           char** argv) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      known.push_back("--" + name);
    }
  }
  for (int i = next; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    const std::string_view word = argv[i];
    const std::string name(word.substr(0, word.find('=')));
    if (name.starts_with("--") && command.get_option_no_throw(name) == nullptr) {
      const std::string near = finback::nearest_name(name, known);
      return fmt::format("{}has no option {}{}", words.empty() ? "finback " : words, name,
                         near.empty() ? "" : fmt::format(", did you mean {}?", near));
    }
  }
  return "";
}

// What is wrong with the command line; a command or an option that does not exist gets the nearest
// that does.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error, int argc,
                          char** argv) {
  // The innermost command that was understood, and the word behind it.
  const CLI::App* innermost = &app;
  std::string words;
  int next = 1;
  while (!innermost->get_subcommands().empty()) {
    innermost = innermost->get_subcommands().front();
    words += innermost->get_name() + " ";
    ++next;
  }
  std::vector<std::string> known;
  for (const CLI::App* command : innermost->get_subcommands(nullptr)) {
    known.push_back(command->get_name());
  }
  if (known.empty() || next >= argc || argv[next][0] == '-') {
    std::string unknown = unknown_option(*innermost, words, next, argc, argv);
    if (!unknown.empty()) {
      return unknown;
    }
    return known.empty() || next == 1
               ? error.what()
               : fmt::format("{}wants one of {}", words, fmt::join(known, ", "));
  }
  const std::string near = finback::nearest_name(argv[next], known);
  return fmt::format("there is no command '{}{}', {}", words, argv[next],
                     near.empty() ? fmt::format("but {}", fmt::join(known, ", "))
                                  : fmt::format("did you mean '{}{}'?", words, near));
}

int parse_and_run(int argc, char** argv) {
  CLI::App app{
      "Finback simulates a two-core Blackfin stereo camera: where do the cycles, the bytes "
      "and the milliwatts go?"};
  app.name("finback");
  app.set_version_flag("--version", "finback " FINBACK_VERSION);
  app.require_subcommand(1);
  app.footer("finback COMMAND --help explains a command and shows an example.");
  Action action;
  add_run_command(app, action);
  add_check_command(app, action);
  add_profile_command(app, action);
  add_annotate_command(app, action);
  add_explore_command(app, action);
  const std::vector<std::string> program_arguments = take_program_arguments(argc, argv);
  add_exec_command(app, action, program_arguments);
  add_trace_command(app, action, program_arguments);
  add_link_command(app, action);
  add_machine_command(app, action);
  add_isa_command(app, action);
  add_lab_command(app, action);
  add_stereo_command(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      return app.exit(error);
    }
    fmt::print(stderr, "finback: {} (finback --help shows how)\n",
               usage_message(app, error, argc, argv));
    return kUsage;
  }
  return action();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const finback::InputError& error) {
    fmt::print(stderr, "finback: {}\n", error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    fmt::print(stderr, "finback: internal error, please report it: {}\n", error.what());
    return kBadInput;
  }
}
