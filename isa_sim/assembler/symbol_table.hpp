// The symbols of one file: labels, numbers, what stands for an expression, and what is used but
// defined elsewhere.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include <common/error.hpp>
#include <isa_sim/ir/program.hpp>

namespace finback::assembler {

struct Expression;

struct Symbol {
  enum class Kind : std::uint8_t {
    undefined,  // as yet, or for good: then another file has it
    label,
    number,
    equated,  // to an expression that is no number as yet
  };
  std::string name;
  Kind kind = Kind::undefined;
  std::size_t section = 0;   // of a label
  std::uint32_t offset = 0;  // of a label, in its section
  std::int64_t number = 0;
  std::shared_ptr<const Expression> equated;
  bool common = false;  // an object of its own (.comm)
  ir::Binding binding = ir::Binding::local;
  SourcePlace defined;  // or where it is used first
  bool used = false;
};

class SymbolTable {
 public:
  // Made when it is not there.
  [[nodiscard]] Symbol& get(std::string_view name);
  [[nodiscard]] const Symbol* find(std::string_view name) const;
  [[nodiscard]] bool is_defined(std::string_view name) const;

  // --- numbered labels ---
  // The symbol of the next label of this number, which is now to be defined.
  [[nodiscard]] Symbol& begin_numbered(std::int64_t number);
  // "1b", "1f": the last one, or the next. nullptr when there is no last one.
  [[nodiscard]] Symbol* find_numbered(std::string_view reference);
  // A symbol with a name that no file can write.
  [[nodiscard]] Symbol& unnamed();

  // In the order of the names.
  [[nodiscard]] const std::map<std::string, std::unique_ptr<Symbol>, std::less<>>& all() const {
    return symbols_;
  }

 private:
  std::map<std::string, std::unique_ptr<Symbol>, std::less<>> symbols_;
  std::map<std::int64_t, std::int64_t> numbered_;  // how many labels of a number there are
  std::int64_t unnamed_ = 0;
};

// "1b", "23f".
[[nodiscard]] bool is_numbered_reference(std::string_view name);
// Labels that are only of this file, and name nothing in reports: ".L1", numbered and unnamed ones.
[[nodiscard]] bool is_private_label(std::string_view name);

}  // namespace finback::assembler
