// Random straight-line and looped programs made from the instruction table, for differential tests.
#pragma once

#include <cstdint>
#include <string>

namespace finback::core {

// BIR text of a `_start` of about `packets` packets that ends in IDLE, with its data. Deterministic
// in `seed`. Uses every entry of the table but those that change the flow of control, the stack or
// the system, each as the seed falls.
[[nodiscard]] std::string random_program(std::uint32_t seed, int packets);

}  // namespace finback::core
