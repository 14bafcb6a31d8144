#include "laws.hpp"

#include <algorithm>

namespace finback::isa::laws {

void (*law_of(std::string_view syntax))(Trial&) {
  for (const auto laws :
       {memory_laws(), move_laws(), arithmetic_laws(), alu_laws(), multiply_laws(),
        accumulator_laws(), shift_laws(), video_laws(), control_laws()}) {
    const auto found = std::ranges::find(laws, syntax, &Law::syntax);
    if (found != laws.end()) {
      return found->holds;
    }
  }
  for (const auto by_text : {access_law_of, move_law_of, shift_law_of}) {
    if (void (*const law)(Trial&) = by_text(syntax); law != nullptr) {
      return law;
    }
  }
  return nullptr;
}

}  // namespace finback::isa::laws
