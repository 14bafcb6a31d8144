#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <budget/families.hpp>
#include <budget/line_changes.hpp>
#include <budget/numbers.hpp>
#include <budget/story.hpp>
#include <budget/story_cycles.hpp>

namespace finback::budget {

namespace {

std::int64_t signed_bytes(Bytes bytes) { return static_cast<std::int64_t>(bytes); }

// Lines of details, the largest first.
class Ranking {
 public:
  void add(std::int64_t amount, std::string text) {
    if (amount != 0) {
      rows_.emplace_back(std::abs(amount), std::move(text));
    }
  }
  std::vector<std::string> take() {
    std::ranges::stable_sort(rows_, [](const auto& l, const auto& r) { return l.first > r.first; });
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < std::min(rows_.size(), kTold); ++i) {
      texts.push_back(rows_[i].second);
    }
    return texts;
  }

 private:
  std::vector<std::pair<std::int64_t, std::string>> rows_;
};

std::string told(std::int64_t amount, const StoryKey& key) {
  return key.against ? signed_text(amount) : number_text(static_cast<double>(amount));
}

Explanation tell_bytes(const StoryKey& key, const Material& material) {
  Explanation e;
  std::int64_t total = 0;
  Ranking objects;
  for (const ObjectChange& object : material.of(key).objects) {
    const std::int64_t bytes = bytes_change(object, key.family);
    total += bytes;
    objects.add(bytes,
                fmt::format("{}, {} bytes", place_text(object, key.against), told(bytes, key)));
  }
  e.headline = fmt::format("traffic at {}: {} bytes", key.family, told(total, key));
  e.details = objects.take();
  return e;
}

void add_code(const StoryKey& key, const Material& material, std::string_view core,
              std::int64_t& total, Ranking& rows) {
  for (const FunctionChange& function : material.of(key).functions) {
    if (function.core == core) {
      const std::int64_t bytes =
          signed_bytes(function.code_after) - signed_bytes(function.code_before);
      total += bytes;
      rows.add(bytes, fmt::format("{} {} bytes of code", function.name, told(bytes, key)));
    }
  }
}

Explanation tell_region(const StoryKey& key, const Material& material) {
  Explanation e;
  std::int64_t total = 0;
  Ranking rows;
  for (const ObjectChange& object : material.of(key).objects) {
    if (object.owner != key.owner && key.owner != "shared") {
      continue;
    }
    const std::int64_t bytes =
        (object.region_after == key.family ? signed_bytes(object.size_after) : 0) -
        (object.region_before == key.family ? signed_bytes(object.size_before) : 0);
    total += bytes;
    rows.add(bytes, fmt::format("{}, {} bytes", place_text(object, key.against), told(bytes, key)));
  }
  if (key.family.find("code") != std::string::npos) {
    add_code(key, material, key.owner, total, rows);
  }
  e.headline = fmt::format("{} {}: {} bytes", key.owner, key.family, told(total, key));
  e.details = rows.take();
  return e;
}

Explanation tell_code(const StoryKey& key, const Material& material) {
  Explanation e;
  std::int64_t total = 0;
  Ranking rows;
  add_code(key, material, key.owner, total, rows);
  e.headline = fmt::format("{} code: {} bytes", key.owner, told(total, key));
  e.details = rows.take();
  return e;
}

Bytes stack_of(const report::RunResult& result, const std::string& core) {
  const auto found = std::ranges::find(result.cores, core, &report::Core::name);
  return found == result.cores.end() ? 0 : found->stack_used_bytes;
}

Explanation tell_stack(const StoryKey& key, const Material& material) {
  Explanation e;
  const Bytes now = stack_of(material.now, key.owner);
  if (!key.against) {
    e.headline = fmt::format("{} stack: {} bytes at its deepest", key.owner, now);
    return e;
  }
  const std::int64_t deeper =
      signed_bytes(now) - signed_bytes(stack_of(*material.baseline, key.owner));
  e.headline = fmt::format("{} stack: {} bytes at its deepest", key.owner, signed_text(deeper));
  Ranking rows;
  std::int64_t total = 0;
  add_code(key, material, key.owner, total, rows);
  e.details = rows.take();
  return e;
}

Explanation tell_power(const StoryKey& key, const Material& material) {
  Explanation e;
  std::map<std::string, double> watts;
  for (const power::PowerComponent& part : material.now.power.components) {
    watts[part.name] += part.watts;
  }
  double total = material.now.power.watts;
  if (key.against) {
    total -= material.baseline->power.watts;
    for (const power::PowerComponent& part : material.baseline->power.components) {
      watts[part.name] -= part.watts;
    }
  }
  const auto text = [&](double value) {
    return key.against ? fmt::format("{:+.4f} W", value) : fmt::format("{:.4f} W", value);
  };
  Ranking rows;
  constexpr double kNano = 1e9;  // ranks are whole numbers
  for (const auto& [name, value] : watts) {
    rows.add(static_cast<std::int64_t>(value * kNano), fmt::format("{} {}", name, text(value)));
  }
  e.headline = fmt::format("power: {}", text(total));
  e.details = rows.take();
  return e;
}

}  // namespace

Material::Material(const report::RunResult& result, const report::RunResult* compared)
    : now(result), baseline(compared), costs(compare(report::RunResult(), result)) {
  if (baseline != nullptr) {
    since = compare(*baseline, now);
  }
}

std::int64_t change_of(const FunctionChange& function, std::string_view family) {
  if (family == kIdle) {
    return function.idle;
  }
  std::int64_t cycles = 0;
  for (const auto& [cause, amount] : function.causes) {
    cycles += family.empty() || family_of(cause) == family ? amount : 0;
  }
  return cycles;
}

std::int64_t bytes_change(const ObjectChange& object, std::string_view level) {
  return (object.level_after == level ? signed_bytes(object.bytes_after) : 0) -
         (object.level_before == level ? signed_bytes(object.bytes_before) : 0);
}

Explanation tell(const StoryKey& key, const Material& material,
                 const std::set<std::string>& subjects) {
  switch (key.topic) {
    case Topic::bytes:
      return tell_bytes(key, material);
    case Topic::region:
      return tell_region(key, material);
    case Topic::code:
      return tell_code(key, material);
    case Topic::stack:
      return tell_stack(key, material);
    case Topic::power:
      return tell_power(key, material);
    case Topic::accuracy: {
      Explanation e;
      e.headline = key.against ? "the last disparity map is another than the baseline's"
                               : "the last disparity map against the scene's truth";
      return e;
    }
    case Topic::cycles:
      break;
  }
  return tell_cycles(key, material, subjects);
}

}  // namespace finback::budget
