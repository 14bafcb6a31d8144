// Short ways to programs, firmwares and the text of errors.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <common/error.hpp>
#include <isa_sim/ir/firmware.hpp>
#include <isa_sim/ir/parser.hpp>
#include <isa_sim/ir/verifier.hpp>

namespace finback::ir {

// What `action` complains of; "" when it does not.
template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// A file with the heading, as "a.bir"; the text begins in line 2.
inline Program program(const std::string& text, const std::string& file = "a.bir") {
  return parse(".bir 1\n" + text, file);
}

// One function `_f` around some instructions; they begin in line 4.
inline Program function(const std::string& body) {
  return program(".type _f, @function\n_f:\n" + body);
}

inline std::string parse_error(const std::string& text) {
  return error_of([&] { (void)program(text); });
}

inline Unit unit(const std::string& text, const std::string& file = "a.bir") {
  Program parsed = program(text, file);
  verify(parsed);
  return std::make_shared<const Program>(std::move(parsed));
}

// A firmware for core A of the given units, which must have `_start`.
inline FirmwareUnits core_a(std::vector<Unit> units) {
  FirmwareUnits firmware;
  firmware.name = "test";
  firmware.path = "firmware.toml";
  firmware.cores[0].present = true;
  firmware.cores[0].units = std::move(units);
  return firmware;
}

inline const char* const kStart = ".global _start\n.type _start, @function\n_start:\n";

}  // namespace finback::ir
