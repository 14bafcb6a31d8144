// The manual's page of instructions, made from the table.
#pragma once

#include <string>

namespace finback::isa {

// docs/instructions.md: every entry with its length, issue slot, time and meaning.
[[nodiscard]] std::string instructions_as_markdown();

}  // namespace finback::isa
