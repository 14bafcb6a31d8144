#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>

#include <common/parameter.hpp>
#include <isa_sim/ir/layout.hpp>
#include <isa_sim/ir/linker.hpp>
#include <isa_sim/ir/symbols.hpp>
#include <isa_sim/isa/instruction.hpp>

namespace finback::ir {
namespace {

using isa::OperandKind;
using memory::MemoryMap;

// Where a packet was written: the C source by .loc, or else the BIR text itself, by its name alone,
// so that results do not tell where it lay.
struct Line {
  std::string file;
  int line = 0;
};

Line line_of(const Program& unit, const Packet& packet) {
  if (packet.file > 0) {
    return {unit.source_files[static_cast<std::size_t>(packet.file)], packet.line};
  }
  return {std::filesystem::path(unit.path).filename().string(), packet.written.line};
}

// Which half of an address `R0.L = _x` or `P0.H = _x` takes: that of the register written.
bool takes_high_half(const isa::OperandRoles& roles, const ParsedInstruction& instruction) {
  for (int i = 0; i < roles.count; ++i) {
    if (roles[i].written) {
      return isa::is_high_half(instruction.operand[static_cast<std::size_t>(i)].number);
    }
  }
  return false;
}

class Linker {
 public:
  Linker(const FirmwareUnits& firmware, std::vector<Thing> things)
      : firmware_(firmware),
        things_(std::move(things)),
        table_(isa::instruction_table()),
        symbols_(firmware, things_) {}

  Image run() {
    for (const Owner owner : {Owner::core_a, Owner::core_b}) {
      if (firmware_.cores[index_of(owner)].present) {
        emit_core(owner);
      }
    }
    emit_objects();
    check_stages();
    return std::move(image_);
  }

 private:
  using Reference = Symbols::Reference;
  using Target = Symbols::Target;

  // --- code ---

  void emit_core(Owner owner) {
    CoreImage& core = image_.cores[index_of(owner)];
    core.present = true;
    core.source_files.emplace_back();
    file_numbers_.clear();
    std::vector<const Thing*> functions;
    for (const Thing& thing : things_) {
      if (thing.owner == owner && (thing.function != nullptr || thing.piece != nullptr)) {
        functions.push_back(&thing);
      }
      if (thing.owner == owner && thing.is_stack()) {
        core.stack_top = thing.address + thing.size;
      }
    }
    std::ranges::sort(functions, {}, &Thing::address);
    for (const Thing* thing : functions) {
      if (thing->function != nullptr) {
        emit_function(core, *thing);
      } else {
        emit_piece(core, *thing);
      }
    }
    set_entry(core, owner);
  }

  void emit_function(CoreImage& core, const Thing& thing) {
    const Function& function = *thing.function;
    const std::vector<std::uint32_t>& at = symbols_.offsets(function);
    core.functions.push_back({.name = thing.name,
                              .region = thing.region->name,
                              .address = thing.address,
                              .size = thing.size,
                              .first_packet = core.packets.size(),
                              .packet_count = function.packets.size()});
    for (std::size_t i = 0; i < function.packets.size(); ++i) {
      emit_packet(core, thing, function.packets[i], thing.address + at[i], at[i + 1] - at[i]);
    }
  }

  // A packet of the function that was begun last.
  void emit_packet(CoreImage& core, const Thing& thing, const Packet& packet, Address address,
                   std::uint32_t length) {
    PlacedPacket placed;
    placed.address = address;
    placed.length = static_cast<std::uint8_t>(length);
    placed.count = static_cast<std::uint8_t>(packet.slots.size());
    placed.function = static_cast<std::uint32_t>(core.functions.size() - 1);
    const Line line = line_of(*thing.unit, packet);
    placed.file = file_number(core, line.file);
    placed.line = line.line;
    for (std::size_t slot = 0; slot < packet.slots.size(); ++slot) {
      placed.slots[slot] = link_instruction({thing, packet.written}, packet.slots[slot], address);
    }
    core.packets.push_back(placed);
  }

  // Functions and objects of a piece: one begins at each label that begins something, another
  // where instructions and bytes meet.
  void emit_piece(CoreImage& core, const Thing& thing) {
    const Piece& piece = *thing.piece;
    std::string name = thing.name;
    std::uint32_t begun = 0;  // where `name` stands
    auto label = piece.labels.begin();
    std::uint32_t end = 0;  // of the function that goes on
    for (const PiecePacket& at : piece.packets) {
      bool begins = at.offset != end || at.offset == 0;
      for (; label != piece.labels.end() && label->offset <= at.offset; ++label) {
        if (label->begins) {
          name = c_name(label->name);
          begun = label->offset;
          begins = begins || begun == at.offset;
        }
      }
      const std::uint32_t length = packet_length(at.packet, table_);
      if (begins) {
        core.functions.push_back(
            {.name = at.offset == begun ? name : fmt::format("{}+{:#x}", name, at.offset - begun),
             .region = thing.region->name,
             .address = thing.address + at.offset,
             .first_packet = core.packets.size()});
      }
      emit_packet(core, thing, at.packet, thing.address + at.offset, length);
      PlacedFunction& function = core.functions.back();
      function.size += length;
      ++function.packet_count;
      end = at.offset + length;
    }
  }

  int file_number(CoreImage& core, const std::string& name) {
    const auto [found, added] =
        file_numbers_.try_emplace(name, static_cast<int>(core.source_files.size()));
    if (added) {
      core.source_files.push_back(name);
    }
    return found->second;
  }

  PlacedInstruction link_instruction(const Reference& reference,
                                     const ParsedInstruction& instruction, Address address) {
    PlacedInstruction placed;
    placed.instruction = instruction.instruction;
    const isa::OperandRoles& roles = isa::roles_of(instruction.instruction);
    for (int i = 0; i < roles.count; ++i) {
      const auto slot = static_cast<std::size_t>(i);
      const OperandValue& value = instruction.operand[slot];
      std::int32_t& result = placed.operand[slot];
      if (value.symbol.empty()) {
        result = value.number;
        continue;
      }
      const bool goes_there = isa::is_code_address(roles[i].kind);
      const Target target = symbols_.resolve(
          {.from = reference.from, .place = reference.place, .takes_address = !goes_there},
          value.symbol);
      const Address sum = target.address + static_cast<Address>(value.number);
      if (goes_there) {
        check_branch(reference, value, target);
        check_distance(reference, roles[i].kind, value, sum - address);
        result = static_cast<std::int32_t>(sum);
      } else {
        const Address half = takes_high_half(roles, instruction) ? sum >> 16 : sum & 0xffff;
        result = roles[i].kind == OperandKind::imm16 ? static_cast<std::int16_t>(half)
                                                     : static_cast<std::int32_t>(half);
      }
    }
    return placed;
  }

  void check_branch(const Reference& reference, const OperandValue& value,
                    const Target& target) const {
    if (target.piece || (target.code && value.number == 0)) {
      return;
    }
    throw InputError(
        reference.place,
        fmt::format("{} branches to {}{}, which is no label and no function", who(reference),
                    value.symbol, value.number == 0 ? "" : fmt::format(" {:+d}", value.number)));
  }

  static std::string who(const Reference& reference) {
    return fmt::format("{} {}", reference.from.function != nullptr ? "function" : "section",
                       reference.from.name);
  }

  // Distances wrap around at 4 GB, as in the machine.
  void check_distance(const Reference& reference, OperandKind kind, const OperandValue& value,
                      Address difference) const {
    const isa::ImmediateRange range = *isa::immediate_range(kind);
    const auto distance = static_cast<std::int32_t>(difference);
    if (distance >= range.minimum && distance <= range.maximum) {
      return;
    }
    const bool loop = kind == OperandKind::loop_top || kind == OperandKind::loop_bottom;
    throw InputError(
        reference.place,
        fmt::format(
            "{}: {}{} is {} bytes away, out of the range {}..{}", who(reference),
            loop ? (kind == OperandKind::loop_top ? "the loop's top " : "the loop's bottom ") : "",
            value.symbol, distance, range.minimum, range.maximum));
  }

  void set_entry(CoreImage& core, Owner owner) const {
    const std::string& entry = firmware_.cores[index_of(owner)].entry;
    if (const auto address = symbols_.code(owner, entry)) {
      core.entry = *address;
      return;
    }
    throw InputError(fmt::format("{}: {}'s entry {} is a function of none of its units",
                                 firmware_.path, owner_name(owner), entry));
  }

  // --- data ---

  void emit_objects() {
    for (const Thing& thing : things_) {
      if (thing.piece != nullptr) {
        emit_data(thing);
        continue;
      }
      if (thing.function != nullptr) {
        continue;
      }
      std::vector<std::uint8_t> initial;
      if (thing.object != nullptr) {
        initial = thing.object->initial;
        relocate(thing, thing.object->relocations, initial);
      }
      emit_object(thing, thing.name, 0, thing.size, std::move(initial));
    }
    std::ranges::sort(image_.objects, [](const PlacedObject& one, const PlacedObject& other) {
      return std::pair(one.owner, one.address) < std::pair(other.owner, other.address);
    });
  }

  // The bytes of a piece, under the labels that begin something.
  void emit_data(const Thing& thing) {
    const Piece& piece = *thing.piece;
    std::vector<std::uint8_t> bytes = piece.initial;
    relocate(thing, piece.relocations, bytes);
    std::string name = thing.name;
    std::uint32_t begun = 0;
    std::uint32_t from = 0;  // bytes not emitted yet
    const auto emit_to = [&](std::uint32_t to) {
      if (to > from) {
        const auto byte = [&](std::uint32_t offset) {
          return bytes.begin() +
                 static_cast<std::ptrdiff_t>(std::min<std::size_t>(offset, bytes.size()));
        };
        emit_object(thing, from == begun ? name : fmt::format("{}+{:#x}", name, from - begun), from,
                    to - from, {byte(from), byte(to)});
      }
      from = std::max(from, to);
    };
    auto packet = piece.packets.begin();
    const auto emit_before = [&](std::uint32_t end) {  // and skip the instructions
      for (; packet != piece.packets.end() && packet->offset < end; ++packet) {
        emit_to(packet->offset);
        from = packet->offset + packet_length(packet->packet, table_);
      }
      emit_to(end);
    };
    for (const PieceLabel& label : piece.labels) {
      if (label.begins) {
        emit_before(label.offset);
        name = c_name(label.name);
        begun = label.offset;
      }
    }
    emit_before(piece.size);
  }

  void emit_object(const Thing& thing, std::string name, std::uint32_t offset, std::uint32_t size,
                   std::vector<std::uint8_t> initial) {
    PlacedObject placed;
    placed.name = std::move(name);
    placed.owner = thing.owner;
    placed.region = thing.region->name;
    placed.address = thing.address + offset;
    placed.size = size;
    placed.initial = std::move(initial);
    placed.flag = thing.owner == Owner::shared &&
                  std::ranges::find(firmware_.flags, placed.name) != firmware_.flags.end();
    image_.objects.push_back(std::move(placed));
  }

  void relocate(const Thing& thing, const std::vector<Relocation>& relocations,
                std::vector<std::uint8_t>& bytes) {
    for (const Relocation& relocation : relocations) {
      const SourcePlace& place = relocation.written.line > 0 ? relocation.written : thing.written;
      const Target target = symbols_.resolve({thing, place}, relocation.symbol);
      const Address value = target.address + static_cast<Address>(relocation.addend);
      const std::size_t end = std::size_t{relocation.offset} + 4;
      bytes.resize(std::max(bytes.size(), end));
      for (std::size_t i = 0; i < 4; ++i) {
        bytes[relocation.offset + i] = static_cast<std::uint8_t>(value >> (8 * i));
      }
    }
  }

  void check_stages() const {
    for (const Stage& stage : firmware_.stages) {
      const CoreImage& core = image_.cores[index_of(stage.core)];
      if (std::ranges::find(core.functions, stage.function, &PlacedFunction::name) !=
          core.functions.end()) {
        continue;
      }
      std::vector<std::string> known;
      for (const PlacedFunction& function : core.functions) {
        known.push_back(function.name);
      }
      const std::string nearest = nearest_name(stage.function, known);
      throw InputError(
          fmt::format("{}: stage \"{}\": {} has no function {}{}", firmware_.path, stage.name,
                      owner_name(stage.core), stage.function,
                      nearest.empty() ? "" : fmt::format(", did you mean {}?", nearest)));
    }
  }

  const FirmwareUnits& firmware_;
  std::vector<Thing> things_;
  std::span<const isa::Instruction> table_;
  Symbols symbols_;
  Image image_;
  std::map<std::string, int> file_numbers_;
};

}  // namespace

Image link(const FirmwareUnits& firmware, const Placement& placement, const MemoryMap& map) {
  return Linker(firmware, lay_out(firmware, placement, map)).run();
}

std::vector<RegionUse> link_report(const Image& image, const MemoryMap& map) {
  std::vector<RegionUse> report;
  for (const memory::Region& region : map.regions) {
    RegionUse use{.region = region.name, .core = region.core, .size = region.size};
    const auto add = [&](Address address, std::uint32_t size) {
      if (region.contains(address)) {
        use.used += size;
        use.end = std::max(use.end, address - region.base + size);
      }
    };
    for (const CoreImage& core : image.cores) {
      for (const PlacedFunction& function : core.functions) {
        add(function.address, function.size);
      }
    }
    for (const PlacedObject& object : image.objects) {
      add(object.address, object.size);
    }
    report.push_back(std::move(use));
  }
  return report;
}

}  // namespace finback::ir
