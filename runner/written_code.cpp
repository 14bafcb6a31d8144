#include <algorithm>
#include <stdexcept>
#include <string>

#include <runner/written_code.hpp>

namespace finback::runner {

namespace {

bool same_instructions(const ir::Function& function, const ir::PlacedFunction& placed,
                       const ir::CoreImage& image) {
  if (function.packets.size() != placed.packet_count) {
    return false;
  }
  for (std::size_t i = 0; i < placed.packet_count; ++i) {
    const ir::PlacedPacket& packet = image.packets[placed.first_packet + i];
    const auto& slots = function.packets[i].slots;
    for (std::size_t slot = 0; slot < packet.count; ++slot) {
      if (slots.size() != packet.count ||
          slots[slot].instruction != packet.slots[slot].instruction) {
        return false;
      }
    }
  }
  return true;
}

// `count` packets of a piece, as a function, from the one at `offset` on.
ir::Function part_of(const ir::Piece& piece, std::uint32_t offset, std::size_t count) {
  ir::Function function;
  const auto first = std::ranges::lower_bound(piece.packets, offset, {}, &ir::PiecePacket::offset);
  const auto left = static_cast<std::size_t>(piece.packets.end() - first);
  for (std::size_t i = 0; i < std::min(count, left); ++i) {
    const ir::PiecePacket& at = first[static_cast<std::ptrdiff_t>(i)];
    function.packets.push_back(at.packet);
    for (const ir::PieceLabel& label : piece.labels) {
      const bool written = label.name.find('#') == std::string::npos;  // in the file, as it stands
      if (written && label.offset == at.offset && at.offset != offset) {
        function.labels.emplace(label.name, i);
      }
    }
  }
  return function;
}

}  // namespace

ir::Function written_function(const std::vector<ir::Unit>& units, const ir::PlacedFunction& placed,
                              const ir::CoreImage& image) {
  // "name+0x1c": what follows bytes among the instructions of `name`.
  const std::size_t plus = placed.name.find("+0x");
  const std::string name = placed.name.substr(0, plus);
  const std::uint32_t beyond =
      plus == std::string::npos
          ? 0
          : static_cast<std::uint32_t>(std::stoul(placed.name.substr(plus + 1), nullptr, 16));
  for (const ir::Unit& unit : units) {
    for (const ir::Function& function : unit->functions) {
      if (ir::c_name(function.name) == name && same_instructions(function, placed, image)) {
        return function;
      }
    }
    for (const ir::Piece& piece : unit->pieces) {
      const auto label = std::ranges::find_if(piece.labels, [&](const ir::PieceLabel& candidate) {
        return candidate.begins && ir::c_name(candidate.name) == name;
      });
      if (label == piece.labels.end() && ir::c_name(piece.name) != name) {
        continue;
      }
      const std::uint32_t from = label == piece.labels.end() ? 0 : label->offset;
      ir::Function function = part_of(piece, from + beyond, placed.packet_count);
      if (same_instructions(function, placed, image)) {
        return function;
      }
    }
  }
  throw std::logic_error("a placed function that no unit has: " + placed.name);
}

}  // namespace finback::runner
