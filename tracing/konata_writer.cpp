#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <string_view>
#include <tracing/writers.hpp>
#include <vector>

namespace finback::tracing {

using core::Cause;
using core::TraceCost;
using core::TraceRecord;

namespace {

// hardware.md 1.1. A packet is issued when it enters AC.
constexpr std::size_t kFront = 4;
constexpr std::array<std::string_view, kFront> kFrontStages = {"IF1", "IF2", "IF3", "DEC"};
constexpr std::array<std::string_view, 5> kBackStages = {"DF1", "DF2", "EX1", "EX2", "WB"};
constexpr std::string_view kIssueStage = "AC";

bool before_issue(Cause cause) {
  return cause == Cause::fetch || cause == Cause::hazard_address || cause == Cause::hazard_ex1;
}
bool after_packet(Cause cause) {
  return cause == Cause::branch_taken || cause == Cause::branch_mispredict;
}

std::string_view name_of_cause(Cause cause) {
  return core::kCauseNames[static_cast<std::size_t>(cause)];
}

struct Stage {
  Cycles begin = 0;
  std::string_view name;
  const TraceCost* wait = nullptr;  // what it stands for
};

// Where a core's front stages were free last.
struct Front {
  std::array<Cycles, kFront> next{};  // when the next packet in a row enters each
  Cycles end = kNever;                // of the packet that it belongs to; kNever: none
};

class KonataLog {
 public:
  explicit KonataLog(Code& code) : code_(code) {}

  void add(const Recorded& recorded) {
    const TraceRecord& record = recorded.record;
    const std::size_t id = id_++;
    const bool runs =
        record.kind == TraceRecord::Kind::packet || record.kind == TraceRecord::Kind::undone;
    const std::vector<Stage> stages = runs ? stages_of(recorded) : waiting(recorded);
    Front& front = fronts_[static_cast<std::size_t>(recorded.core)];
    const Cycles first = stages.front().begin;
    event(first, fmt::format("I\t{}\t{}\t{}", id, id, static_cast<int>(recorded.core)));
    event(first, fmt::format("L\t{}\t0\t{}", id, title(recorded)));
    event(first, fmt::format("L\t{}\t1\t{}", id, details(recorded)));
    for (const Stage& stage : stages) {
      event(stage.begin, fmt::format("S\t{}\t0\t{}", id, stage.name));
      if (stage.wait != nullptr) {
        event(stage.begin,
              fmt::format("L\t{}\t2\t{}", id, describe(*stage.wait, recorded.core, code_)));
      }
    }
    const Cycles last = runs ? stages.back().begin + 1 : record.end();
    event(last,
          fmt::format("R\t{}\t{}\t{}", id, id, record.kind == TraceRecord::Kind::undone ? 1 : 0));
    front.end = runs && !leaves(record) ? record.end() : kNever;
  }

  std::string take() {
    std::ranges::stable_sort(events_, {}, &Event::at);
    const Cycles start = events_.empty() ? 0 : events_.front().at;
    std::string text = fmt::format("Kanata\t0004\nC=\t{}\n", start);
    Cycles now = start;
    for (const Event& event : events_) {
      if (event.at != now) {
        fmt::format_to(std::back_inserter(text), "C\t{}\n", event.at - now);
        now = event.at;
      }
      text += event.text;
      text += '\n';
    }
    return text;
  }

 private:
  struct Event {
    Cycles at = 0;
    std::string text;
  };

  void event(Cycles at, std::string text) { events_.push_back({at, std::move(text)}); }

  static bool leaves(const TraceRecord& record) {
    return std::ranges::any_of(record.costs,
                               [](const TraceCost& cost) { return after_packet(cost.cause); });
  }

  // In a row a packet enters each stage when the one before leaves it; after a change of flow it
  // comes through the empty front without waiting.
  std::vector<Stage> stages_of(const Recorded& recorded) {
    const TraceRecord& record = recorded.record;
    Front& front = fronts_[static_cast<std::size_t>(recorded.core)];
    const bool in_a_row = front.end == record.begin;
    std::vector<Stage> stages;
    for (std::size_t i = 0; i < kFront; ++i) {
      const Cycles straight = record.begin > kFront - i ? record.begin - (kFront - i) : 0;
      stages.push_back({in_a_row ? front.next[i] : straight, kFrontStages[i]});
    }
    Cycles at = record.begin;
    for (const TraceCost& cost : record.costs) {
      if (before_issue(cost.cause)) {
        stages.push_back({at, name_of_cause(cost.cause), &cost});
        at += cost.cycles;
      }
    }
    const Cycles issue = at;
    stages.push_back({at, kIssueStage});
    ++at;
    for (const TraceCost& cost : record.costs) {
      if (!before_issue(cost.cause) && !after_packet(cost.cause) && cost.cause != Cause::issue) {
        stages.push_back({at, name_of_cause(cost.cause), &cost});
        at += cost.cycles;
      }
    }
    for (const std::string_view name : kBackStages) {
      stages.push_back({at++, name});
    }
    for (std::size_t i = 0; i + 1 < kFront; ++i) {
      front.next[i] = stages[i + 1].begin;
    }
    front.next[kFront - 1] = issue;
    return stages;
  }

  // No packet goes through the pipeline.
  static std::vector<Stage> waiting(const Recorded& recorded) {
    const TraceRecord& record = recorded.record;
    return {
        {record.begin, core::kCauseNames[static_cast<std::size_t>(record.costs.front().cause)]}};
  }

  std::string title(const Recorded& recorded) {
    const TraceRecord& record = recorded.record;
    const std::string where = code_.where(recorded.core, record.packet);
    switch (record.kind) {
      case TraceRecord::Kind::entry:
        return where + ": (on the way into the handler)";
      case TraceRecord::Kind::sleep:
        return where + ": (asleep)";
      default:
        return where + ": " + code_.text(recorded.core, record.packet);
    }
  }

  std::string details(const Recorded& recorded) const {
    const TraceRecord& record = recorded.record;
    std::string text = fmt::format(
        "{} at cycle {}, address {:#010x}, {} cycles", name_of(recorded.core), record.begin,
        code_.packet(recorded.core, record.packet).address, record.cycles);
    if (const std::string line = code_.line(recorded.core, record.packet); !line.empty()) {
      text += ", " + line;
    }
    for (const TraceCost& cost : record.costs) {
      if (after_packet(cost.cause)) {
        text += ", then " + describe(cost, recorded.core, code_);
      }
    }
    return text;
  }

  Code& code_;
  std::size_t id_ = 0;
  std::array<Front, kCoreCount> fronts_;
  std::vector<Event> events_;
};

}  // namespace

std::string to_konata(std::span<const Recorded> records, Code& code) {
  KonataLog log(code);
  for (const Recorded& recorded : records) {
    log.add(recorded);
  }
  return log.take();
}

}  // namespace finback::tracing
