// Reads one instruction's tokens by the tree of patterns.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <isa_sim/isa/pattern_tree.hpp>

namespace finback::isa {

// An operand that does not fit, in a reading that is otherwise complete.
struct Misfit {
  std::size_t token = 0;
  OperandKind kind = OperandKind::data;
  std::string repeated;  // what operand was to be written once more; "" for others
  bool number = false;   // a number stands there
  bool near = false;     // an odd register for an even one, or the other way
};

// The first entry in table order that reads all of `tokens`; entry -1 when none does. With
// `misfits`, what one operand of each other reading would have to be is noted there.
[[nodiscard]] Reading read_tokens(const PatternTree& tree, std::span<const Token> tokens,
                                  std::vector<Misfit>* misfits);

}  // namespace finback::isa
