// The manual's page of all device registers, made from the bus's own table.
#pragma once

#include <string>

namespace finback::machine {

// docs/registers.md: address, name and sizes of every register that a program can reach.
[[nodiscard]] std::string registers_as_markdown();

}  // namespace finback::machine
