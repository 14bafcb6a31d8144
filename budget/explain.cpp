#include <algorithm>
#include <map>
#include <set>

#include <budget/explain.hpp>
#include <budget/families.hpp>
#include <budget/line_changes.hpp>
#include <budget/story.hpp>
#include <budget/subject.hpp>

namespace finback::budget {

namespace {

// The key of `sums` with the largest positive value, "" when there is none.
std::string largest(const std::map<std::string, std::int64_t>& sums) {
  std::string best;
  std::int64_t most = 0;
  for (const auto& [name, sum] : sums) {
    if (sum > most) {
      most = sum;
      best = name;
    }
  }
  return best;
}

// Decides which story explains a check: the same one for all that one cause explains.
class Sorter {
 public:
  Sorter(const Material& material, bool growth, bool against)
      : material_(material),
        changes_(against ? material.since : material.costs),
        growth_(growth),
        against_(against),
        sign_(growth ? 1 : -1) {}

  [[nodiscard]] StoryKey key_of(const Check& check, const Subject& subject) const {
    const auto make = [this](Topic topic, const std::string& owner, const std::string& family) {
      return StoryKey{topic, owner, family, true, against_};
    };
    switch (subject.kind) {
      case SubjectKind::camera:
        return camera_key();
      case SubjectKind::core:
        return core_key(subject.owner);
      case SubjectKind::cause:
        return subject.name == kIdle && against_
                   ? waiting_key(subject.owner)
                   : cycles_key(subject.owner, family_of(subject.name));
      case SubjectKind::function:
        return function_key(subject.owner, subject.name);
      case SubjectKind::callees:
        return callees_key(check, subject.owner, subject.name);
      case SubjectKind::stage:
        return callees_key(check, subject.owner, stage_function(subject));
      case SubjectKind::object:
        return object_key(subject);
      case SubjectKind::level:
        return level_key(subject.name);
      case SubjectKind::region:
        return make(Topic::region, subject.owner, subject.name);
      case SubjectKind::code:
        return make(Topic::code, subject.owner, "");
      case SubjectKind::stack:
        return make(Topic::stack, subject.owner, "");
      case SubjectKind::power:
        return make(Topic::power, "", "");
      case SubjectKind::accuracy:
        break;
    }
    return make(Topic::accuracy, "", "");
  }

  // The function that a story about `subject` must name; "" for none.
  [[nodiscard]] std::string function_of(const Subject& subject) const {
    if (subject.kind == SubjectKind::stage) {
      return stage_function(subject);
    }
    const bool is_function =
        subject.kind == SubjectKind::function || subject.kind == SubjectKind::callees;
    return is_function ? subject.name : "";
  }

 private:
  [[nodiscard]] StoryKey cycles_key(const std::string& core, const std::string& family) const {
    return {Topic::cycles, core, family, growth_, against_};
  }

  // By what grew most: on the core, all causes; on which core.
  [[nodiscard]] std::string largest_family(const std::string& core) const {
    std::map<std::string, std::int64_t> sums;
    for (const FunctionChange& function : changes_.functions) {
      for (const auto& [cause, cycles] : function.causes) {
        if (function.core == core) {
          sums[family_of(cause)] += sign_ * cycles;
        }
      }
    }
    return largest(sums);
  }
  [[nodiscard]] std::string largest_core(bool idle) const {
    std::map<std::string, std::int64_t> sums;
    for (const FunctionChange& function : changes_.functions) {
      sums[function.core] += sign_ * (idle ? function.idle : function.cycles());
    }
    return largest(sums);
  }

  [[nodiscard]] StoryKey camera_key() const {
    const std::string core = largest_core(false);
    if (!core.empty()) {
      return against_ ? cycles_key(core, largest_family(core)) : cycles_key(core, "");
    }
    return cycles_key(largest_core(true), std::string(kIdle));
  }

  [[nodiscard]] StoryKey core_key(const std::string& core) const {
    std::int64_t work = 0;
    std::int64_t idle = 0;
    for (const FunctionChange& function : changes_.functions) {
      work += function.core == core ? sign_ * function.cycles() : 0;
      idle += function.core == core ? sign_ * function.idle : 0;
    }
    const std::string family = largest_family(core);
    if (family.empty() || (against_ && idle > std::max<std::int64_t>(0, work))) {
      return waiting_key(core);
    }
    return cycles_key(core, against_ ? family : "");
  }

  // A core sleeps longer because of what others do, when they do more.
  [[nodiscard]] StoryKey waiting_key(const std::string& core) const {
    const StoryKey cause = camera_key();
    return cause.family == kIdle ? cycles_key(core, std::string(kIdle)) : cause;
  }

  [[nodiscard]] const FunctionChange* find(const std::string& core, const std::string& name) const {
    const auto found =
        std::ranges::find_if(changes_.functions, [&](const FunctionChange& function) {
          return function.core == core && function.name == name;
        });
    return found == changes_.functions.end() ? nullptr : &*found;
  }

  [[nodiscard]] StoryKey function_key(const std::string& core, const std::string& name) const {
    const FunctionChange* function = find(core, name);
    if (function == nullptr || !against_) {
      return core_key(core);
    }
    if (sign_ * function->idle > std::max<std::int64_t>(0, sign_ * function->cycles())) {
      return waiting_key(core);
    }
    std::map<std::string, std::int64_t> sums;
    for (const auto& [cause, cycles] : function->causes) {
      sums[family_of(cause)] += sign_ * cycles;
    }
    const std::string family = largest(sums);
    return family.empty() ? core_key(core) : cycles_key(core, family);
  }

  // A function with all that it calls: by itself when half of the change is its own.
  [[nodiscard]] StoryKey callees_key(const Check& check, const std::string& core,
                                     const std::string& name) const {
    const FunctionChange* function = find(core, name);
    const double change = check.value - check.baseline.value_or(0);
    const double all = growth_ ? change : -change;
    const double own = function == nullptr
                           ? 0
                           : static_cast<double>(sign_ * (function->cycles() + function->idle));
    return 2 * own >= all ? function_key(core, name) : core_key(core);
  }

  [[nodiscard]] std::string stage_function(const Subject& subject) const {
    for (const report::Stage& stage : material_.now.stages) {
      if (stage.core == subject.owner && subject.name == report::metric_word(stage.name)) {
        return stage.function;
      }
    }
    return "";
  }

  // An object that cores now wait for is told with their waiting, others by their bytes.
  [[nodiscard]] StoryKey object_key(const ObjectChange& object) const {
    std::map<std::string, std::int64_t> stalls;
    for (const auto& [initiator, cycles] : object.stalls) {
      stalls[initiator] = sign_ * cycles;
    }
    const std::string core = largest(stalls);
    const std::string& level = growth_ ? object.level_after : object.level_before;
    if (against_ && !core.empty() && (level == "l2" || level == "l3")) {
      return cycles_key(core, level);
    }
    return {Topic::bytes, "", object.level_after, true, against_};
  }
  [[nodiscard]] StoryKey object_key(const Subject& subject) const {
    for (const ObjectChange& object : changes_.objects) {
      if (object.owner == subject.owner && object.name == subject.name) {
        return object_key(object);
      }
    }
    return camera_key();
  }

  [[nodiscard]] StoryKey level_key(const std::string& level) const {
    const ObjectChange* top = nullptr;
    for (const ObjectChange& object : changes_.objects) {
      const std::int64_t bytes = sign_ * bytes_change(object, level);
      if (bytes > 0 && (top == nullptr || bytes > sign_ * bytes_change(*top, level))) {
        top = &object;
      }
    }
    StoryKey by_bytes{Topic::bytes, "", level, true, against_};
    if (top == nullptr || !top->moved()) {
      return by_bytes;
    }
    StoryKey key = object_key(*top);
    return key.topic == Topic::cycles ? key : by_bytes;
  }

  const Material& material_;
  const Changes& changes_;
  bool growth_;
  bool against_;
  std::int64_t sign_;
};

// Frames a second fall when cycles grow.
bool by_growth(const Check& check) {
  const bool grew = check.value > check.baseline.value_or(0);
  return check.metric == "frames_per_second" ? !grew : grew;
}

// Whether the change from the baseline is towards what the limit forbids: one that is broken all
// the same is not explained by what became better.
bool by_change(const Check& check) {
  if (!check.baseline || check.value == *check.baseline) {
    return false;
  }
  const Relation relation = check.limit->demand.relation;
  return relation == Relation::equal ||
         (relation == Relation::at_most) == (check.value > *check.baseline);
}

struct Group {
  StoryKey key;
  std::vector<std::size_t> checks;
  std::set<std::string> subjects;
};

}  // namespace

std::vector<Explanation> explain(const std::vector<Check>& checks, const report::RunResult& now,
                                 const report::RunResult* baseline) {
  const Material material(now, baseline);
  std::vector<Group> groups;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const Subject subject = subject_of(checks[i].metric);
    const bool against = by_change(checks[i]);
    const Sorter sorter(material, !against || by_growth(checks[i]), against);
    const StoryKey key = sorter.key_of(checks[i], subject);
    auto group = std::ranges::find(groups, key, &Group::key);
    if (group == groups.end()) {
      group = groups.insert(groups.end(), {key, {}, {}});
    }
    group->checks.push_back(i);
    if (const std::string function = sorter.function_of(subject); !function.empty()) {
      group->subjects.insert(function);
    }
  }
  std::vector<Explanation> explanations;
  for (const Group& group : groups) {
    explanations.push_back(tell(group.key, material, group.subjects));
    explanations.back().checks = group.checks;
  }
  return explanations;
}

}  // namespace finback::budget
