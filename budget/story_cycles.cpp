#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <budget/families.hpp>
#include <budget/line_changes.hpp>
#include <budget/numbers.hpp>
#include <budget/story_cycles.hpp>

namespace finback::budget {

namespace {

// Functions that limits are about are told, too, up to so many.
constexpr std::size_t kMostTold = 8;

// A change with its sign, or without a baseline a plain count.
std::string amount_text(std::int64_t amount, const StoryKey& key) {
  return key.against ? signed_text(amount) : number_text(static_cast<double>(amount));
}

// "l3_read +12,300,000, issue +1,000": the largest first.
std::string causes_text(const CauseChanges& changes, const StoryKey& key) {
  std::vector<std::pair<std::string, std::int64_t>> causes(changes.begin(), changes.end());
  std::ranges::stable_sort(causes, [](const auto& left, const auto& right) {
    return std::abs(left.second) > std::abs(right.second);
  });
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(causes.size(), kTold); ++i) {
    texts.push_back(fmt::format("{} {}", causes[i].first, amount_text(causes[i].second, key)));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::int64_t change_of(const LineChange& line, std::string_view family) {
  std::int64_t cycles = 0;
  for (const auto& [cause, amount] : line.causes) {
    cycles += family.empty() || family_of(cause) == family ? amount : 0;
  }
  return cycles;
}

class CyclesTeller {
 public:
  CyclesTeller(const StoryKey& key, const Material& material, const std::set<std::string>& subjects)
      : key_(key), material_(material), changes_(material.of(key)) {
    select_functions(subjects);
  }

  Explanation take() {
    add_headline();
    for (const FunctionChange* function : told_) {
      add_function(*function);
    }
    if (left_out_ > 0) {
      detail("", fmt::format("{} more function{} {} cycles", left_out_, left_out_ == 1 ? "" : "s",
                             amount_text(left_out_cycles_, key_)));
    }
    add_gone();
    add_objects();
    return std::move(explanation_);
  }

 private:
  [[nodiscard]] std::int64_t amount(const FunctionChange& function) const {
    return budget::change_of(function, key_.family);
  }

  // The largest, and of the others those that limits are about.
  void select_functions(const std::set<std::string>& subjects) {
    std::vector<const FunctionChange*> grown;
    for (const FunctionChange& function : changes_.functions) {
      if (function.core == key_.owner && key_.sign() * amount(function) > 0 && !function.is_gone) {
        grown.push_back(&function);
        total_ += amount(function);
      }
    }
    std::ranges::stable_sort(grown, [this](const auto* left, const auto* right) {
      return std::abs(amount(*left)) > std::abs(amount(*right));
    });
    for (std::size_t i = 0; i < grown.size(); ++i) {
      if (i < kTold || (told_.size() < kMostTold && subjects.contains(grown[i]->name))) {
        told_.push_back(grown[i]);
      } else {
        ++left_out_;
        left_out_cycles_ += amount(*grown[i]);
      }
    }
  }

  void detail(std::string_view indent, const std::string& text) {
    explanation_.details.push_back(std::string(indent) + text);
  }

  void add_headline() {
    if (key_.against) {
      explanation_.headline =
          fmt::format("{}: {}, {} cycles", key_.owner, family_text(key_.family, key_.growth),
                      signed_text(total_));
    } else {
      explanation_.headline =
          fmt::format("{}: {}what costs most now", key_.owner,
                      material_.baseline == nullptr ? "" : "no worse than the baseline; ");
    }
  }

  void add_function(const FunctionChange& f) {
    std::string text = fmt::format("{} ", f.name);
    if (key_.family == kIdle) {
      text += fmt::format("{} cycles asleep", amount_text(f.idle, key_));
    } else if (key_.against) {
      text += fmt::format(
          "{} cycles ({}): {}", signed_text(f.cycles()),
          f.is_new ? "new"
                   : percent_text(static_cast<double>(f.before), static_cast<double>(f.after)),
          causes_text(f.causes, key_));
    } else {
      text += fmt::format("{} cycles: {}", number_text(static_cast<double>(f.after)),
                          causes_text(f.causes, key_));
    }
    if (key_.against && !f.is_new && f.calls_before != f.calls_after) {
      text += fmt::format("; calls {} -> {}", number_text(static_cast<double>(f.calls_before)),
                          number_text(static_cast<double>(f.calls_after)));
    }
    detail("", text);
    if (key_.family != kIdle) {
      add_lines(f);
    }
  }

  void add_lines(const FunctionChange& function) {
    std::vector<const LineChange*> lines;
    for (const LineChange& line : function.lines) {
      if (!line.file.empty() && key_.sign() * change_of(line, key_.family) > 0) {
        lines.push_back(&line);
      }
    }
    std::ranges::stable_sort(lines, [this](const auto* left, const auto* right) {
      return std::abs(change_of(*left, key_.family)) > std::abs(change_of(*right, key_.family));
    });
    for (std::size_t i = 0; i < std::min(lines.size(), kTold); ++i) {
      const LineChange& line = *lines[i];
      detail("  ", fmt::format("{}:{} {} cycles: {}", line.file, line.line,
                               amount_text(line.cycles, key_), causes_text(line.causes, key_)));
      if (explanation_.worst.file.empty()) {
        explanation_.worst = {line.file, line.line, 0};
      }
    }
  }

  // Work of functions that are gone may be that of those that grew.
  void add_gone() {
    for (const FunctionChange& function : changes_.functions) {
      if (function.is_gone && function.core == key_.owner && function.before > 0) {
        detail("",
               fmt::format("gone: {} {} cycles", function.name, signed_text(function.cycles())));
      }
    }
  }

  [[nodiscard]] bool concerns(const ObjectChange& object) const {
    if (key_.family == "sub_bank") {
      return key_.against && object.moved() && object.level_after == "l1" &&
             (object.owner == key_.owner || object.owner == "shared");
    }
    const bool at_level = key_.family.empty() || key_.family == object.level_before ||
                          key_.family == object.level_after;
    return at_level && key_.sign() * stalls(object) > 0;
  }

  [[nodiscard]] std::int64_t stalls(const ObjectChange& object) const {
    const auto found = object.stalls.find(key_.owner);
    return found == object.stalls.end() ? 0 : found->second;
  }

  void add_objects() {
    std::vector<const ObjectChange*> objects;
    for (const ObjectChange& object : changes_.objects) {
      if (concerns(object)) {
        objects.push_back(&object);
      }
    }
    std::ranges::stable_sort(objects, [this](const auto* left, const auto* right) {
      return std::abs(stalls(*left)) > std::abs(stalls(*right));
    });
    for (std::size_t i = 0; i < std::min(objects.size(), kTold); ++i) {
      detail("", fmt::format("{}, {} stall cycles", place_text(*objects[i], key_.against),
                             amount_text(stalls(*objects[i]), key_)));
    }
  }

  const StoryKey& key_;
  const Material& material_;
  const Changes& changes_;
  Explanation explanation_;
  std::vector<const FunctionChange*> told_;
  std::int64_t total_ = 0;
  std::size_t left_out_ = 0;
  std::int64_t left_out_cycles_ = 0;
};

}  // namespace

Explanation tell_cycles(const StoryKey& key, const Material& material,
                        const std::set<std::string>& subjects) {
  return CyclesTeller(key, material, subjects).take();
}

std::string place_text(const ObjectChange& object, bool against) {
  if (!against || !object.moved()) {
    return fmt::format("{} ({})", object.name, object.region_after);
  }
  if (object.region_before.empty()) {
    return fmt::format("{}: new, in {}", object.name, object.region_after);
  }
  return fmt::format("{}: {} -> {}", object.name, object.region_before,
                     object.region_after.empty() ? "gone" : object.region_after);
}

}  // namespace finback::budget
