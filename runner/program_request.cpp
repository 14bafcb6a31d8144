#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <system_error>

#include <common/error.hpp>
#include <common/file.hpp>
#include <isa_sim/assembler/assemble.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/ir/verifier.hpp>
#include <report/run_result.hpp>
#include <runner/program_request.hpp>
#include <runner/run_request.hpp>

namespace finback::runner {

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kMegabyte = 1 << 20;
constexpr std::uint32_t kUserStack = kMegabyte;
constexpr const char* kMemory = "ram";
constexpr const char* kStackMemory = "ram.stack";
constexpr const char* kFirstInstruction = "(first instruction)";

// "NAME=VALUE", with any number that C reads.
std::pair<std::string, std::int64_t> read_define(const std::string& text) {
  const std::size_t equals = text.find('=');
  std::int64_t value = 1;
  bool fine = equals != 0;
  if (equals != std::string::npos) {
    std::string_view digits = std::string_view(text).substr(equals + 1);
    const bool negative = digits.starts_with('-');
    digits.remove_prefix(negative ? 1 : 0);
    const bool hex = digits.starts_with("0x") || digits.starts_with("0X");
    digits.remove_prefix(hex ? 2 : 0);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, hex ? 16 : 10);
    fine = fine && error == std::errc() && end == digits.data() + digits.size();
    value = negative ? -value : value;
  }
  if (!fine) {
    throw InputError(fmt::format("--defsym {}: write NAME=NUMBER", text));
  }
  return {text.substr(0, equals), value};
}

ir::Program load_unit(const fs::path& path, const assembler::Options& options) {
  if (!assembler::is_assembler_file(path)) {
    return ir::load_program(path);
  }
  ir::Program program = assembler::assemble_file(path, options);
  ir::verify(program);
  return program;
}

bool defines(const std::vector<ir::Program>& units, std::string_view name) {
  return std::ranges::any_of(
      units, [name](const ir::Program& unit) { return ir::defines_code(unit, name); });
}

// The entry of a core's units, which may get a start-up or a name for their first instruction.
std::string find_entry(std::vector<ir::Program>& units, const std::string& asked,
                       std::string_view core) {
  if (!asked.empty()) {
    return asked;
  }
  for (const char* name : {"__start", "_start", "start"}) {
    if (defines(units, name)) {
      return name;
    }
  }
  if (defines(units, "_main")) {
    units.push_back(ir::parse(ir::bare_start_text(), "(start-up)"));
    return "_start";
  }
  for (ir::Program& unit : units) {
    for (ir::Piece& piece : unit.pieces) {
      if (piece.code) {
        ir::PieceLabel label;
        label.name = kFirstInstruction;
        label.offset = piece.packets.front().offset;
        piece.labels.insert(
            std::ranges::lower_bound(piece.labels, label.offset, {}, &ir::PieceLabel::offset),
            std::move(label));
        return kFirstInstruction;
      }
    }
    if (!unit.functions.empty()) {
      return unit.functions.front().name;
    }
  }
  throw InputError(fmt::format("{}: there is no instruction in {}", units.front().path,
                               units.size() == 1 ? "it" : fmt::format("any file of {}", core)));
}

ir::CoreUnits load_units(const std::vector<fs::path>& files, const assembler::Options& options,
                         const std::string& entry, std::string_view core) {
  ir::CoreUnits units;
  if (files.empty()) {
    return units;
  }
  std::vector<ir::Program> programs;
  programs.reserve(files.size() + 1);
  for (const fs::path& file : files) {
    programs.push_back(load_unit(file, options));
  }
  units.present = true;
  units.entry = find_entry(programs, entry, core);
  for (ir::Program& program : programs) {
    units.units.push_back(std::make_shared<const ir::Program>(std::move(program)));
  }
  return units;
}

// Flat memory in the place of whatever lies at its addresses; the stack at its top.
void add_flat_memory(memory::MemoryMap& map, std::uint32_t megabytes) {
  const std::uint32_t size = megabytes * kMegabyte;
  std::erase_if(map.regions, [size](const memory::Region& region) { return region.base < size; });
  memory::Region memory;
  memory.name = kMemory;
  memory.size = size - kUserStack;
  memory.core = 0;
  memory.code = memory.data = true;
  memory::Region stack = memory;
  stack.name = kStackMemory;
  stack.base = memory.size;
  stack.size = kUserStack;
  stack.code = false;
  map.regions.insert(map.regions.begin(), {memory, stack});
}

ir::Placement flat_placement() {
  ir::Placement placement = ir::default_placement();
  ir::OwnerPlacement& owner = placement.of(ir::Owner::core_a);
  owner.code.names = owner.defaults.names = {kMemory};
  owner.stack_region = kStackMemory;
  owner.stack_size = kUserStack;
  placement.of(ir::Owner::shared).defaults.names = {"l2"};
  return placement;
}

// Over all files that were named, in their order; what they include does not count.
report::Ingredient identity_of(const ProgramRequest& request) {
  std::string all;
  for (const auto* files : {&request.core_a, &request.core_b}) {
    for (const fs::path& file : *files) {
      all += file.filename().string() + '\n' + read_text_file(file);
    }
  }
  return {request.core_a.front().stem().string(), report::content_hash(all)};
}

}  // namespace

RunInputs load_program(const ProgramRequest& request) {
  if (request.environment == Environment::user && !request.core_b.empty()) {
    throw InputError("--core-b wants --environment chip: a user's program has one core");
  }
  assembler::Options options;
  options.include_folders = request.include_folders;
  options.note = request.note;
  for (const std::string& define : request.defines) {
    options.defines.push_back(read_define(define));
  }
  RunInputs loaded;
  loaded.machine = load_machine(request.machine, request.settings);
  loaded.firmware.identity = identity_of(request);
  loaded.firmware.placement = {"default", report::content_hash("")};
  ir::FirmwareUnits& units = loaded.firmware.firmware.units;
  units.path = request.core_a.front().string();
  units.name = loaded.firmware.identity.name;
  units.cores[0] = load_units(request.core_a, options, request.entry, "core A");
  units.cores[1] = load_units(request.core_b, options, "", "core B");
  loaded.firmware.firmware.placement = ir::default_placement();
  if (request.environment == Environment::user) {
    add_flat_memory(loaded.machine->map, request.memory_megabytes);
    loaded.firmware.firmware.placement = flat_placement();
  }
  loaded.ports = request.ports;
  loaded.scene.name = "none";
  return loaded;
}

}  // namespace finback::runner
