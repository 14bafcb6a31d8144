// Links a BIR file and those units of a library that it wants into a bare program of core A, runs
// it, prints what it prints, and then its exit status and cycles. The tests' way to execute what
// finback-cc writes.
//
// Who wants what is seen in the text, so that only what is linked is parsed.
#include <algorithm>
#include <exception>
#include <fmt/core.h>
#include <list>
#include <set>
#include <string>
#include <string_view>

#include <common/file.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/machine/host_port.hpp>
#include <isa_sim/machine/machine.hpp>
#include <isa_sim/machine/machine_description.hpp>

namespace {

using namespace finback;

using Names = std::set<std::string, std::less<>>;

/// A file that is linked when something wants it.
struct Unit {
  std::string path;
  std::string text;
};

/// All words of a text that could be symbols: they begin with an underscore, as C's do.
void collect_names(std::string_view text, Names& names) {
  constexpr std::string_view kOfSymbols =
      "_.$0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  for (std::size_t at = text.find('_'); at != std::string_view::npos; at = text.find('_', at)) {
    const std::size_t end = std::min(text.find_first_not_of(kOfSymbols, at), text.size());
    names.emplace(text.substr(at, end - at));
    at = end;
  }
}

bool defines_one_of(std::string_view text, const Names& names) {
  for (const std::string_view word : {"\n.global ", "\n.weak "})
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at)) {
      at += word.size();
      if (names.contains(text.substr(at, text.find('\n', at) - at)))
        return true;
    }
  return false;
}

/// The paths of those units that the program wants, or what it wants does.
std::vector<std::string> wanted_units(const char* program, std::list<Unit> units) {
  Names names;
  std::vector<std::string> wanted;
  collect_names(read_text_file(program), names);
  for (auto unit = units.begin(); unit != units.end();) {
    if (!defines_one_of(unit->text, names)) {
      ++unit;
      continue;
    }
    wanted.push_back(unit->path);
    collect_names(unit->text, names);
    units.erase(unit);
    unit = units.begin();
  }
  std::sort(wanted.begin(), wanted.end());
  return wanted;
}

constexpr Cycles kCycleLimit = 400'000'000;
constexpr std::uint32_t kStackSize = 96 * 1024;

ir::Firmware link_together(int count, char** files) {
  ir::Firmware firmware = ir::bare_firmware(ir::load_program(files[0]));
  std::list<Unit> units;
  for (int i = 1; i < count; ++i)
    units.push_back({files[i], read_text_file(files[i])});
  for (const std::string& path : wanted_units(files[0], std::move(units)))
    firmware.units.cores[0].units.push_back(
        std::make_shared<const ir::Program>(ir::load_program(path)));
  // Some of the programs have frames that the scratchpad does not hold.
  firmware.placement.of(ir::Owner::core_a).stack_region = "l2";
  firmware.placement.of(ir::Owner::core_a).stack_size = kStackSize;
  return firmware;
}

int run(int count, char** files) {
  const ir::Firmware firmware = link_together(count, files);
  const machine::MachineDescription description;
  const ir::Image image = ir::link(firmware.units, firmware.placement, description.map);
  machine::Machine machine(description, image);
  machine.host().set_console([](const std::string& line) { fmt::print("{}\n", line); });
  const machine::StopInfo stop = machine.run({.cycles = kCycleLimit, .cancelled = {}});
  if (stop.reason != machine::Stop::exited) {
    fmt::print(stderr, "the program did not end within {} cycles\n", kCycleLimit);
    return 3;
  }
  fmt::print(stderr, "status {} cycles {}\n", stop.exit_status, stop.time);
  return static_cast<int>(stop.exit_status & 0x7f);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: bir_run program.bir [unit.bir...]\n");
    return 1;
  }
  try {
    return run(argc - 1, argv + 1);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
