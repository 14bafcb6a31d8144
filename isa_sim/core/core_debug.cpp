// Debug instructions: what they print and how they end a program. The output's form is that of the
// GNU simulator, so that its readers need not change.
#include <fmt/format.h>

#include <isa_sim/core/core.hpp>
#include <isa_sim/core/trap.hpp>
#include <isa_sim/isa/semantics.hpp>

namespace finback::core {

using isa::Operation;
using isa::SystemAction;

void Core::debug(const Operation& operation, SystemAction action, std::uint32_t value) {
  if (action == SystemAction::emulation || wait_for_turn(operation)) {
    return;
  }
  const auto reg = static_cast<std::int32_t>(value);
  switch (action) {
    case SystemAction::assertion_failed: {
      const bool high = value != 0;
      const int number = isa::register_of(operation[0]);
      const std::uint32_t word = isa::read_any(state_, operation, number);
      halt(
          operation, 1,
          fmt::format("{} in {}: {}.{} is {:#06x}, expected {:#06x}", name_of(id_),
                      place(operation.site), isa::register_name(static_cast<isa::Register>(number)),
                      high ? 'H' : 'L', high ? word >> 16 : word & 0xFFFFU,
                      static_cast<std::uint32_t>(operation[1]) & 0xFFFFU));
    }
    case SystemAction::print_register:
      port_.print(number_, register_text(operation, reg));
      break;
    case SystemAction::print_registers:
      for (std::int32_t number = isa::R0; number < isa::CC; ++number) {
        port_.print(number_, register_text(operation, number));
      }
      break;
    case SystemAction::print_halves: {
      const std::uint32_t word = state_.reg[value];
      port_.print(number_, fmt::format("DBG : {} = ({}, {})\n",
                                       isa::register_name(static_cast<isa::Register>(value)),
                                       static_cast<std::int16_t>(word >> 16),
                                       static_cast<std::int16_t>(word)));
      break;
    }
    case SystemAction::print_character:
      port_.print(number_, std::string(1, static_cast<char>(value)));
      break;
    case SystemAction::halt:
      halt(operation, value, "");
    default:
      break;
  }
}

std::string Core::register_text(const Operation& operation, std::int32_t reg) {
  const std::string_view name = isa::register_name(static_cast<isa::Register>(reg));
  if (reg == isa::A0 || reg == isa::A1) {
    constexpr std::int64_t kBits = (std::int64_t{1} << 40) - 1;
    return fmt::format("DBG : {} = {:#x}\n", name, state_.accumulator[reg == isa::A1] & kBits);
  }
  return fmt::format("DBG : {} = {:#010x}\n", name, isa::read_any(state_, operation, reg));
}

void Core::halt(const Operation& operation, std::uint32_t status, const std::string& why) {
  port_.halt(number_, status, why, now(operation) + 1);  // its own cycle, too
  throw Trap{.kind = Trap::Kind::halted, .operation = &operation};
}

}  // namespace finback::core
