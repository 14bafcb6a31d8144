#include <algorithm>
#include <tuple>

#include <isa_sim/ir/program.hpp>

namespace finback::ir {
namespace {

bool same_packet(const Packet& one, const Packet& other) {
  return std::tie(one.slots, one.file, one.line) == std::tie(other.slots, other.file, other.line);
}

bool same_function(const Function& one, const Function& other) {
  return std::tie(one.name, one.binding, one.align, one.section, one.labels) ==
             std::tie(other.name, other.binding, other.align, other.section, other.labels) &&
         std::ranges::equal(one.packets, other.packets, same_packet);
}

bool same_object(const Object& one, const Object& other) {
  return std::tie(one.name, one.binding, one.align, one.size, one.section, one.initial,
                  one.relocations) == std::tie(other.name, other.binding, other.align, other.size,
                                               other.section, other.initial, other.relocations);
}

}  // namespace

void order_slots(Packet& packet, std::span<const isa::Instruction> table) {
  std::ranges::stable_sort(packet.slots, {}, [table](const ParsedInstruction& instruction) {
    return table[static_cast<std::size_t>(instruction.instruction)].slot;
  });
}

bool defines_code(const Program& program, std::string_view symbol) {
  const bool label = std::ranges::any_of(program.pieces, [symbol](const Piece& piece) {
    return piece.code && std::ranges::count(piece.labels, symbol, &PieceLabel::name) > 0;
  });
  return label || std::ranges::count(program.functions, symbol, &Function::name) > 0;
}

bool same_program(const Program& one, const Program& other) {
  return one.source_files == other.source_files &&
         std::ranges::equal(one.functions, other.functions, same_function) &&
         std::ranges::equal(one.objects, other.objects, same_object);
}

}  // namespace finback::ir
