// The laws of the instruction table, one for each entry, by the entry's syntax.
#pragma once

#include <span>

#include "trial.hpp"

namespace finback::isa::laws {

struct Law {
  std::string_view syntax;
  void (*holds)(Trial&) = nullptr;
};

[[nodiscard]] std::span<const Law> memory_laws();
[[nodiscard]] std::span<const Law> move_laws();
[[nodiscard]] std::span<const Law> arithmetic_laws();
[[nodiscard]] std::span<const Law> alu_laws();
[[nodiscard]] std::span<const Law> multiply_laws();
[[nodiscard]] std::span<const Law> accumulator_laws();
[[nodiscard]] std::span<const Law> shift_laws();
[[nodiscard]] std::span<const Law> video_laws();
[[nodiscard]] std::span<const Law> control_laws();

// Laws that a pattern's text is enough for: loads and stores, comparisons,
// conditional moves, shifts.
[[nodiscard]] void (*access_law_of(std::string_view syntax))(Trial&);
[[nodiscard]] void (*move_law_of(std::string_view syntax))(Trial&);
[[nodiscard]] void (*shift_law_of(std::string_view syntax))(Trial&);

// Nothing for an entry that has none.
[[nodiscard]] void (*law_of(std::string_view syntax))(Trial&);

}  // namespace finback::isa::laws
