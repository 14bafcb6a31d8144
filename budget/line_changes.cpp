#include <algorithm>
#include <cstdlib>
#include <limits>

#include <budget/line_changes.hpp>

namespace finback::budget {

namespace {

using Lines = std::vector<const report::Line*>;
using Cost = std::int64_t;

Cost cycles_of(const report::Line& line) {
  Cost cycles = 0;
  for (const auto& [cause, part] : line.causes) {
    cycles += cause == kIdle ? 0 : static_cast<Cost>(part);
  }
  return cycles;
}

// How unlike two lines are by the packets that they issue, which say what a line does, whatever it
// waits for. Doubled, with one more for another number: of pairings that are as good, that which
// keeps the numbers is taken.
Cost pair_cost(const report::Line& before, const report::Line& after) {
  if (before.file != after.file) {
    return std::numeric_limits<Cost>::max() / 4;
  }
  return 2 * std::abs(static_cast<Cost>(after.packets) - static_cast<Cost>(before.packets)) +
         (before.line == after.line ? 0 : 1);
}

// A line without a partner.
Cost single_cost(const report::Line& line) { return 2 * static_cast<Cost>(line.packets) + 1; }

// The alignment of two lists by dynamic programming: for each of `after` its partner or nullptr.
class Alignment {
 public:
  Alignment(const Lines& before, const Lines& after)
      : before_(before), after_(after), costs_((before.size() + 1) * (after.size() + 1)) {
    for (std::size_t b = before.size() + 1; b-- > 0;) {
      for (std::size_t a = after.size() + 1; a-- > 0;) {
        at(b, a) = b == before.size() && a == after.size() ? 0 : cheapest(b, a);
      }
    }
  }

  [[nodiscard]] Lines partners() const {
    Lines partners(after_.size(), nullptr);
    std::size_t b = 0;
    std::size_t a = 0;
    while (a < after_.size()) {
      if (b < before_.size() && cost(b, a) == paired(b, a)) {
        partners[a++] = before_[b++];
      } else if (cost(b, a) == cost(b, a + 1) + single_cost(*after_[a])) {
        ++a;
      } else {
        ++b;
      }
    }
    return partners;
  }

 private:
  [[nodiscard]] Cost cost(std::size_t b, std::size_t a) const {
    return costs_[b * (after_.size() + 1) + a];
  }
  Cost& at(std::size_t b, std::size_t a) { return costs_[b * (after_.size() + 1) + a]; }
  [[nodiscard]] Cost paired(std::size_t b, std::size_t a) const {
    return cost(b + 1, a + 1) + pair_cost(*before_[b], *after_[a]);
  }
  [[nodiscard]] Cost cheapest(std::size_t b, std::size_t a) const {
    Cost best = std::numeric_limits<Cost>::max();
    if (b < before_.size()) {
      best = std::min(best, cost(b + 1, a) + single_cost(*before_[b]));
    }
    if (a < after_.size()) {
      best = std::min(best, cost(b, a + 1) + single_cost(*after_[a]));
    }
    if (b < before_.size() && a < after_.size()) {
      best = std::min(best, paired(b, a));
    }
    return best;
  }

  const Lines& before_;
  const Lines& after_;
  std::vector<Cost> costs_;  // of the tails from (b, a) on
};

}  // namespace

CauseChanges compare_causes(const report::CyclesByCause& before,
                            const report::CyclesByCause& after) {
  CauseChanges changes;
  for (const auto& [cause, cycles] : before) {
    changes[cause] -= static_cast<std::int64_t>(cycles);
  }
  for (const auto& [cause, cycles] : after) {
    changes[cause] += static_cast<std::int64_t>(cycles);
  }
  std::erase_if(changes,
                [](const auto& entry) { return entry.second == 0 || entry.first == kIdle; });
  return changes;
}

std::vector<LineChange> compare_lines(const Lines& before, const Lines& after) {
  const Lines partners = Alignment(before, after).partners();
  std::vector<LineChange> changes;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const report::Line absent;
    const report::Line& old_line = partners[i] == nullptr ? absent : *partners[i];
    LineChange row{after[i]->file, after[i]->line, cycles_of(*after[i]) - cycles_of(old_line),
                   compare_causes(old_line.causes, after[i]->causes)};
    if (!row.causes.empty()) {
      changes.push_back(std::move(row));
    }
  }
  return changes;
}

}  // namespace finback::budget
