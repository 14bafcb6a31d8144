#include <algorithm>
#include <fmt/format.h>
#include <tuple>

#include <common/parameter.hpp>
#include <common/toml_reader.hpp>

namespace finback {
namespace {

SourcePlace place_of(const std::string& file, const toml::source_region& source) {
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

}  // namespace

TomlReader::TomlReader(std::string_view text, std::string file) : file_(std::move(file)) {
  try {
    root_ = toml::parse(text, file_);
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(file_, error.source()), std::string(error.description()));
  }
}

SourcePlace TomlReader::place(const toml::node& node) const {
  return place_of(file_, node.source());
}

void TomlReader::fail(const toml::node& node, const std::string& message) const {
  throw InputError(place(node), message);
}

void TomlReader::check_keys(const toml::table& table, std::string_view where,
                            std::initializer_list<std::string_view> known) const {
  for (const auto& [key, node] : in_order(table)) {
    if (std::ranges::find(known, key) == known.end()) {
      const std::string nearest = nearest_name(key, {known.begin(), known.end()});
      fail(*node, fmt::format("unknown key '{}' in {}; {}", key, where,
                              nearest.empty() ? fmt::format("it knows {}", fmt::join(known, ", "))
                                              : fmt::format("did you mean '{}'?", nearest)));
    }
  }
}

const toml::table* TomlReader::table(const toml::table& parent, std::string_view key) const {
  const toml::node* node = parent.get(key);
  if (node != nullptr && !node->is_table()) {
    fail(*node, fmt::format("'{}' is a table: write [{}]", key, key));
  }
  return node == nullptr ? nullptr : node->as_table();
}

std::string TomlReader::string(const toml::table& parent, std::string_view key) const {
  const toml::node* node = parent.get(key);
  if (node == nullptr) {
    return "";
  }
  const auto value = node->value_exact<std::string>();
  if (!value || value->empty()) {
    fail(*node, fmt::format("'{}' is a string between quotes", key));
  }
  return *value;
}

std::vector<std::string> TomlReader::strings(const toml::node& node, std::string_view name) const {
  if (const auto one = node.value_exact<std::string>()) {
    return {*one};
  }
  std::vector<std::string> result;
  const toml::array* array = node.as_array();
  if (array != nullptr) {
    for (const toml::node& element : *array) {
      if (const auto text = element.value_exact<std::string>()) {
        result.push_back(*text);
      }
    }
  }
  if (array == nullptr || result.empty() || result.size() != array->size()) {
    fail(node, fmt::format("'{}' is a string or a list of strings", name));
  }
  return result;
}

std::vector<std::pair<std::string, const toml::node*>> TomlReader::in_order(
    const toml::table& table) {
  using Entry = std::tuple<std::uint32_t, std::uint32_t, std::string, const toml::node*>;
  std::vector<Entry> entries;
  for (const auto& [key, node] : table) {
    const toml::source_position begin = key.source().begin;
    entries.emplace_back(begin.line, begin.column, std::string(key.str()), &node);
  }
  std::ranges::sort(entries);
  std::vector<std::pair<std::string, const toml::node*>> result;
  result.reserve(entries.size());
  for (const Entry& entry : entries) {
    result.emplace_back(std::get<2>(entry), std::get<3>(entry));
  }
  return result;
}

}  // namespace finback
