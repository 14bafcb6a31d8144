#include <algorithm>
#include <fmt/format.h>

#include <isa_sim/ir/object_builder.hpp>

namespace finback::ir {

void ObjectBuilder::align(std::uint32_t bytes) {
  object_.size = (object_.size + bytes - 1) / bytes * bytes;
  object_.align = std::max(object_.align, bytes);
}

void ObjectBuilder::number(std::int64_t value, int bytes) {
  object_.initial.resize(object_.size);
  for (int i = 0; i < bytes; ++i) {
    object_.initial.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  object_.size += static_cast<std::uint32_t>(bytes);
}

void ObjectBuilder::address(std::string symbol, std::int32_t addend) {
  object_.relocations.push_back({object_.size, 4, std::move(symbol), addend, {}});
  object_.size += 4;
}

void ObjectBuilder::fill(std::uint32_t count, std::uint8_t value) {
  if (value != 0) {
    object_.initial.resize(object_.size);
    object_.initial.resize(object_.size + count, value);
  }
  object_.size += count;
}

Object ObjectBuilder::finish() {
  std::vector<std::uint8_t>& initial = object_.initial;
  while (!initial.empty() && initial.back() == 0) {
    initial.pop_back();
  }
  return std::move(object_);
}

std::string unescape_text(std::string_view text, std::string& bytes) {
  static constexpr std::string_view kLetters = "ntrbf\\\"";
  static constexpr std::string_view kValues = "\n\t\r\b\f\\\"";
  bytes.clear();
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      bytes += text[i];
      continue;
    }
    const char c = ++i < text.size() ? text[i] : '\0';
    const bool hex = c == 'x';
    if (const std::size_t letter = kLetters.find(c);
        c != '\0' && letter != std::string_view::npos) {
      bytes += kValues[letter];
    } else if (hex || (c >= '0' && c <= '7')) {
      const std::string_view digits = hex ? "0123456789abcdef" : "01234567";
      std::size_t end = hex ? i + 1 : i;
      unsigned value = 0;
      for (const std::size_t limit = end + (hex ? 2 : 3); end < text.size() && end < limit; ++end) {
        const char lower = text[end] >= 'A' && text[end] <= 'F'
                               ? static_cast<char>(text[end] + ('a' - 'A'))
                               : text[end];
        const std::size_t digit = digits.find(lower);
        if (digit == std::string_view::npos) {
          break;
        }
        value = value * static_cast<unsigned>(digits.size()) + static_cast<unsigned>(digit);
      }
      if ((hex && end == i + 1) || value > 255) {
        return "a \\ escape in this string is no byte";
      }
      bytes += static_cast<char>(value);
      i = end - 1;
    } else {
      return fmt::format("unknown escape \\{} in this string", c);
    }
  }
  return "";
}

}  // namespace finback::ir
