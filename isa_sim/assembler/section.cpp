#include <algorithm>

#include <isa_sim/assembler/section.hpp>

namespace finback::assembler {

void Section::number(std::int64_t value, int bytes) {
  piece_.initial.resize(piece_.size);
  for (int i = 0; i < bytes; ++i) {
    piece_.initial.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  piece_.size += static_cast<std::uint32_t>(bytes);
}

void Section::patch(std::uint32_t offset, std::int64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) {
    piece_.initial[offset + static_cast<std::uint32_t>(i)] =
        static_cast<std::uint8_t>(value >> (8 * i));
  }
}

void Section::fill(std::uint32_t count, std::uint8_t value) {
  if (value != 0) {
    piece_.initial.resize(piece_.size);
    piece_.initial.resize(std::size_t{piece_.size} + count, value);
  }
  piece_.size += count;
}

std::size_t Section::packet(ir::Packet packet, std::uint32_t length) {
  piece_.packets.push_back({piece_.size, std::move(packet)});
  piece_.size += length;
  code_end_ = piece_.size;
  return piece_.packets.size() - 1;
}

void Section::nops(std::uint32_t count, const isa::Syntax& syntax, const SourcePlace& written) {
  ir::Packet packet;
  packet.slots.push_back(syntax.parse("NOP"));
  packet.written = written;
  for (; count > 0; --count) {
    this->packet(packet, ir::packet_length(packet, syntax.table()));
  }
}

void Section::keep_aligned(std::uint32_t bytes) { piece_.align = std::max(piece_.align, bytes); }

std::uint32_t Section::last_packet() const {
  return piece_.packets.empty() ? piece_.size : piece_.packets.back().offset;
}

ir::Piece Section::finish() {
  std::ranges::stable_sort(piece_.labels, {}, &ir::PieceLabel::offset);
  while (!piece_.initial.empty() && piece_.initial.back() == 0) {
    piece_.initial.pop_back();
  }
  piece_.code = !piece_.packets.empty();
  return std::move(piece_);
}

}  // namespace finback::assembler
