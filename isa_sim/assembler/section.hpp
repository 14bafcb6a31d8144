// A section while it is assembled: bytes, instructions and labels at growing offsets.
#pragma once

#include <cstdint>
#include <string>

#include <isa_sim/ir/program.hpp>
#include <isa_sim/isa/syntax.hpp>

namespace finback::assembler {

class Section {
 public:
  explicit Section(ir::Piece piece) : piece_(std::move(piece)) {}

  // In bytes, from the section's start.
  [[nodiscard]] std::uint32_t location() const { return piece_.size; }

  // The low `bytes` bytes of `value`, little end first.
  void number(std::int64_t value, int bytes);
  // Overwrites `bytes` bytes that `number` put at `offset`.
  void patch(std::uint32_t offset, std::int64_t value, int bytes);
  void fill(std::uint32_t count, std::uint8_t value);
  // Zeros behind an instruction, which are NOPs: how many of them can be run is up to the caller.
  void nops(std::uint32_t count, const isa::Syntax& syntax, const SourcePlace& written);
  [[nodiscard]] bool ends_in_code() const {
    return !piece_.packets.empty() && code_end_ == piece_.size;
  }
  // Returns its index. `length`: in bytes.
  std::size_t packet(ir::Packet packet, std::uint32_t length);
  [[nodiscard]] ir::Packet& packet_at(std::size_t index) { return piece_.packets[index].packet; }
  void relocate(ir::Relocation relocation) { piece_.relocations.push_back(std::move(relocation)); }
  void label(ir::PieceLabel label) { piece_.labels.push_back(std::move(label)); }
  // The whole section keeps this alignment.
  void keep_aligned(std::uint32_t bytes);
  // Where the last packet begins; the location when there is none.
  [[nodiscard]] std::uint32_t last_packet() const;

  // What it came to; labels by offset.
  [[nodiscard]] ir::Piece finish();

 private:
  ir::Piece piece_;
  std::uint32_t code_end_ = 0;
};

}  // namespace finback::assembler
