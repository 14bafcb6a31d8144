// Reading TOML with messages that name file and line.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <utility>
#include <vector>

#include <common/error.hpp>

namespace finback {

class TomlReader {
 public:
  // Throws InputError "file:line:column: ..." when `text` is no TOML.
  TomlReader(std::string_view text, std::string file);

  [[nodiscard]] const toml::table& root() const { return root_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] SourcePlace place(const toml::node& node) const;
  [[noreturn]] void fail(const toml::node& node, const std::string& message) const;

  // Throws at a key of `table` that is not in `known`, naming the nearest.
  void check_keys(const toml::table& table, std::string_view where,
                  std::initializer_list<std::string_view> known) const;

  // The value of `key`, which `where` calls what it belongs to; absent ones are empty or nullptr.
  [[nodiscard]] const toml::table* table(const toml::table& parent, std::string_view key) const;
  [[nodiscard]] std::string string(const toml::table& parent, std::string_view key) const;
  [[nodiscard]] std::vector<std::string> strings(const toml::node& node,
                                                 std::string_view name) const;

  // The entries of `table` in the order of the text.
  [[nodiscard]] static std::vector<std::pair<std::string, const toml::node*>> in_order(
      const toml::table& table);

 private:
  std::string file_;
  toml::table root_;
};

}  // namespace finback
