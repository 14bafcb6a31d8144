// `finback trace`: what the cores issued, packet by packet, and why each waited.
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <tracing/writers.hpp>
#include <utility>

#include <cli/colour.hpp>
#include <cli/commands.hpp>
#include <cli/program_options.hpp>
#include <cli/progress.hpp>
#include <cli/run_options.hpp>
#include <common/error.hpp>
#include <common/file.hpp>
#include <runner/run_request.hpp>

namespace finback::cli {

namespace {

constexpr const char* kTraceExamples =
    "Examples:\n"
    "  finback trace prog.s\n"
    "  finback trace --core b --from shd_update_row --to shd_update_row\n"
    "  finback trace --from 100000 --to 101000 --konata pipeline.kanata\n"
    "Without files the firmware is traced. A place is a cycle, a function, FUNCTION:LABEL,\n"
    "FILE:LINE or 0xADDRESS. Timing is that of a run that nobody traces. More:\n"
    "docs/finback-trace.md";

struct TraceOptions {
  ProgramOptions program;  // where files are given
  runner::RunRequest firmware;
  tracing::Window window;
  std::string core;
  std::string konata;
  bool text = false;
  std::string colour = "auto";
};
constexpr std::uint64_t kDefaultLimit = 1000;

// A run with a recorder at its machine. What ended it early, if that was not the window's end.
class TracedRun {
 public:
  TracedRun(const TraceOptions& options, runner::RunInputs inputs)
      : options_(options), inputs_(std::move(inputs)) {}

  void run() {
    try {
      options_.program.files.empty() ? run_firmware() : run_program();
    } catch (const GuestFault& fault) {
      if (!recorder_) {
        throw;
      }
      fault_ = fault.what();
    }
  }
  // "": the program did nothing wrong.
  [[nodiscard]] const std::string& fault() const { return fault_; }
  [[nodiscard]] tracing::Recorder& recorder() { return *recorder_; }
  [[nodiscard]] tracing::Code& code() { return *code_; }

 private:
  void attach(machine::Machine& machine, const ir::Image& image) {
    code_.emplace(inputs_.firmware.firmware.units, image);
    recorder_.emplace(options_.window, *code_);
    recorder_->attach(machine);
  }
  [[nodiscard]] bool over(Cycles now) const { return interrupted() || recorder_->done(now); }

  void run_firmware() {
    runner::RunObserver observer;
    observer.ready = [this](machine::Machine& m, const ir::Image& image) { attach(m, image); };
    observer.cancelled = [this](Cycles now, std::uint32_t) { return over(now); };
    observer.console = [](const std::string& line) { fmt::print(stderr, "firmware: {}\n", line); };
    static_cast<void>(runner::run_firmware(inputs_, observer));
  }

  void run_program() {
    runner::ProgramRun run = options_.program.run();
    run.ready = [this](machine::Machine& m, const ir::Image& image) { attach(m, image); };
    run.limits.cancelled = [this](Cycles now) { return over(now); };
    // Standard output is the trace's.
    run.host.output = [](int, std::string_view text) { fmt::print(stderr, "{}", text); };
    static_cast<void>(runner::run_program(inputs_, std::move(run)));
  }

  const TraceOptions& options_;
  runner::RunInputs inputs_;
  std::optional<tracing::Code> code_;
  std::optional<tracing::Recorder> recorder_;
  std::string fault_;
};

runner::RunInputs inputs_of(const TraceOptions& options) {
  if (options.program.files.empty()) {
    return runner::load_inputs(options.firmware);
  }
  runner::ProgramRequest request = options.program.request();
  request.machine = options.firmware.machine;
  request.settings = options.firmware.settings;
  return runner::load_program(request);
}

int trace(const TraceOptions& options) {
  catch_interrupts();
  TracedRun traced(options, inputs_of(options));
  traced.run();
  const bool limited = traced.recorder().limited();
  const std::vector<tracing::Recorded> records = traced.recorder().take();
  if (interrupted()) {
    fmt::print(stderr, "finback: interrupted; this is what had happened by then\n");
  }
  if (!options.konata.empty() && !records.empty()) {
    write_file_whole(options.konata, tracing::to_konata(records, traced.code()));
    fmt::print("Written: {}, {} packets\n", options.konata, records.size());
  }
  if ((options.text || options.konata.empty()) && !records.empty()) {
    fmt::print("{}", tracing::to_text(records, traced.code(), style_for(options.colour)));
  }
  if (limited) {
    fmt::print(stderr, "finback: stopped at {} packets of a core; --limit 0 traces them all\n",
               options.window.limit);
  }
  if (!traced.fault().empty()) {
    fmt::print(stderr, "finback: {}\n", traced.fault());
    return kBadInput;
  }
  if (records.empty() && !interrupted()) {
    fmt::print(stderr, "finback: nothing was issued in this window\n");
    return kBadInput;
  }
  return interrupted() ? kInterrupted : kFine;
}

void add_window(CLI::App& command, TraceOptions& options) {
  constexpr const char* kShown = "What is shown";
  command.add_option("--from", options.window.from, "The place to begin at (default: the start)")
      ->type_name("PLACE")
      ->group(kShown);
  command
      .add_option("--to", options.window.to,
                  "The place to end before, once the window is open (default: the end)")
      ->type_name("PLACE")
      ->group(kShown);
  command
      .add_option("--function", options.window.function,
                  "Packets of this function only, or of those that match a pattern")
      ->type_name("NAME")
      ->group(kShown);
  command.add_option("--core", options.core, "This core only: a or b")
      ->check(CLI::IsMember({"a", "b"}))
      ->group(kShown);
  command.add_option("--limit", options.window.limit, "At most so many packets a core; 0: all")
      ->capture_default_str()
      ->group(kShown);
  command
      .add_option("--konata", options.konata,
                  "Write a log for the Konata pipeline viewer instead of text")
      ->type_name("FILE")
      ->group(kShown);
  command.add_flag("--text", options.text, "Print text (as without --konata)")->group(kShown);
}

}  // namespace

void add_trace_command(CLI::App& app, Action& action, std::vector<std::string> arguments) {
  auto options = std::make_shared<TraceOptions>();
  options->program.arguments = std::move(arguments);
  options->window.limit = kDefaultLimit;
  CLI::App* command =
      app.add_subcommand("trace", "What each core issued, cycle by cycle, and why it waited");
  command->footer(kTraceExamples);
  CLI::Option* files = add_program_files(*command, options->program);
  add_window(*command, *options);
  add_colour_option(*command, options->colour);
  add_run_options(*command, options->firmware);
  exclude_run_options(*command, *files, {"--machine", "--set"});
  for (CLI::Option* option : add_program_options(*command, options->program)) {
    option->needs(files)->group("What is run, where files are given");
  }
  command->callback([&action, options] {
    if (!options->core.empty()) {
      options->window.core = options->core == "a" ? CoreId::a : CoreId::b;
    }
    action = [options] { return trace(*options); };
  });
}

}  // namespace finback::cli
