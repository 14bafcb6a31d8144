#include <algorithm>
#include <fmt/format.h>
#include <tuple>

#include <budget/budget_file.hpp>
#include <common/toml_reader.hpp>

namespace finback::budget {

namespace {

// Tables within tables are names with dots.
class LimitReader {
 public:
  LimitReader(const TomlReader& reader, Budget& budget) : reader_(reader), budget_(budget) {}

  void read_table(const std::string& prefix, const toml::table& table) {
    for (const auto& [key, node] : TomlReader::in_order(table)) {
      const std::string name = prefix.empty() ? key : fmt::format("{}.{}", prefix, key);
      if (const toml::table* inner = node->as_table()) {
        read_table(name, *inner);
      } else {
        read_demands(name, *node);
      }
    }
  }

 private:
  void read_demands(const std::string& name, const toml::node& node) {
    if (const auto number = node.value<double>(); number && node.is_number()) {
      reader_.fail(node, fmt::format("{} = {} does not say which side is good: write \"<= {}\" or "
                                     "\">= {}\"",
                                     name, *number, *number, *number));
    }
    const std::vector<std::string> texts = reader_.strings(node, name);
    const toml::array* array = node.as_array();
    for (std::size_t i = 0; i < texts.size(); ++i) {
      Limit limit;
      limit.name = name;
      limit.written = reader_.place(array == nullptr ? node : *array->get(i));
      limit.demand = parse_demand(texts[i], limit.written);
      if (limit.demand.relative && budget_.baseline.empty()) {
        throw InputError(limit.written,
                         fmt::format("'{}' wants a baseline and the file names none: add "
                                     "baseline = \"FILE.json\" above [limits]",
                                     limit.text()));
      }
      budget_.limits.push_back(std::move(limit));
    }
  }

  const TomlReader& reader_;
  Budget& budget_;
};

}  // namespace

std::string Limit::text() const {
  return fmt::format("{} {} {}", name, demand.relation_text(),
                     demand.relative ? demand.origin_text() : fmt::format("{}", demand.number));
}

Budget read_budget(const TomlReader& reader) {
  const toml::table& root = reader.root();
  reader.check_keys(root, "a budgets file", {"firmware", "baseline", "sources", "run", "limits"});
  Budget budget;
  budget.file = reader.file();
  const std::filesystem::path folder = std::filesystem::path(budget.file).parent_path();
  budget.firmware = reader.string(root, "firmware");
  if (const std::string name = reader.string(root, "baseline"); !name.empty()) {
    budget.baseline = (folder / name).lexically_normal();
  }
  budget.sources = folder / reader.string(root, "sources");
  if (const toml::table* limits = reader.table(root, "limits")) {
    LimitReader(reader, budget).read_table("", *limits);
    std::ranges::stable_sort(budget.limits, [](const Limit& left, const Limit& right) {
      return std::tie(left.written.line, left.written.column) <
             std::tie(right.written.line, right.written.column);
    });
  }
  return budget;
}

}  // namespace finback::budget
