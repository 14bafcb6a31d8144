#include <charconv>
#include <fmt/format.h>

#include <isa_sim/assembler/symbol_table.hpp>

namespace finback::assembler {
namespace {

// No name can hold a '#'.
std::string numbered_name(std::int64_t number, std::int64_t count) {
  return fmt::format("{}#{}", number, count);
}

}  // namespace

Symbol& SymbolTable::get(std::string_view name) {
  auto found = symbols_.find(name);
  if (found == symbols_.end()) {
    found = symbols_.emplace(std::string(name), std::make_unique<Symbol>()).first;
    found->second->name = name;
  }
  return *found->second;
}

const Symbol* SymbolTable::find(std::string_view name) const {
  const auto found = symbols_.find(name);
  return found == symbols_.end() ? nullptr : found->second.get();
}

bool SymbolTable::is_defined(std::string_view name) const {
  const Symbol* symbol = find(name);
  return symbol != nullptr && (symbol->kind != Symbol::Kind::undefined || symbol->common);
}

Symbol& SymbolTable::begin_numbered(std::int64_t number) {
  return get(numbered_name(number, ++numbered_[number]));
}

Symbol* SymbolTable::find_numbered(std::string_view reference) {
  std::int64_t number = 0;
  std::from_chars(reference.data(), reference.data() + reference.size() - 1, number);
  const std::int64_t count = numbered_[number];
  const bool forward = (reference.back() | 0x20) == 'f';
  if (!forward && count == 0) {
    return nullptr;
  }
  return &get(numbered_name(number, forward ? count + 1 : count));
}

Symbol& SymbolTable::unnamed() { return get(fmt::format(".#{}", ++unnamed_)); }

bool is_numbered_reference(std::string_view name) {
  return name.size() > 1 && name.front() >= '0' && name.front() <= '9' &&
         ((name.back() | 0x20) == 'b' || (name.back() | 0x20) == 'f');
}

bool is_private_label(std::string_view name) {
  return name.starts_with(".L") || name.starts_with("L$L$") ||
         name.find('#') != std::string_view::npos;
}

}  // namespace finback::assembler
