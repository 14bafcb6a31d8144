// A data object while its directives are read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <isa_sim/ir/program.hpp>

namespace finback::ir {

class ObjectBuilder {
 public:
  static constexpr std::int64_t kLargestObject = 256 << 20;  // bytes

  explicit ObjectBuilder(Object object) : object_(std::move(object)) {}

  [[nodiscard]] Object& object() { return object_; }

  // Zeros up to a multiple of `bytes`, which the whole object keeps.
  void align(std::uint32_t bytes);
  // The low `bytes` bytes of `value`, little end first.
  void number(std::int64_t value, int bytes);
  // Four bytes for an address.
  void address(std::string symbol, std::int32_t addend);
  void fill(std::uint32_t count, std::uint8_t value);

  // Zeros at the end are left out of `initial`.
  [[nodiscard]] Object finish();

 private:
  Object object_;
};

// Replaces the escapes of a string (\n \t \r \b \f \\ \" \ooo \xhh). Returns what is wrong with it,
// or "".
[[nodiscard]] std::string unescape_text(std::string_view text, std::string& bytes);

}  // namespace finback::ir
