// Random programs made from the instruction table, with nested loops, branches, calls and a stack,
// for differential tests.
#pragma once

#include <cstdint>
#include <string>

namespace finback::core {

// BIR text of a `_start` of about `packets` packets that ends in IDLE, with its data. Deterministic
// in `seed`. Uses every entry of the table but those that ask the system, each as the seed falls.
[[nodiscard]] std::string random_program(std::uint32_t seed, int packets);

}  // namespace finback::core
